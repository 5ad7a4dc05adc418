#include "tools/wheelwright/report/response_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/statistics/confidence.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::size_t shown_periods = 30;  // after the step; all is over by then

enum class Motor : unsigned char { left, right };

// The mean of repetitions, and what is needed for its interval.
struct Mean {
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;

  void add(double value) {
    sum += value;
    squares += value * value;
    count += 1.0;
  }
  double value() const { return sum / count; }
  double interval() const {
    if (count < 2.0) return 0.0;
    const double variance = std::max(0.0, (squares - sum * sum / count) / (count - 1.0));
    return deviations_in_ci95 * std::sqrt(variance / count);
  }
};

struct MeasuredStep {
  std::array<Mean, shown_periods> v;  // m/s per m/s
  std::array<Mean, shown_periods> w;  // rad/s per m/s
};

bool drives(const DriveLog& action, Motor motor) {
  const WheelPair& command = action.samples.front().command_m_s;
  return (motor == Motor::left ? command.left : command.right) != 0.0 &&
         (motor == Motor::left ? command.right : command.left) == 0.0;
}

void add_action(const DriveLog& action, Motor motor, MeasuredStep& step) {
  const WheelPair first = action.samples.front().command_m_s;
  const double command = motor == Motor::left ? first.left : first.right;
  for (std::size_t k = 0; k + 1 < action.samples.size() && k < shown_periods; ++k) {
    const DriveSample& here = action.samples[k];
    const DriveSample& next = action.samples[k + 1];
    const bool held = here.command_m_s.left == first.left && here.command_m_s.right == first.right;
    if (!held || !here.ticks || !next.ticks) return;
    const double dt = next.t_s - here.t_s;
    const double left =
        static_cast<double>(next.ticks->left - here.ticks->left) * action.metres_per_tick->left / dt;
    const double right =
        static_cast<double>(next.ticks->right - here.ticks->right) * action.metres_per_tick->right / dt;
    const Twist twist = twist_of_wheels({left, right}, action.wheel_base_m);
    step.v.at(k).add(twist.v_m_s / command);
    step.w.at(k).add(twist.w_rad_s / command);
  }
}

MeasuredStep measured_step(std::span<const DriveLog> actions, Motor motor) {
  MeasuredStep step;
  for (const DriveLog& action : actions) {
    if (!action.samples.empty() && action.metres_per_tick && drives(action, motor)) {
      add_action(action, motor, step);
    }
  }
  return step;
}

// A point stands at the end of the period that it is the mean of.
PlotPoints with_intervals(const std::array<Mean, shown_periods>& means, double period_s) {
  PlotPoints points;
  for (std::size_t k = 0; k < means.size(); ++k) {
    if (means.at(k).count < 1.0) continue;
    points.push_back(
        {1e3 * period_s * static_cast<double>(k + 1), means.at(k).value(), means.at(k).interval()});
  }
  return points;
}

PlotPoints over_time(const std::vector<double>& values, double period_s, bool summed) {
  PlotPoints points;
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sum += values[k];
    points.push_back({1e3 * period_s * static_cast<double>(k + 1), summed ? sum : values[k]});
  }
  return points;
}

}  // namespace

std::vector<Plot> response_plots(const LinearModel& model, std::span<const DriveLog> actions) {
  const TwistResponse impulse = twist_response(model, shown_periods);
  const double period_s = model.period_s;
  Plot step_v(
      "Step responses, forward speed: what a motor that is switched on does to the robot's speed, per "
      "command. Dots: "
      "mean of the repetitions with its 95 % interval; they leap where the robot refreshed its counters "
      "twice within "
      "a period. Line: the model.");
  Plot step_w("Step responses, turn rate: the same for turning, per command.");
  Plot impulse_v(
      "Transfer functions of forward speed: the impulse responses H_Lv and H_Rv, derivatives of the "
      "step responses.");
  Plot impulse_w("Transfer functions of turn rate: H_Lw and H_Rw.");
  step_v.axes("time after the step [ms]", "v / command [1]");
  step_w.axes("time after the step [ms]", "w / command [1/m]");
  impulse_v.axes("time [ms]", "v / command, per period [1]");
  impulse_w.axes("time [ms]", "w / command, per period [1/m]");
  for (Plot* plot : {&step_v, &step_w, &impulse_v, &impulse_w}) plot->half();
  for (const Motor motor : {Motor::left, Motor::right}) {
    const bool left = motor == Motor::left;
    const std::string name = left ? "left motor" : "right motor";
    const Ink ink = left ? Ink::accent : Ink::other;
    const auto& v = left ? impulse.v_from_left : impulse.v_from_right;
    const auto& w = left ? impulse.w_from_left : impulse.w_from_right;
    const MeasuredStep measured = measured_step(actions, motor);
    step_v.error_bars("", ink, with_intervals(measured.v, period_s));
    step_w.error_bars("", ink, with_intervals(measured.w, period_s));
    step_v.line(name, ink, over_time(v, period_s, true));
    step_w.line(name, ink, over_time(w, period_s, true));
    impulse_v.dotted_line(name, ink, over_time(v, period_s, false));
    impulse_w.dotted_line(name, ink, over_time(w, period_s, false));
  }
  return {step_v, step_w, impulse_v, impulse_w};
}

}  // namespace wheelwright::tools
