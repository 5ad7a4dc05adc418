#include "model/gap/data_checks/wrong_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "model/gap/data_checks/gain_over_windows.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

// Of the reference for the wheels.
struct ReferenceGains {
  GainOf turned;
  GainOf along;     // in the direction of the heading
  GainOf mirrored;  // in that of the heading's mirror image
  GainOf left;      // of the place where each wheel stands, for what it counted
  GainOf right;
};

// Windows of half a second or more, from reference to reference. More than a quarter of a turn in one could
// as well be a turn the other way.
ReferenceGains reference_gains(const GateState& gate) {
  constexpr double longest_turn_rad = 1.5;
  const DriveLog& log = gate.result.log;
  const auto& samples = log.samples;
  const bool heading_alone = !log.has_reference_positions();
  ReferenceGains gains;
  std::optional<std::size_t> from;
  WheelPair rolled_m{0.0, 0.0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    if (gate.result.flags.restart[i] != 0 || gate.result.flags.counts[i] != 0) from.reset();
    if (from && i > 0) {
      const double duration = samples[i].t_s - samples[i - 1].t_s;
      double left = samples[i - 1].command_m_s.left * duration;
      double right = samples[i - 1].command_m_s.right * duration;
      if (log.has_ticks() && sample.ticks && samples[i - 1].ticks) {
        left = gate.travel(i, true) - gate.travel(i - 1, true);
        right = gate.travel(i, false) - gate.travel(i - 1, false);
      }
      rolled_m.left += left;
      rolled_m.right += right;
    }
    if (heading_alone ? !sample.reference_theta_rad : !sample.reference_pose()) continue;
    if (from && sample.t_s - samples[*from].t_s < gain_window_s) continue;
    const double turn = (rolled_m.right - rolled_m.left) / log.wheel_base_m;
    if (from && std::abs(turn) < longest_turn_rad) {
      const auto& before = samples[*from];
      const double turned = wrap_angle(*sample.reference_theta_rad - *before.reference_theta_rad);
      gains.turned.add(turn, turned);
      if (!heading_alone) {
        const double middle = *before.reference_theta_rad + 0.5 * turned;
        const double dx = *sample.reference_x_m - *before.reference_x_m;
        const double dy = *sample.reference_y_m - *before.reference_y_m;
        const double forward = 0.5 * (rolled_m.left + rolled_m.right);
        const double along = dx * std::cos(middle) + dy * std::sin(middle);
        gains.along.add(forward, along);
        gains.left.add(rolled_m.left, along - 0.5 * log.wheel_base_m * turned);
        gains.right.add(rolled_m.right, along + 0.5 * log.wheel_base_m * turned);
        gains.mirrored.add(forward, dx * std::cos(middle) - dy * std::sin(middle));
      }
    }
    from = i;
    rolled_m = {0.0, 0.0};
  }
  return gains;
}

// The unit in which a reference goes about `gain` times as far as its wheels in metres; empty where none
// does.
std::string unit_of(double gain) {
  struct Unit {
    const char* name;
    double per_metre;
    double tolerance;
  };
  constexpr std::array units{Unit{"mm", 1000.0, 1.35}, Unit{"cm", 100.0, 1.35}, Unit{"inches", 39.37, 1.06},
                             Unit{"feet", 3.281, 1.06}};
  for (const Unit& unit : units)
    if (std::abs(std::log(std::abs(gain) / unit.per_metre)) < std::log(unit.tolerance)) return unit.name;
  return "";
}

// Beyond what a robot does: tracks turn half as far as they roll, and no tyre is half as large again as
// stated.
constexpr double least_turned = 0.4;
constexpr double least_moved = 0.6;
constexpr double most_of_counts = 1.6;

// A number that everybody gives by hand: what it is, by the reference.
std::optional<std::string> wrong_scale(const DriveLog& log, const ReferenceGains& gains) {
  const auto is_off = [](const GainOf& gain, double least) {
    return (gain.surely_above(0.0) && gain.surely_below(least)) || gain.surely_above(most_of_counts);
  };
  const bool left = is_off(gains.left, least_moved);
  const bool right = is_off(gains.right, least_moved);
  if (left != right && !is_off(left ? gains.right : gains.left, 0.8)) {
    const GainOf& gain = left ? gains.left : gains.right;
    return std::string(left ? "the left" : "the right") + " wheel rolls " + in_digits(gain.gain(), 3) +
           " times as far as its counts say: metres_per_tick of that wheel is about " +
           in_digits(gain.gain() * (left ? log.metres_per_tick->left : log.metres_per_tick->right), 3);
  }
  if (is_off(gains.along, least_moved))
    return "the reference moves " + in_digits(gains.along.gain(), 3) +
           " times as far as the counts say: metres_per_tick is about " +
           in_digits(gains.along.gain() * log.metres_per_tick->left, 3) +
           ", or the reference is in another unit";
  if (is_off(gains.turned, least_turned))
    return "the reference turns " + in_digits(gains.turned.gain(), 3) +
           " times as far as the counts say with a wheel base of " + in_digits(log.wheel_base_m, 3) +
           " m: one of " + in_digits(log.wheel_base_m / gains.turned.gain(), 3) + " m would agree";
  return std::nullopt;
}

bool is_in_another_unit(const GainOf& along) {
  if (along.surely_above(gain_of_a_wrong_unit) || along.surely_below(-gain_of_a_wrong_unit)) return true;
  return along.surely_above(1.5) && !unit_of(along.gain()).empty();
}

}  // namespace

void check_reference(GateState& gate) {
  const ReferenceGains gains = reference_gains(gate);
  if (is_in_another_unit(gains.along)) {
    const std::string unit = unit_of(gains.along.gain());
    gate.fault(0,
               "the reference moves " + in_digits(gains.along.gain(), 3) + " times as far as the wheels: " +
                   (unit.empty() ? "what is its unit?" : "is it in " + unit + "?") + " the format wants m",
               true);
  } else if (gains.along.surely_below(gain_of_a_wrong_sign)) {
    gate.fault(0,
               "the reference moves backward where the wheels roll forward: its heading is turned by half a "
               "turn, or the commands' sign is wrong",
               true);
  } else if (gains.mirrored.surely_above(0.5) && gains.along.surely_below(0.5 * gains.mirrored.gain())) {
    gate.fault(0,
               "the reference moves along its mirrored heading: x, y and heading do not belong to one "
               "right-handed frame",
               true);
  }
  const bool is_explained = std::ranges::any_of(gate.result.faults, &DataFault::explains);
  if (gate.result.log.has_ticks() && !is_explained) {
    if (const auto wrong = wrong_scale(gate.result.log, gains)) gate.fault(0, *wrong, true);
  }
  if (gains.turned.surely_below(gain_of_a_wrong_sign)) {
    gate.fault(
        0,
        "the reference turns against the wheels: left and right, or the sign of the heading, are exchanged",
        true);
  }
}

}  // namespace wheelwright::gap
