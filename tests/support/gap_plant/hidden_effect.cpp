#include "tests/support/gap_plant/hidden_effect.hpp"

#include <algorithm>

namespace wheelwright::test {
namespace {

constexpr Needs always{};

constexpr std::array effects{
    HiddenEffect{"dead_zone",
                 {0.008, 0.02, 0.04},
                 "m/s",
                 "largest command that moves nothing",
                 {.reversals = true},
                 "stiction coulomb_friction backlash"},
    HiddenEffect{
        "saturation", {0.36, 0.28, 0.2}, "m/s", "largest speed", {.speeds = true}, "voltage_sag gain_curve"},
    HiddenEffect{"rate_limit",
                 {3.0, 1.5, 0.7},
                 "m/s^2",
                 "largest change of the drive in a second",
                 {.speeds = true},
                 "acceleration_slip asymmetric_response"},
    HiddenEffect{"command_quantization", {0.006, 0.015, 0.035}, "m/s", "step", {.speeds = true}, ""},
    HiddenEffect{"transport_delay", {0.12, 0.3, 0.6}, "s", "further delay", {.speeds = true}, ""},
    HiddenEffect{"coulomb_friction",
                 {0.005, 0.012, 0.03},
                 "m/s",
                 "speed lost without a controller",
                 {.speeds = true},
                 "dead_zone stiction"},
    HiddenEffect{"stiction",
                 {0.012, 0.03, 0.06},
                 "m/s",
                 "command that breaks away without a controller",
                 {.reversals = true},
                 "dead_zone coulomb_friction"},
    HiddenEffect{"gain_curve",
                 {0.04, 0.1, 0.2},
                 "share",
                 "change of gain over the speeds up to 0.3 m/s",
                 {.speeds = true},
                 "saturation"},
    HiddenEffect{"direction_gain",
                 {0.02, 0.05, 0.12},
                 "share",
                 "forward gain less reverse gain",
                 {.reversals = true},
                 "floor_slope"},
    HiddenEffect{"asymmetric_response",
                 {0.25, 0.5, 0.75},
                 "share",
                 "braking force that is not there",
                 {.speeds = true},
                 "rate_limit"},
    HiddenEffect{"voltage_sag",
                 {0.04, 0.1, 0.2},
                 "share",
                 "gain lost from a full to an empty battery",
                 {.battery = true},
                 "gain_drift saturation surface_patch"},
    HiddenEffect{"gain_drift", {0.03, 0.08, 0.16}, "share", "gain lost when warm", always, "voltage_sag"},
    HiddenEffect{"backlash",
                 {0.0006, 0.002, 0.005},
                 "m",
                 "motion lost in a reversal",
                 {.reversals = true},
                 "dead_zone"},
    HiddenEffect{"wheel_eccentricity",
                 {0.02, 0.05, 0.1},
                 "share",
                 "speed ripple, zero to peak",
                 {.many_poses = true},
                 ""},
    HiddenEffect{"wheel_scale_mismatch",
                 {0.004, 0.012, 0.03},
                 "share",
                 "left wheel rolls further than the right",
                 {.both = true, .turns_it = true},
                 "yaw_bias"},
    HiddenEffect{"effective_track",
                 {0.01, 0.03, 0.06},
                 "share",
                 "track above the given one",
                 {.turns = true, .both = true},
                 "turn_scrub"},
    HiddenEffect{"distance_scale",
                 {0.004, 0.012, 0.03},
                 "share",
                 "distance above the counted one",
                 {.both = true},
                 ""},
    HiddenEffect{"acceleration_slip",
                 {0.03, 0.08, 0.2},
                 "share",
                 "speed lost at 3 m/s^2",
                 {.reference = true, .speeds = true},
                 "rate_limit"},
    HiddenEffect{"turn_speed_loss",
                 {0.004, 0.012, 0.03},
                 "m/s per rad/s",
                 "speed lost for a turn rate",
                 {.turns = true, .many_poses = true},
                 ""},
    HiddenEffect{"turn_scrub",
                 {0.03, 0.08, 0.18},
                 "share",
                 "turn rate lost at 2 rad/s",
                 {.turns = true},
                 "effective_track"},
    HiddenEffect{
        "yaw_bias", {0.004, 0.012, 0.03}, "rad/s", "turn rate while driving", always, "wheel_scale_mismatch"},
    HiddenEffect{"floor_slope",
                 {0.003, 0.01, 0.025},
                 "m/s",
                 "speed lost uphill",
                 {.turns = true, .many_poses = true},
                 "direction_gain"},
    HiddenEffect{"surface_patch",
                 {0.05, 0.12, 0.3},
                 "share",
                 "speed lost inside",
                 {.many_poses = true},
                 "voltage_sag gain_drift"},
    HiddenEffect{"caster_kick",
                 {0.01, 0.03, 0.08},
                 "rad",
                 "turn after a reversal",
                 {.reversals = true, .many_poses = true, .turns_it = true},
                 ""},
    HiddenEffect{"lever_arm",
                 {0.005, 0.015, 0.05},
                 "m",
                 "distance of the measured point from the axle's middle",
                 {.reference = true, .turns = true},
                 ""},
    HiddenEffect{
        "encoder_dropout", {0.005, 0.015, 0.04}, "share", "time without counts", {.ticks = true}, ""},
    HiddenEffect{"outside_resonance",
                 {0.15, 0.3, 0.5},
                 "share",
                 "drive force through a hysteretic spring that rings",
                 {.speeds = true},
                 ""},
    HiddenEffect{
        "outside_clock_cogging", {0.03, 0.08, 0.16}, "m/s", "cogging at noon; none at midnight", always, ""},
    HiddenEffect{"outside_history_gain",
                 {0.05, 0.12, 0.25},
                 "share",
                 "gain lost after seconds of fast commands",
                 {.speeds = true},
                 ""},
    HiddenEffect{"outside_cross_talk",
                 {0.05, 0.12, 0.25},
                 "share",
                 "speed that the other wheel's command takes, in one of four quadrants",
                 {.turns = true},
                 ""},
};

constexpr std::array<std::string_view, 3> severity_names{"small", "medium", "large"};

}  // namespace

std::string_view name_of(Severity severity) {
  return severity_names.at(static_cast<std::size_t>(severity));
}

std::optional<Severity> severity_named(std::string_view name) {
  const auto* found = std::find(severity_names.begin(), severity_names.end(), name);
  if (found == severity_names.end()) return std::nullopt;
  return static_cast<Severity>(found - severity_names.begin());
}

std::span<const HiddenEffect> hidden_effects() {
  return effects;
}

const HiddenEffect* find_hidden_effect(std::string_view name) {
  const auto* found =
      std::find_if(effects.begin(), effects.end(), [name](const HiddenEffect& e) { return e.name == name; });
  return found == effects.end() ? nullptr : &*found;
}

bool is_outside_library(const HiddenEffect& effect) {
  return effect.name.starts_with("outside_");
}

std::optional<std::vector<const HiddenEffect*>> effects_of_case(std::string_view case_name) {
  std::vector<const HiddenEffect*> found;
  if (case_name == "clean") return found;
  while (true) {
    const auto plus = case_name.find('+');
    const HiddenEffect* effect = find_hidden_effect(case_name.substr(0, plus));
    if (effect == nullptr || std::find(found.begin(), found.end(), effect) != found.end())
      return std::nullopt;
    found.push_back(effect);
    if (plus == std::string_view::npos) return found;
    case_name.remove_prefix(plus + 1);
  }
}

}  // namespace wheelwright::test
