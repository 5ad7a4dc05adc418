#include "tests/benchmark/sixth_plant/simulation.hpp"

#include <cmath>
#include <utility>

#include "tests/benchmark/sixth_plant/body.hpp"
#include "tests/benchmark/sixth_plant/camera.hpp"
#include "tests/benchmark/sixth_plant/counters.hpp"
#include "tests/benchmark/sixth_plant/dice.hpp"
#include "tests/benchmark/sixth_plant/firmware.hpp"
#include "tests/benchmark/sixth_plant/late_stamps.hpp"
#include "tests/benchmark/sixth_plant/link.hpp"
#include "tests/benchmark/sixth_plant/shaking.hpp"
#include "tests/benchmark/sixth_plant/supply.hpp"
#include "tests/benchmark/sixth_plant/wheel.hpp"

namespace plants::sixth {

namespace {

class Simulation {
 public:
  Simulation(const Robot& robot, const Hidden& hidden, const DriveScript& script, bool engaged);

  void step(long number);
  [[nodiscard]] Run take() { return std::move(run_); }

 private:
  void note(double time_s);
  PerWheel<double> motor_forces_n(double time_s, const PerWheel<double>& command_m_s);
  void move(double time_s, const PerWheel<double>& motor_n);

  const Robot& robot_;
  const DriveScript& script_;
  Random chance_;
  Random measuring_;
  Shaking shaking_;
  Firmware firmware_;
  Camera camera_;
  // In the order in which they draw what differs from run to run.
  PerWheel<Wheel> wheels_;
  Supply supply_;
  Body body_;
  LateStamps stamps_;
  Link link_;
  Counters counters_;
  Run run_;
};

Simulation::Simulation(const Robot& robot, const Hidden& hidden, const DriveScript& script, bool engaged)
    : robot_(robot),
      script_(script),
      chance_(warmed_up(mixed_seed(script.noise_seed, 77))),
      measuring_(warmed_up(mixed_seed(script.noise_seed, 99))),
      shaking_(robot, warmed_up(script.noise_seed)),
      firmware_(robot, hidden),
      camera_(robot, hidden),
      wheels_{Wheel(robot, hidden, left_side, engaged, chance_),
              Wheel(robot, hidden, right_side, engaged, chance_)},
      supply_(robot, hidden, script.time_s.back(), chance_),
      body_(robot, hidden, script.start, chance_),
      stamps_(hidden, chance_),
      link_(robot, hidden, script, chance_),
      counters_(robot, hidden, script.time_s.back(), chance_, measuring_) {
  run_.log.wheel_base_m = robot.wheel_base_m;
  run_.log.period_s = robot.period_s;
  run_.log.metres_per_tick = robot.metres_per_tick;
  run_.log.digits.command = 4;
}

void Simulation::note(double time_s) {
  constexpr double meter_noise_v = 0.012;
  const std::size_t index = run_.log.rows.size();
  const Measurable seen = stamps_.seen_at(time_s, {counters_.counted_m(), body_.pose()});
  LogRow row;
  row.time_s = script_.time_s[index];
  // A zero is written without sign.
  for (const std::size_t side : {left_side, right_side})
    row.command_m_s[side] = script_.command_m_s[index][side] + 0.;
  row.ticks = counters_.ticks(seen.counted_m);
  row.reference = camera_.look(seen.axle, measuring_);
  row.battery_v = supply_.battery_v(time_s) + meter_noise_v * bell(measuring_);
  run_.log.rows.push_back(row);
  run_.truth.push_back({body_.pose(), body_.pose().heading_rad});
}

PerWheel<double> Simulation::motor_forces_n(double time_s, const PerWheel<double>& command_m_s) {
  const PerWheel<double> duty_m_s = firmware_.step(time_s, command_m_s);
  PerWheel<double> force_n{};
  for (const std::size_t side : {left_side, right_side}) {
    const double wanted_m_s = wheels_[side].wanted_voltage_m_s(time_s, duty_m_s[side]);
    force_n[side] = wheels_[side].pull_n(supply_.weakened(wanted_m_s, side)) + shaking_.load_n(side) +
                    shaking_.voltage_n(side);
  }
  return force_n;
}

void Simulation::move(double time_s, const PerWheel<double>& motor_n) {
  PerWheel<double> push_n{};
  for (const std::size_t side : {left_side, right_side}) {
    wheels_[side].turn_motor(time_s, motor_n[side]);
    push_n[side] = wheels_[side].push_n(body_.ground_m_s(side), body_.track_m(), body_.more_drag_n_s_m(side));
  }
  const double rims_m_s = std::abs(wheels_[left_side].rim_m_s()) + std::abs(wheels_[right_side].rim_m_s());
  for (Wheel& wheel : wheels_) wheel.roll();
  counters_.step(time_s, {wheels_[left_side].rim_m_s(), wheels_[right_side].rim_m_s()});
  body_.step(time_s, push_n, rims_m_s, shaking_.forward_m_s(), shaking_.turn_rad_s());
  camera_.step(body_.forward_m_s(), body_.turn_rad_s());
}

void Simulation::step(long number) {
  const double time_s = static_cast<double>(number) * fine_step_s;
  if (number % 2 == 0) {
    shaking_.step();
    stamps_.remember({counters_.counted_m(), body_.pose()});
  }
  const std::size_t rows = script_.time_s.size();
  while (run_.log.rows.size() < rows && script_.time_s[run_.log.rows.size()] <= time_s + 1e-9) note(time_s);
  const PerWheel<double> force_n = motor_forces_n(time_s, link_.command_m_s(time_s));
  supply_.step(time_s, force_n, wheels_[left_side].rim_m_s());
  move(time_s, force_n);
}

}  // namespace

Run simulate(const Robot& robot, const Hidden& hidden, const DriveScript& script, bool engaged) {
  Simulation simulation(robot, hidden, script, engaged);
  const long steps = static_cast<long>(script.time_s.back() / fine_step_s) + 4;
  for (long number = 0; number <= steps; ++number) simulation.step(number);
  return simulation.take();
}

}  // namespace plants::sixth
