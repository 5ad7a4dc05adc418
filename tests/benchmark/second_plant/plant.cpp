#include "tests/benchmark/second_plant/plant.hpp"

#include <cmath>
#include <numbers>

namespace plants::second {

namespace {
double side_sign(std::size_t wheel) {
  return wheel == left_side ? 1.0 : -1.0;
}
}  // namespace

Plant::Plant(const RobotSpec& robot, int run, const Pose& start, Random random)
    : robot_(robot),
      firmware_(robot.firmware, robot.odd_command),
      battery_(robot.battery, run, random.child(1)),
      caster_(robot.undercarriage),
      odd_force_(robot.odd_force, random.child(2)),
      pose_(start) {
  Random angles = random.child(3);
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
    trains_.emplace_back(robot, robot.tyre[wheel], angles.uniform(0.0, 2.0 * std::numbers::pi));
}

void Plant::advance_to(double time_s) {
  while (now_s_ + kStep_s <= time_s) step();
}

void Plant::step() {
  const PerWheel<double> target_m_s = firmware_.target_m_s(now_s_, kStep_s);
  const double current_a =
      std::abs(trains_[left_side].motor.current_a()) + std::abs(trains_[right_side].motor.current_a());
  battery_.step(now_s_, current_a, kStep_s);
  odd_force_.step(now_s_, acceleration_m_s2_, kStep_s);
  PerWheel<double> traction_n{};
  for (std::size_t wheel = 0; wheel < wheel_count; ++wheel)
    traction_n[wheel] = step_train(wheel, target_m_s[wheel]);
  step_body(traction_n, target_m_s[left_side] != 0.0 || target_m_s[right_side] != 0.0);
  ++steps_;
  now_s_ = static_cast<double>(steps_) * kStep_s;
}

double Plant::floor_speed_m_s(std::size_t wheel) const {
  return forward_m_s_ - side_sign(wheel) * 0.5 * robot_.body.true_track_m * turn_rad_s_;
}

double Plant::rug_share(std::size_t wheel) const {
  const double aside_m = side_sign(wheel) * 0.5 * robot_.body.true_track_m;
  return share_on_rug(robot_.floor, pose_.x_m - aside_m * std::sin(pose_.heading_rad),
                      pose_.y_m + aside_m * std::cos(pose_.heading_rad));
}

// Advances one side and returns its traction on the body.
double Plant::step_train(std::size_t wheel, double target_m_s) {
  DriveTrain& train = trains_[wheel];
  const double demanded_v =
      train.controller.voltage_v(target_m_s, train.rotor_m_s, train.motor.limited(), kStep_s);
  const double motor_n = train.motor.force_n(demanded_v * battery_.bridge_gain(), train.rotor_m_s, kStep_s);
  const double current_a = train.motor.current_a();
  const double copper_loss_w = current_a * current_a * robot_.motor.resistance_ohm;
  const double losses_n = train.friction.force_n(train.rotor_m_s, kStep_s) +
                          train.grease.drag_n(train.rotor_m_s, copper_loss_w, kStep_s);
  const GearForces gear = train.gear.forces(train.rotor_m_s, train.wheel_m_s,
                                            train.wheel_angle_rad - train.tyre.high_point_rad, kStep_s);
  train.rotor_m_s += kStep_s * (motor_n - losses_n + gear.on_rotor_n + odd_force_.pump_n(now_s_)) /
                     robot_.motor.rotor_mass_kg;

  const double rug = rug_share(wheel);
  const double ratio = rolling_ratio(train.tyre, train.wheel_angle_rad);
  const double grip = 1.0 + rug * (robot_.floor.rug_grip - 1.0);
  const double traction_n = tyre_force_n(train.tyre, train.wheel_m_s * ratio - floor_speed_m_s(wheel), grip);
  const double drag_n = hub_drag_n(train.tyre, train.wheel_m_s);
  const double seizing_n = odd_force_.seizing_n(wheel, now_s_, train.wheel_m_s);
  train.wheel_m_s +=
      kStep_s * (gear.on_wheel_n - drag_n - traction_n * ratio + seizing_n) / train.tyre.wheel_mass_kg;
  train.wheel_angle_rad += kStep_s * train.wheel_m_s / train.tyre.radius_m;
  return traction_n - rug * robot_.floor.rug_drag_n_s_m * floor_speed_m_s(wheel);
}

void Plant::step_body(const PerWheel<double>& traction_n, bool driving) {
  const BodySpec& body = robot_.body;
  const UndercarriageSpec& under = robot_.undercarriage;
  const double force_n = traction_n[left_side] + traction_n[right_side] +
                         gravity_force_n(robot_.floor, body.mass_kg, pose_.heading_rad) +
                         felt_force_n(under, forward_m_s_, turn_rad_s_) +
                         odd_force_.gust_n(now_s_, pose_.heading_rad) + odd_force_.payload_n();
  const double moment_n_m = 0.5 * body.true_track_m * (traction_n[right_side] - traction_n[left_side]) +
                            second::skid_moment_n_m(under, turn_rad_s_) +
                            (driving ? under.side_brush_n_m : 0.0) +
                            caster_.moment_n_m(forward_m_s_, kStep_s);
  acceleration_m_s2_ = force_n / body.mass_kg;
  forward_m_s_ += kStep_s * acceleration_m_s2_;
  turn_rad_s_ += kStep_s * moment_n_m / body.yaw_inertia_kg_m2;
  const double middle_rad = pose_.heading_rad + 0.5 * kStep_s * turn_rad_s_;
  pose_.x_m += kStep_s * forward_m_s_ * std::cos(middle_rad);
  pose_.y_m += kStep_s * forward_m_s_ * std::sin(middle_rad);
  pose_.heading_rad += kStep_s * turn_rad_s_;
}

}  // namespace plants::second
