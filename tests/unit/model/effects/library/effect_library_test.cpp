// What every effect of the library promises.
#include "model/effects/library/effect_library.hpp"

#include <cmath>
#include <filesystem>

#include "config/load/model_file.hpp"
#include "model/simulation/model_simulation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;

namespace {

LinearModel small_linear_part() {
  return {ModelType::arma, 0.018, 0.258, {{0.0, 0.2}, {0.0, 0.0}, {0.8}}, {{0.0, 0.0}, {0.0, 0.2}, {0.8}}};
}

// Absent where every parameter that scales the effect can be zero; others have no size that is nothing.
std::optional<EffectSetting> absent(const EffectInfo& info, const EffectVariant& variant) {
  EffectSetting setting{info.name, variant.name, {}};
  for (const auto& parameter : parameters_of(setting)) {
    const bool takes_zero = parameter.lower <= 0.0 && parameter.upper >= 0.0;
    if (parameter.scales_effect && !takes_zero) return std::nullopt;
    const double shape = parameter.sizes.empty() ? parameter.lower : parameter.sizes.front();
    setting.parameters.push_back(parameter.scales_effect ? 0.0 : shape);
  }
  return setting;
}

void check_described(const ParameterInfo& parameter) {
  INFO(parameter.name);
  CHECK_FALSE(parameter.unit.empty());
  CHECK_FALSE(parameter.meaning.empty());
  CHECK(parameter.lower < parameter.upper);
  for (const double size : parameter.sizes) {
    CHECK(size >= parameter.lower);
    CHECK(size <= parameter.upper);
  }
}

// Forward, backward, and a turn.
WheelPair command_at(int k) {
  const double along = 0.2 * std::sin(0.02 * k);
  return {along, along + (k > 300 ? 0.05 : 0.0)};
}

}  // namespace

TEST_CASE("An effect of size zero leaves every motion as it is") {
  for (const auto& info : effect_library()) {
    for (const auto& variant : info.variants) {
      const auto setting = absent(info, variant);
      if (!setting) continue;
      INFO(info.name << " " << variant.name);
      ModelSimulation without(small_linear_part(), std::vector<EffectSetting>{});
      ModelSimulation with(small_linear_part(), std::vector{*setting});
      for (int k = 0; k < 600; ++k) {
        without.step(command_at(k), 16.0 - 0.002 * k);
        with.step(command_at(k), 16.0 - 0.002 * k);
      }
      CHECK_THAT(with.observed_pose().x_m, WithinAbs(without.observed_pose().x_m, 1e-9));
      CHECK_THAT(with.observed_pose().y_m, WithinAbs(without.observed_pose().y_m, 1e-9));
      CHECK_THAT(with.observed_pose().theta_rad, WithinAbs(without.observed_pose().theta_rad, 1e-9));
      CHECK_THAT(with.distance_m().left, WithinAbs(without.distance_m().left, 1e-9));
    }
  }
}

TEST_CASE("Every effect says what is seen, why, and in which units and bounds") {
  for (const auto& info : effect_library()) {
    INFO(info.name);
    CHECK_FALSE(info.summary.empty());
    CHECK_FALSE(info.cause.empty());
    CHECK_FALSE(info.variants.empty());
    for (const auto& variant : info.variants) {
      const auto parameters = parameters_of({info.name, variant.name, {}});
      for (const auto& parameter : parameters) check_described(parameter);
    }
  }
}

TEST_CASE("A model with every effect in it comes back from its file as it was saved") {
  RobotModel model;
  model.linear_part = small_linear_part();
  for (const auto& info : effect_library()) {
    AddedEffect added;
    added.setting = {info.name, info.variants.back().name, {}};
    for (const auto& parameter : parameters_of(added.setting)) {
      added.setting.parameters.push_back(parameter.lower + 0.3 * (parameter.upper - parameter.lower));
      added.intervals.push_back({parameter.lower, parameter.upper});
    }
    added.source = {"run 1.csv"};
    added.created = "2026-01-02T03:04:05Z";
    added.heldout_gain_nats = 1.0 / 3.0;
    added.p_value = 1e-300;
    model.effects.push_back(added);
  }
  const auto path = test::temporary_folder() / "every_effect.yaml";
  config::save_model(model, path);
  const RobotModel back = config::load_model(path);
  REQUIRE(back.effects.size() == model.effects.size());
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    const AddedEffect& saved = model.effects[i];
    const AddedEffect& loaded = back.effects[i];
    INFO(saved.setting.name);
    CHECK(loaded.setting.name == saved.setting.name);
    CHECK(loaded.setting.parameters == saved.setting.parameters);
    CHECK(variant_index(*find_effect(loaded.setting.name), loaded.setting.variant) ==
          variant_index(*find_effect(saved.setting.name), saved.setting.variant));
    CHECK(loaded.intervals.size() == saved.intervals.size());
    CHECK(loaded.heldout_gain_nats == saved.heldout_gain_nats);
    CHECK(loaded.p_value == saved.p_value);
  }
}
