#include "model/effects/library/each_wheel_variants.hpp"

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using Catch::Matchers::WithinAbs;

namespace {

LinearModel quick_wheels() {
  LinearModel model;
  model.period_s = 0.02;
  model.wheel_base_m = 0.25;
  model.left = {{0.0, 0.6}, {}, {0.4}};
  model.right = {{}, {0.0, 0.5}, {0.5}};
  return model;
}

// Strong at the right wheel, and half as strong at the left one.
EffectSetting unequal(const EffectInfo& info, std::size_t variant) {
  EffectSetting setting{info.name, info.variants[variant].name, {}};
  for (const ParameterInfo& parameter : info.parameters_of(variant)) {
    const bool is_of_left = parameter.name.ends_with("_left");
    setting.parameters.push_back((is_of_left ? 0.5 : 1.0) * parameter.sizes.back());
  }
  return setting;
}

WheelPair command_to_and_fro(int k) {
  return {0.25 * std::sin(0.031 * k), 0.25 * std::sin(0.023 * k + 1.0)};
}

}  // namespace

TEST_CASE(
    "An effect with a size for each wheel does to each wheel what the effect of that size does to both") {
  int tried = 0;
  for (const EffectInfo& info : effect_library()) {
    for (std::size_t variant = 0; variant < info.variants.size(); ++variant) {
      if (!info.variants[variant].alike) continue;
      ++tried;
      const EffectSetting setting = unequal(info, variant);
      INFO(info.name << " " << setting.variant);
      ModelSimulation each(quick_wheels(), std::vector{setting});
      ModelSimulation as_left(quick_wheels(), std::vector{as_at(WheelSide::left, setting)});
      ModelSimulation as_right(quick_wheels(), std::vector{as_at(WheelSide::right, setting)});
      double differ_m_s = 0.0;
      for (int k = 0; k < 800; ++k) {
        const auto both = each.step(command_to_and_fro(k)).floor_m_s;
        const auto left = as_left.step(command_to_and_fro(k)).floor_m_s;
        const auto right = as_right.step(command_to_and_fro(k)).floor_m_s;
        REQUIRE_THAT(both.left, WithinAbs(left.left, 1e-12));
        REQUIRE_THAT(both.right, WithinAbs(right.right, 1e-12));
        differ_m_s = std::max(differ_m_s, std::abs(left.right - right.right));
      }
      CHECK(differ_m_s > 1e-3);  // or the sizes say nothing
    }
  }
  CHECK(tried >= 5);
}

TEST_CASE(
    "With one size for both wheels, an effect with a size for each is the effect whose wheels are alike") {
  for (const EffectInfo& info : effect_library()) {
    for (std::size_t alike = 0; alike < info.variants.size(); ++alike) {
      if (!info.by_wheel || info.variants[alike].alike) continue;
      EffectSetting setting{info.name, info.variants[alike].name, {}};
      for (const ParameterInfo& parameter : info.parameters_of(alike))
        setting.parameters.push_back(parameter.sizes.back());
      INFO(info.name << " " << setting.variant);
      const EffectSetting each = of_each_wheel(setting);
      REQUIRE(is_of_each_wheel(each));
      CHECK_FALSE(is_of_each_wheel(setting));
      CHECK(as_at(WheelSide::left, each).parameters == setting.parameters);
      CHECK(as_at(WheelSide::right, each).parameters == setting.parameters);
      CHECK(as_at(WheelSide::right, each).variant == setting.variant);
      ModelSimulation of_each(quick_wheels(), std::vector{each});
      ModelSimulation of_both(quick_wheels(), std::vector{setting});
      for (int k = 0; k < 400; ++k) {
        of_each.step(command_to_and_fro(k));
        of_both.step(command_to_and_fro(k));
      }
      CHECK(of_each.distance_m().left == of_both.distance_m().left);
      CHECK(of_each.observed_pose().theta_rad == of_both.observed_pose().theta_rad);
    }
  }
}
