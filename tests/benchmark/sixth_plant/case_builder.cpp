#include "tests/benchmark/sixth_plant/case_builder.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/benchmark/plants/exam.hpp"
#include "tests/benchmark/sixth_plant/carpet.hpp"
#include "tests/benchmark/sixth_plant/case_setting.hpp"
#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/visibility.hpp"

namespace plants::sixth {

namespace {

constexpr std::size_t runs_to_size_by = 3;

// How far one effect of a case shows, alone, by its size.
class Sizing {
 public:
  Sizing(const CaseSetting& setting, std::vector<Run> clean)
      : setting_(setting), ticks_(has_ticks(*setting.plan.channels)) {
    // Poses of each second show the sizes of the wheels, and little else.
    const bool by_size = setting.hides(Effect::wheel_scale_mismatch) ||
                         setting.hides(Effect::effective_track) || setting.hides(Effect::distance_scale);
    poses_ = has_poses(*setting.plan.channels) &&
             (setting.plan.channels != Channels::ticks_and_poses_each_second || by_size);
    clean.resize(runs_to_size_by);
    clean_ = residuals(clean, ticks_, poses_);
  }

  [[nodiscard]] double visible(Effect effect, double size) const {
    Hidden hidden{{}, setting_.details};
    hidden[effect] = size;
    return visibility(residuals(setting_.simulated(hidden, runs_to_size_by), ticks_, poses_), clean_);
  }

  // Between the smallest and the largest size of the effect, by a few secants in logarithms.
  [[nodiscard]] SizedEffect found(Effect effect, double wanted) const;

 private:
  const CaseSetting& setting_;
  bool ticks_;
  bool poses_;
  std::vector<double> clean_;
};

SizedEffect Sizing::found(Effect effect, double wanted) const {
  constexpr int attempts = 6;
  constexpr double near = 0.16;
  double low = std::log(entry_of(effect).smallest);
  double high = std::log(entry_of(effect).largest);
  std::optional<double> low_visible;
  std::optional<double> high_visible;
  double guess = low + 0.4 * (high - low);
  SizedEffect sized{effect, 0, 0, ""};
  for (int attempt = 0; attempt < attempts; ++attempt) {
    sized.size = std::exp(guess);
    sized.visibility = visible(effect, sized.size);
    const double seen = sized.visibility;
    if (std::abs(std::log(std::max(seen, 1e-3) / wanted)) < near) break;
    (seen < wanted ? low : high) = guess;
    (seen < wanted ? low_visible : high_visible) = std::log(seen < wanted ? std::max(seen, 0.02) : seen);
    if (low_visible && high_visible) {
      const double share = (std::log(wanted) - *low_visible) / (*high_visible - *low_visible);
      guess = low + std::clamp(share, 0.1, 0.9) * (high - low);
      continue;
    }
    // Most effects show in proportion to their size.
    guess = std::clamp(guess - std::log(std::max(0.1, seen) / wanted) * 0.9, low, high);
    if (std::abs(guess - std::log(sized.size)) < 1e-3) break;
  }
  return sized;
}

// Ratio to the noise in which an effect is to show.
double drawn_ratio(Size size, Random& random) {
  if (size == Size::small) return random.uniform(3.0, 4.2);
  if (size == Size::medium) return random.uniform(5, 7);
  return random.uniform(8, 11);
}

// What the drive cannot show has no ratio to the noise.
double untellable_size(Effect effect) {
  static const std::map<Effect, double> sizes{{Effect::backlash, 0.006},       {Effect::turn_scrub, 0.2},
                                              {Effect::effective_track, 0.08}, {Effect::saturation, 0.35},
                                              {Effect::caster_kick, 0.5},      {Effect::lever_arm, 0.05}};
  return sizes.at(effect);
}

// A delay shows by the periods that it is late.
double drawn_delay_s(Size size, double period_s, Random& random) {
  if (size == Size::small) return std::max(0.06, 2.4 * period_s) * random.uniform(1, 1.2);
  return std::max(0.15, 5.3 * period_s) * random.uniform(1, 1.3);
}

std::vector<SizedEffect> sized_effects(const CaseSetting& setting, const std::vector<Run>& clean,
                                       Random& random) {
  const PlannedCase& plan = setting.plan;
  const double ratio = drawn_ratio(plan.size, random);
  std::vector<SizedEffect> sized;
  if (plan.hidden.empty()) return sized;
  const Sizing sizing(setting, clean);
  for (const Effect effect : plan.hidden) {
    if (plan.expected == Expected::not_named)
      sized.push_back({effect, untellable_size(effect), 0, ""});
    else if (effect == Effect::transport_delay)
      sized.push_back({effect, drawn_delay_s(plan.size, setting.robot.period_s, random), 0, ""});
    else
      sized.push_back(sizing.found(effect, ratio * entry_of(effect).rarity));
    sized.back().how = entry_of(effect).how(sized.back().size, setting.robot, setting.details);
  }
  return sized;
}

}  // namespace

BuiltCase build_case(const PlannedCase& plan) {
  constexpr double battery_chance = 0.3;
  Random random = warmed_up(plan.seed);
  CaseSetting setting = drawn_setting(plan, random);
  std::vector<Run> clean;
  if (!plan.hidden.empty()) clean = setting.simulated({{}, setting.details}, runs_of_a_case);
  if (setting.hides(Effect::surface_patch)) lay_carpet(setting.details, clean, random);
  BuiltCase built{setting.plan, sized_effects(setting, clean, random), false, {}};
  built.battery = setting.hides(Effect::voltage_sag) || random.chance(battery_chance);
  Hidden hidden{{}, setting.details};
  for (const SizedEffect& sized : built.hidden) hidden[sized.effect] = sized.size;
  built.runs = setting.simulated(hidden, runs_of_a_case);
  return built;
}

}  // namespace plants::sixth
