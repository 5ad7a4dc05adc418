// Runs with counts of a robot whose model is known, and of what its wheels travel beyond that.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "model/gap/fit/trial_model.hpp"
#include "model/gap/runs/run.hpp"

namespace wheelwright::test {

constexpr double counted_period_s = 0.02;
constexpr WheelPair counted_metres_per_tick{0.0005, 0.0005};

inline gap::TrialModel counted_robot() {
  return gap::first_guess({}, counted_period_s, 0.25, 0.06, 0.04);
}

// Of a period, from 0.
using CommandOfPeriod = std::function<WheelPair(int period)>;
// What the wheels have travelled in all beyond what the model says, which is `way_m`; asked once each period.
using TravelBeyond = std::function<WheelPair(double time_s, const WheelPair& way_m)>;

inline WheelPair forward_at_two_speeds(int period) {
  const double speed_m_s = period / 150 % 2 == 0 ? 0.2 : 0.11;
  return {speed_m_s, speed_m_s};
}

// Steps to and fro in several sizes, the wheels alike and against each other.
inline WheelPair steps_to_and_fro(int period) {
  const int step = period / 40;
  const double size_m_s = 0.05 * (1 + step % 4);
  return {step % 2 == 0 ? size_m_s : -size_m_s, step % 3 == 0 ? size_m_s : -0.5 * size_m_s};
}

inline gap::GapRun counted_run(
    const gap::TrialModel& robot, int periods, const CommandOfPeriod& command_m_s,
    const TravelBeyond& beyond_m = [](double, const WheelPair&) { return WheelPair{}; },
    const std::string& name = {}) {
  ModelSimulation simulation = robot.simulation();
  simulation.reset({});
  DriveLog log;
  log.name = name;
  log.wheel_base_m = robot.wheel_base_m;
  log.period_s = robot.period_s;
  log.metres_per_tick = counted_metres_per_tick;
  WheelPair way_m;
  for (int k = 0; k < periods; ++k) {
    DriveSample sample;
    sample.t_s = robot.period_s * k;
    sample.command_m_s = command_m_s(k);
    const WheelPair more_m = beyond_m(sample.t_s, way_m);
    sample.ticks = WheelTicks{std::llround((way_m.left + more_m.left) / counted_metres_per_tick.left),
                              std::llround((way_m.right + more_m.right) / counted_metres_per_tick.right)};
    log.samples.push_back(sample);
    const WheelPair speed_m_s = simulation.step(sample.command_m_s).wheel_m_s;
    way_m.left += robot.period_s * speed_m_s.left;
    way_m.right += robot.period_s * speed_m_s.right;
  }
  return gap::make_gap_run(log, {}, robot.period_s);
}

}  // namespace wheelwright::test
