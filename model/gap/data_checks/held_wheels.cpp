#include "model/gap/data_checks/held_wheels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wheelwright::gap {
namespace {

// Of a wheel between two rows, without what a counter that stood still until row `until` caught up with
// there.
double counted_m(const GateState& gate, std::size_t first, std::size_t until, std::size_t end, bool left) {
  const auto& samples = gate.result.log.samples;
  const auto between = [&](std::size_t from, std::size_t to) {
    return gate.travel(to, left) - gate.travel(from, left);
  };
  if (until + 2 > end || !samples[until + 1].ticks || !samples[until + 2].ticks) return between(first, end);
  return between(first, end) - between(until, until + 1) + between(until + 1, until + 2);
}

// How far a reference saw a wheel roll, beyond what it counted, between two rows; nothing where one of them
// lacks counts or a reference.
std::optional<double> rolled_uncounted_m(const GateState& gate, std::size_t first, std::size_t until,
                                         std::size_t end, bool left) {
  const DriveLog& log = gate.result.log;
  const DriveSample& from = log.samples[first];
  const DriveSample& to = log.samples[end];
  if (!from.reference_pose() || !to.reference_pose() || !from.ticks || !to.ticks) return std::nullopt;
  const double turned = wrap_angle(*to.reference_theta_rad - *from.reference_theta_rad);
  const double heading = *from.reference_theta_rad + 0.5 * turned;
  const double forward_m = (*to.reference_x_m - *from.reference_x_m) * std::cos(heading) +
                           (*to.reference_y_m - *from.reference_y_m) * std::sin(heading);
  const double rolled_m = forward_m + (left ? -0.5 : 0.5) * turned * log.wheel_base_m;
  return rolled_m - counted_m(gate, first, until, end, left);
}

}  // namespace

bool moved_as_counted(const GateState& gate, std::size_t first, std::size_t end, double within_m) {
  const DriveLog& log = gate.result.log;
  const DriveSample& from = log.samples[first];
  const DriveSample& to = log.samples[end];
  if (!from.reference_pose() || !to.reference_pose()) return false;
  const double left_m = gate.travel(end, true) - gate.travel(first, true);
  const double right_m = gate.travel(end, false) - gate.travel(first, false);
  const double turned =
      wrap_angle(*to.reference_theta_rad - *from.reference_theta_rad - (right_m - left_m) / log.wheel_base_m);
  const double moved_m =
      std::hypot(*to.reference_x_m - *from.reference_x_m, *to.reference_y_m - *from.reference_y_m);
  return std::abs(turned) * log.wheel_base_m < within_m &&
         std::abs(2.0 * moved_m - std::abs(left_m + right_m)) < within_m;
}

SeenRolling seen_rolling(const GateState& gate, std::span<const SuspectedLoss> suspects) {
  SeenRolling seen;
  for (const auto& [freeze, lost_m] : suspects) {
    const std::size_t rows = freeze.end - freeze.first;
    const std::size_t first = freeze.first - std::min(freeze.first, rows);
    const std::size_t end = std::min(freeze.end + rows, gate.result.log.samples.size() - 1);
    const auto rolled_m = rolled_uncounted_m(gate, first, freeze.end, end, freeze.left);
    if (!rolled_m) continue;
    seen += {std::abs(lost_m), std::copysign(1.0, lost_m) * *rolled_m};
  }
  return seen;
}

bool were_held(const SeenRolling& here, const SeenRolling& elsewhere) {
  constexpr double enough_to_tell_m = 0.015;
  SeenRolling all = here;
  all += elsewhere;
  return all.lost_m >= enough_to_tell_m && all.rolled_m < 0.5 * all.lost_m;
}

}  // namespace wheelwright::gap
