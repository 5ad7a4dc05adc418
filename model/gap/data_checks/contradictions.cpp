#include "model/gap/data_checks/contradictions.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "model/command_timeline.hpp"
#include "model/gap/runs/gyro_turns.hpp"

namespace wheelwright::gap {
namespace {

constexpr double window_s = 0.5;

// Commands against travel over windows of half a second: gains of each counter from each command, with the
// commands taken `delay_s` earlier.
struct Gains {
  double left_own = 0.0;
  double left_other = 0.0;
  double right_own = 0.0;
  double right_other = 0.0;
  double explained = 0.0;  // sum of squares of the travel
};

std::optional<Gains> gains(const GateState& gate, const CommandTimeline& commands, double delay_s) {
  const auto& samples = gate.result.log.samples;
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d travels = Eigen::Matrix2d::Zero();  // one column per counter
  std::size_t from = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double duration = samples[i].t_s - samples[from].t_s;
    if (duration < window_s) continue;
    if (samples[from].ticks && samples[i].ticks && samples[from].t_s >= delay_s + samples[0].t_s) {
      const Eigen::Vector2d moved(gate.travel(i, true) - gate.travel(from, true),
                                  gate.travel(i, false) - gate.travel(from, false));
      const WheelPair mean = commands.mean_m_s(samples[from].t_s - delay_s, samples[i].t_s - delay_s);
      const Eigen::Vector2d commanded = duration * Eigen::Vector2d(mean.left, mean.right);
      if (moved.cwiseAbs().maxCoeff() < impossible_speed_m_s * window_s) {
        products += commanded * commanded.transpose();
        travels += commanded * moved.transpose();
      }
    }
    from = i;
  }
  const double left = products(0, 0);
  const double right = products(1, 1);
  if (!(products.determinant() > 0.02 * left * right) || left < 1e-4 || right < 1e-4) return std::nullopt;
  const Eigen::Matrix2d gains = products.inverse() * travels;
  return Gains{gains(0, 0), gains(1, 0), gains(1, 1), gains(0, 1), gains.cwiseProduct(travels).sum()};
}

}  // namespace

void check_sides_and_signs(GateState& gate) {
  // A slow answer is an effect, not a fault: judged with the delay that explains most.
  const CommandTimeline commands(gate.result.log);
  std::optional<Gains> best;
  for (const double delay_s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto found = gains(gate, commands, delay_s);
    if (found && (!best || found->explained > 1.1 * best->explained)) best = found;
  }
  if (!best) return;
  if (best->left_other > 0.5 && best->right_other > 0.5 &&
      std::abs(best->left_own) < 0.3 * best->left_other &&
      std::abs(best->right_own) < 0.3 * best->right_other) {
    gate.fault(0, "ticks_left follows the right command and ticks_right the left one: the sides are swapped",
               true);
    return;
  }
  const auto check = [&](double gain, const std::string& name) {
    const std::string unit = ": check metres_per_tick and the unit of the commands";
    if (gain < -0.2) {
      gate.fault(0, name + " counts against its command (gain " + in_digits(gain, 3) + "): its sign is wrong",
                 true);
    } else if (gain > 4.0) {
      gate.fault(0, name + " gives " + in_digits(gain, 3) + " times the commanded travel" + unit, true);
    } else if (gain >= 0.0 && gain < 0.15) {
      gate.fault(0, name + " gives only " + in_digits(gain, 2) + " of the commanded travel" + unit, true);
    }
  };
  check(best->left_own, "ticks_left");
  check(best->right_own, "ticks_right");
}

void check_reference(GateState& gate) {
  const DriveLog& log = gate.result.log;
  const auto& samples = log.samples;
  double ww = 0.0, wr = 0.0, vv = 0.0, vf = 0.0, vm = 0.0;
  std::optional<std::size_t> from;
  double forward = 0.0;
  double turn = 0.0;
  const bool heading_alone = !log.references_tell_places();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    if (from && i > 0) {
      const double duration = samples[i].t_s - samples[i - 1].t_s;
      double left = samples[i - 1].command_m_s.left * duration;
      double right = samples[i - 1].command_m_s.right * duration;
      if (log.has_ticks() && sample.ticks && samples[i - 1].ticks) {
        left = gate.travel(i, true) - gate.travel(i - 1, true);
        right = gate.travel(i, false) - gate.travel(i - 1, false);
      }
      forward += 0.5 * (left + right);
      turn += (right - left) / log.wheel_base_m;
    }
    if (heading_alone ? !sample.reference_theta_rad : !sample.reference_pose()) continue;
    if (from && sample.t_s - samples[*from].t_s < window_s) continue;
    if (from && sample.t_s - samples[*from].t_s < 3.0 * window_s) {
      const auto& before = samples[*from];
      const double turned = wrap_angle(*sample.reference_theta_rad - *before.reference_theta_rad);
      if (std::abs(turn) < 1.5) {
        ww += turn * turn;
        wr += turn * turned;
      }
      if (std::abs(turn) < 1.5 && !heading_alone) {
        const double middle = *before.reference_theta_rad + 0.5 * turned;
        const double dx = *sample.reference_x_m - *before.reference_x_m;
        const double dy = *sample.reference_y_m - *before.reference_y_m;
        vv += forward * forward;
        vf += forward * (dx * std::cos(middle) + dy * std::sin(middle));
        vm += forward * (dx * std::cos(middle) - dy * std::sin(middle));
      }
    }
    from = i;
    forward = turn = 0.0;
  }
  if (vv > 0.02) {
    const double gain = vf / vv;
    if (std::abs(gain) > 20.0) {
      gate.fault(0,
                 "the reference moves " + in_digits(gain, 3) +
                     " times as far as the wheels: is it in mm or cm? the format wants m",
                 true);
    } else if (gain < -0.3) {
      gate.fault(
          0,
          "the reference moves backward where the wheels roll forward: its heading is turned by half a "
          "turn, or the commands' sign is wrong",
          true);
    } else if (gain < 0.5 * vm / vv && vm / vv > 0.5) {
      gate.fault(0,
                 "the reference moves along its mirrored heading: x, y and heading do not belong to one "
                 "right-handed frame",
                 true);
    }
  }
  if (ww > 0.3) {
    const double gain = wr / ww;
    if (gain < -0.3) {
      gate.fault(
          0,
          "the reference turns against the wheels: left and right, or the sign of the heading, are exchanged",
          true);
    }
  }
}

void check_gyro(GateState& gate) {
  constexpr double wrong_unit = 20.0;  // degrees give 57
  DriveLog& log = gate.result.log;
  const auto turns = gyro_turns(log);
  if (turns.empty() || !log.has_ticks()) return;
  // Over windows, the bias being the same in all of them.
  double windows = 0.0, sum_counted = 0.0, sum_gyro = 0.0, squares = 0.0, products = 0.0;
  std::optional<GyroTurn> from;
  for (const GyroTurn& to : turns) {
    if (!log.samples[to.row].ticks) continue;
    if (from && log.samples[to.row].t_s - log.samples[from->row].t_s < window_s) continue;
    if (from) {
      const double left = gate.travel(to.row, true) - gate.travel(from->row, true);
      const double right = gate.travel(to.row, false) - gate.travel(from->row, false);
      const double counted = (right - left) / log.wheel_base_m;
      const double gyro = to.turned_rad - from->turned_rad;
      windows += 1.0;
      sum_counted += counted;
      sum_gyro += gyro;
      squares += counted * counted;
      products += counted * gyro;
    }
    from = to;
  }
  const double spread = squares - sum_counted * sum_counted / std::max(windows, 1.0);
  if (!(spread > 0.3)) return;
  const double gain = (products - sum_counted * sum_gyro / windows) / spread;
  std::string what;
  if (gain < -0.3) {
    what = "the gyro turns against the wheels: gyro_z is counter-clockwise in the format";
  } else if (gain > wrong_unit) {
    what = "the gyro turns " + in_digits(gain, 3) +
           " times as far as the wheels: is gyro_z in degrees? the format wants rad/s";
  } else {
    return;
  }
  gate.fault(0, what + "; it was left out");
  for (DriveSample& sample : log.samples) sample.gyro_z_rad_s.reset();
}

}  // namespace wheelwright::gap
