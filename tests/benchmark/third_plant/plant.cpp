#include "tests/benchmark/third_plant/plant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plants::third {

Plant::Plant(const RobotSpec& robot, int run, double run_s, const Pose& start, const Random& random)
    : robot_(robot),
      firmware_(robot.firmware),
      supply_(robot.supply, run, random.child(0)),
      grease_(robot.grease),
      derating_(robot.derating, run_s, random.child(1)),
      odd_force_(robot.odd_force, robot.rim_mass_kg, random.child(2)),
      slips_(robot.slips, run_s, random.child(3)),
      loose_contacts_(robot.loose_contacts, run_s, random.child(4)),
      undercarriage_(robot.undercarriage),
      pose_(start) {
  Random angles = random.child(5);
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
    trains_.emplace_back(robot, wheel, angles.uniform(0.0, 2.0 * std::numbers::pi), random.child(6 + wheel));
}

void Plant::advance_to(double time_s) {
  constexpr double longest_step_s = 0.0005;
  const double span_s = time_s - now_s_;
  const int steps = static_cast<int>(std::ceil(span_s / longest_step_s));
  for (int index = 0; index < steps; ++index) step(span_s / steps);
  now_s_ = time_s;
}

void Plant::step(double step_s) {
  now_s_ += step_s;
  const PerWheel<double> target_m_s = firmware_.target_m_s(now_s_, step_s);
  const DriveTrain& left = trains_[left_side];
  const DriveTrain& right = trains_[right_side];
  const double current_a = std::abs(left.motor.current_a()) + std::abs(right.motor.current_a());
  const double use = (std::abs(left.motor_m_s) + std::abs(right.motor_m_s)) / robot_.fastest_m_s;
  supply_.step(now_s_, current_a, use, step_s);
  grease_.step(use, step_s);
  derating_.step(use, step_s);
  const double supply_share = supply_.share() * derating_.share(now_s_, current_a);
  PerWheel<double> floor_m_s{};
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel) {
    step_motor(wheel, target_m_s[wheel], supply_share, step_s);
    floor_m_s[wheel] = step_wheel(wheel, step_s);
  }
  odd_force_.step(now_s_, 0.5 * (left.motor_m_s + right.motor_m_s), step_s);
  move(undercarriage_.step(floor_m_s, step_s), step_s);
}

void Plant::step_motor(std::size_t wheel, double target_m_s, double supply_share, double step_s) {
  DriveTrain& train = trains_[wheel];
  const double speed_m_s = train.motor_m_s;
  const double demand_m_s = train.controller.demand_m_s(target_m_s, speed_m_s, step_s);
  double motor_n = train.motor.force_n(demand_m_s, supply_share, speed_m_s, step_s);
  if (loose_contacts_.hit(wheel, now_s_)) {
    train.motor.cut_current();
    motor_n = 0.0;
  }
  if (!train.motor.held_back()) train.controller.integrate(speed_m_s, step_s);
  const double odd_n = odd_force_.on_wheel_n(wheel, speed_m_s, now_s_);
  train.motor_m_s += step_s * (motor_n - drag_n(wheel, step_s) + odd_n) / robot_.rim_mass_kg;
}

double Plant::drag_n(std::size_t wheel, double step_s) {
  const double speed_m_s = trains_[wheel].motor_m_s;
  const double viscous_n =
      (robot_.motor.drag_n_s_m + robot_.quadratic_drag_n_s2_m2 * std::abs(speed_m_s)) * speed_m_s;
  const double rug_n = stands_on_rug(wheel) ? robot_.floor.rug.drag_n_s_m * speed_m_s : 0.0;
  return viscous_n + grease_.drag_n(speed_m_s) + trains_[wheel].friction.force_n(speed_m_s, step_s) + rug_n +
         slope_drag_n(robot_.floor, pose_.heading_rad, speed_m_s);
}

// Returns the speed of the wheel over the floor.
double Plant::step_wheel(std::size_t wheel, double step_s) {
  constexpr double grip_in_slip = 0.35;
  DriveTrain& train = trains_[wheel];
  const double rough_m_s = train.motor_m_s + train.noise.step_m_s(train.motor_m_s, step_s);
  const double wheel_m_s = train.gear.step_m_s(rough_m_s, step_s);
  double roll = stands_on_rug(wheel) ? robot_.floor.rug.roll : 1.0;
  if (slips_.hit(wheel, now_s_)) roll *= grip_in_slip;
  return train.tyre.step_m_s(wheel_m_s, train.gear.wheel_angle_rad(), roll, step_s);
}

bool Plant::stands_on_rug(std::size_t wheel) const {
  const double aside_m = (wheel == left_side ? 0.5 : -0.5) * robot_.wheel_base_m;
  const Pose contact = point_of_body(pose_, 0.0, aside_m);
  return on_rug(robot_.floor.rug, contact.x_m, contact.y_m);
}

void Plant::move(const BodyMotion& body, double step_s) {
  const double middle_rad = pose_.heading_rad + 0.5 * step_s * body.turn_rad_s;
  pose_.x_m += step_s * body.forward_m_s * std::cos(middle_rad);
  pose_.y_m += step_s * body.forward_m_s * std::sin(middle_rad);
  pose_.heading_rad += step_s * body.turn_rad_s;
}

}  // namespace plants::third
