#include "model/gap/data_checks/contradictions.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "model/gap/data_checks/gain_over_windows.hpp"
#include "model/gap/runs/gyro_turns.hpp"
#include "model/log/command_timeline.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

// Commands against travel over windows of half a second: gains of each counter from each command, with the
// commands taken `delay_s` earlier.
struct Gains {
  double left_own = 0.0;
  double left_other = 0.0;
  double right_own = 0.0;
  double right_other = 0.0;
  double explained = 0.0;     // sum of squares of the travel
  bool left_follows = false;  // whether its own command explains most of how a wheel moved
  bool right_follows = false;
};

std::optional<Gains> gains(const GateState& gate, const CommandTimeline& commands, double delay_s) {
  const auto& samples = gate.result.log.samples;
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d travels = Eigen::Matrix2d::Zero();  // one column per counter
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  std::size_t from = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double duration = samples[i].t_s - samples[from].t_s;
    if (duration < gain_window_s) continue;
    if (samples[from].ticks && samples[i].ticks && samples[from].t_s >= delay_s + samples[0].t_s) {
      const Eigen::Vector2d moved(gate.travel(i, true) - gate.travel(from, true),
                                  gate.travel(i, false) - gate.travel(from, false));
      const WheelPair mean = commands.mean_m_s(samples[from].t_s - delay_s, samples[i].t_s - delay_s);
      const Eigen::Vector2d commanded = duration * Eigen::Vector2d(mean.left, mean.right);
      if (moved.cwiseAbs().maxCoeff() < impossible_speed_m_s * gain_window_s) {
        products += commanded * commanded.transpose();
        travels += commanded * moved.transpose();
        squares += moved.cwiseAbs2();
      }
    }
    from = i;
  }
  const double left = products(0, 0);
  const double right = products(1, 1);
  if (!(products.determinant() > 0.02 * left * right) || left < 1e-4 || right < 1e-4) return std::nullopt;
  const Eigen::Matrix2d gains = products.inverse() * travels;
  const Eigen::Matrix2d explained = gains.cwiseProduct(travels);
  constexpr double most = 0.5;
  return Gains{gains(0, 0),
               gains(1, 0),
               gains(1, 1),
               gains(0, 1),
               explained.sum(),
               explained(0, 0) >= most * squares(0),
               explained(1, 1) >= most * squares(1)};
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
  // A unit or a sign is wrong in all of a run: a wheel that moves otherwise than it is told lacks something
  // else.
  const auto check = [&](double gain, bool follows, const std::string& name) {
    if (!follows) return;
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
  check(best->left_own, best->left_follows, "ticks_left");
  check(best->right_own, best->right_follows, "ticks_right");
}

void check_gyro(GateState& gate) {
  DriveLog& log = gate.result.log;
  const auto turns = gyro_turns(log);
  if (turns.empty() || !log.has_ticks()) return;
  // Over windows, the bias being the same in all of them.
  std::vector<double> counted_rad;
  std::vector<double> gyro_rad;
  std::optional<GyroTurn> from;
  for (const GyroTurn& to : turns) {
    if (!log.samples[to.row].ticks) continue;
    if (from && log.samples[to.row].t_s - log.samples[from->row].t_s < gain_window_s) continue;
    if (from) {
      const double left = gate.travel(to.row, true) - gate.travel(from->row, true);
      const double right = gate.travel(to.row, false) - gate.travel(from->row, false);
      counted_rad.push_back((right - left) / log.wheel_base_m);
      gyro_rad.push_back(to.turned_rad - from->turned_rad);
    }
    from = to;
  }
  if (counted_rad.empty()) return;
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  const double mean_counted = mean(counted_rad);
  const double mean_gyro = mean(gyro_rad);
  GainOf turned;
  for (std::size_t i = 0; i < counted_rad.size(); ++i) {
    turned.add(counted_rad[i] - mean_counted, gyro_rad[i] - mean_gyro);
  }
  std::string what;
  if (turned.surely_below(gain_of_a_wrong_sign)) {
    what = "the gyro turns against the wheels: gyro_z is counter-clockwise in the format";
  } else if (turned.surely_above(gain_of_a_wrong_unit)) {
    what = "the gyro turns " + in_digits(turned.gain(), 3) +
           " times as far as the wheels: is gyro_z in degrees? the format wants rad/s";
  } else {
    return;
  }
  gate.treated_fault(0, what, "it was left out");
  for (DriveSample& sample : log.samples) sample.gyro_z_rad_s.reset();
}

}  // namespace wheelwright::gap
