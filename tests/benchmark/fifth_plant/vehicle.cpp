#include "tests/benchmark/fifth_plant/vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace plants::fifth {

namespace {

FloorSpec both_wheels(FloorSpec floor) {
  floor.grip_n *= 2.0;
  floor.slip_stiffness_n *= 2.0;
  return floor;
}

}  // namespace

Vehicle::Vehicle(const Robot& robot, const Pose& start, double battery_v, const Random& random)
    : robot_(robot),
      start_(start),
      firmware_(robot.firmware, robot.wheel_base_m, random.child(0)),
      wheels_{Wheel(robot.sides[left_side], robot.floor, random.child(1)),
              Wheel(robot.sides[right_side], robot.floor, random.child(2))},
      sideways_(both_wheels(robot.floor)),
      castor_(robot.body),
      load_(robot.body),
      turret_(robot.body, random.child(3)),
      encoders_(robot.encoder, robot.sides[left_side].wheel.said_radius_m, random.child(4)),
      rested_v_(battery_v),
      battery_v_(battery_v) {
  motion_.pose = start;
}

Wrench Vehicle::context(const Wrench& tyres) {
  return tyres + floor_wrench(robot_, motion_) +
         drag_wrench(robot_.body, motion_, firmware_.driving(), start_) + castor_.step(motion_) +
         load_.step(motion_.forward_m_s) + turret_.step();
}

// Newton and Euler in the frame of the body.
void Vehicle::move(const Wrench& sum) {
  const double forward_m_s2 = sum.forward_n / robot_.mass_kg + motion_.left_m_s * motion_.turn_rad_s;
  const double left_m_s2 = sum.left_n / robot_.mass_kg - motion_.forward_m_s * motion_.turn_rad_s;
  motion_.forward_m_s += fine_step_s * forward_m_s2;
  motion_.left_m_s += fine_step_s * left_m_s2;
  motion_.turn_rad_s += fine_step_s * sum.yaw_n_m / robot_.yaw_inertia_kg_m2;
  const double turned_rad = fine_step_s * motion_.turn_rad_s;
  Pose halfway = motion_.pose;
  halfway.heading_rad += 0.5 * turned_rad;
  motion_.pose = point_of_body(halfway, fine_step_s * motion_.forward_m_s, fine_step_s * motion_.left_m_s);
  motion_.pose.heading_rad += 0.5 * turned_rad;
}

void Vehicle::discharge() {
  double input_w = 0.0;
  for (const Wheel& wheel : wheels_) input_w += std::max(0.0, wheel.motor().input_w());
  rested_v_ -= fine_step_s * robot_.battery.fall_v_s;
  battery_v_ = rested_v_ - robot_.battery.resistance_ohm * input_w / rested_v_;
}

void Vehicle::step(const PerWheel<double>& command_m_s) {
  const PerWheel<double> wanted_m_s = firmware_.step(command_m_s);
  const double supply = battery_v_ / robot_.battery.nominal_v;
  const double half_base_m = 0.5 * robot_.wheel_base_m;
  const double turning_m_s = half_base_m * motion_.turn_rad_s;
  const double left_n =
      wheels_[left_side].step(wanted_m_s[left_side], motion_.forward_m_s - turning_m_s, supply);
  const double right_n =
      wheels_[right_side].step(wanted_m_s[right_side], motion_.forward_m_s + turning_m_s, supply);
  const double sideways_n = sideways_.step(-motion_.left_m_s, motion_.forward_m_s);
  move(context({left_n + right_n, sideways_n, half_base_m * (right_n - left_n)}));
  encoders_.step(wheel_rad_s());
  discharge();
}

PerWheel<double> Vehicle::wheel_rad_s() const {
  return {wheels_[left_side].shaft_rad_s(), wheels_[right_side].shaft_rad_s()};
}

double Vehicle::kinetic_energy_j() const {
  const double squared_speed =
      motion_.forward_m_s * motion_.forward_m_s + motion_.left_m_s * motion_.left_m_s;
  double energy_j = 0.5 * robot_.mass_kg * squared_speed +
                    0.5 * robot_.yaw_inertia_kg_m2 * motion_.turn_rad_s * motion_.turn_rad_s;
  for (const std::size_t side : {left_side, right_side}) {
    const double motor_rad_s = wheels_[side].motor().speed_rad_s();
    const double shaft_rad_s = wheels_[side].shaft_rad_s();
    energy_j += 0.5 * robot_.sides[side].motor.inertia_kg_m2 * motor_rad_s * motor_rad_s +
                0.5 * robot_.sides[side].wheel.inertia_kg_m2 * shaft_rad_s * shaft_rad_s;
  }
  return energy_j;
}

}  // namespace plants::fifth
