#include "tests/benchmark/gap/gap_suite.hpp"

#include <array>
#include <span>

namespace wheelwright::test {
namespace {

constexpr std::array all_severities{Severity::small, Severity::medium, Severity::large};

constexpr std::array<const char*, 10> pairs{"dead_zone+saturation",
                                            "coulomb_friction+wheel_eccentricity",
                                            "stiction+transport_delay",
                                            "backlash+direction_gain",
                                            "gain_curve+yaw_bias",
                                            "voltage_sag+wheel_scale_mismatch",
                                            "turn_scrub+distance_scale",
                                            "gain_drift+floor_slope",
                                            "acceleration_slip+effective_track",
                                            "turn_speed_loss+caster_kick"};
constexpr std::array<const char*, 4> triples{
    "dead_zone+saturation+wheel_scale_mismatch", "coulomb_friction+voltage_sag+turn_scrub",
    "backlash+gain_curve+lever_arm", "rate_limit+yaw_bias+surface_patch"};

struct PoorCase {
  const char* name;
  Program program;
};
constexpr std::array<PoorCase, 9> poor_cases{{{"backlash", Program::forward_only},
                                              {"direction_gain", Program::forward_only},
                                              {"caster_kick", Program::forward_only},
                                              {"turn_scrub", Program::straight_only},
                                              {"effective_track", Program::straight_only},
                                              {"gain_curve", Program::one_speed},
                                              {"saturation", Program::one_speed},
                                              {"clean", Program::straight_only},
                                              {"clean", Program::one_speed}}};

class Suite {
 public:
  explicit Suite(std::uint64_t seed) : seed_(seed) {}

  void add(const std::string& name, Severity severity, Channels channels, Program program = Program::mixed) {
    GapCaseSpec spec;
    spec.name = name;
    spec.severity = severity;
    spec.channels = channels;
    spec.program = program;
    spec.seed = 1000 * seed_ + specs_.size() + 1;
    spec.seconds = 60.0 + static_cast<double>(spec.seed * 7 % 31);
    if (spec.seed % 10 == 3) spec.period_s = 0.0156;
    if (spec.seed % 10 == 7) spec.period_s = 0.05;
    specs_.push_back(spec);
  }

  void add_singles(std::span<const Severity> severities, Channels channels, bool outside) {
    for (const HiddenEffect& effect : hidden_effects()) {
      if (is_outside_library(effect) != outside) continue;
      for (const Severity severity : severities) add(std::string(effect.name), severity, channels);
    }
  }

  void add_clean(Channels channels, int count) {
    for (int i = 0; i < count; ++i) add("clean", Severity::small, channels);
  }

  void add_without_battery() {
    add("voltage_sag", Severity::large, Channels::ticks_ref);
    specs_.back().battery = false;
  }

  std::vector<GapCaseSpec> take() { return std::move(specs_); }

 private:
  std::uint64_t seed_;
  std::vector<GapCaseSpec> specs_;
};

}  // namespace

std::vector<GapCaseSpec> gap_suite(bool quick, std::uint64_t seed) {
  Suite suite(seed);
  const std::span<const Severity> severities(all_severities);
  const auto medium = severities.subspan(1, 1);
  suite.add_singles(quick ? medium : severities, Channels::ticks_ref, false);
  suite.add_clean(Channels::ticks_ref, quick ? 3 : 20);
  suite.add_clean(Channels::ticks, quick ? 1 : 8);
  suite.add_clean(Channels::ref, quick ? 1 : 6);
  suite.add_clean(Channels::ticks_ends, quick ? 1 : 6);
  suite.add_singles(severities.subspan(quick ? 2 : 1), Channels::ticks_ref, true);
  const std::size_t some = quick ? 3 : pairs.size();
  for (const char* pair : std::span(pairs).first(some))
    suite.add(pair, Severity::medium, Channels::ticks_ref);
  for (const auto& poor : std::span(poor_cases).first(quick ? 2 : poor_cases.size())) {
    suite.add(poor.name, Severity::large, Channels::ticks_ref, poor.program);
  }
  if (quick) return suite.take();

  for (const char* pair : pairs) suite.add(pair, Severity::large, Channels::ticks_ref);
  for (const char* triple : triples) suite.add(triple, Severity::large, Channels::ticks_ref);
  suite.add_without_battery();
  for (const Channels channels :
       {Channels::ticks, Channels::ref, Channels::ticks_ends, Channels::ticks_sparse}) {
    suite.add_singles(medium, channels, false);
  }
  return suite.take();
}

}  // namespace wheelwright::test
