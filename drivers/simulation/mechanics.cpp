#include "drivers/simulation/mechanics.hpp"

#include <cmath>

namespace wheelwright::simulation {
namespace {

Pose start_pose(const StartConfig& start, Noise& noise) {
  Pose pose{start.x_m, start.y_m, start.theta_rad};
  pose.x_m += start.position_spread_m * noise.normal();
  pose.y_m += start.position_spread_m * noise.normal();
  pose.theta_rad += start.heading_spread_rad * noise.normal();
  return pose;
}

int sign(double value) {
  return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0);
}

DriveSide make_side(const WheelConfig& wheel, const SimulationConfig& config, int start_count) {
  return {DriveUnit(wheel), WheelController(config.firmware, config.encoder),
          Encoder(config.encoder, start_count)};
}

}  // namespace

Mechanics::Mechanics(const SimulationConfig& config, Noise& noise)
    : chassis_config_(config.chassis),
      room_(config.room),
      battery_(config.battery),
      left_(make_side(config.left, config, config.encoder.start_count_left)),
      right_(make_side(config.right, config, config.encoder.start_count_right)),
      chassis_(config.chassis, start_pose(config.start, noise)) {
  stop_motors();
}

void Mechanics::step(double duration_s) {
  const double supply_v = battery_.voltage_v();
  left_.unit.drive(left_.controller.duty(), supply_v, duration_s);
  right_.unit.drive(right_.controller.duty(), supply_v, duration_s);
  const double motor_current_a =
      left_.controller.duty() * left_.unit.current_a() + right_.controller.duty() * right_.unit.current_a();
  battery_.draw(motor_current_a, duration_s);
  chassis_.move(left_.unit, right_.unit, room_, {!hangs(Side::left), !hangs(Side::right)}, duration_s);
  count(left_);
  count(right_);
}

void Mechanics::count(DriveSide& side) {
  side.encoder.look(side.unit.encoder_angle_rad(), side.controller.commanded_sign(),
                    sign(side.controller.duty()));
}

void Mechanics::controller_tick() {
  left_.controller.tick(left_.unit.encoder_angle_rad(), battery_.voltage_v());
  right_.controller.tick(right_.unit.encoder_angle_rad(), battery_.voltage_v());
}

void Mechanics::command_speeds(double left_m_s, double right_m_s) {
  left_.controller.command_speed(left_m_s);
  right_.controller.command_speed(right_m_s);
}

void Mechanics::command_duties(double left, double right) {
  left_.controller.command_duty(left);
  right_.controller.command_duty(right);
}

void Mechanics::stop_motors() {
  left_.controller.cut();
  right_.controller.cut();
}

void Mechanics::inject(const Fault& fault) {
  DriveSide& side = fault.side == Side::left ? left_ : right_;
  switch (fault.kind) {
    case Fault::Kind::lift_wheel:
    case Fault::Kind::set_down_wheel:
      side.lifted = fault.kind == Fault::Kind::lift_wheel;
      break;
    case Fault::Kind::stall_wheel:
    case Fault::Kind::free_wheel:
      side.unit.set_stalled(fault.kind == Fault::Kind::stall_wheel);
      break;
    case Fault::Kind::freeze_encoder:
    case Fault::Kind::thaw_encoder:
      side.encoder.freeze(fault.kind == Fault::Kind::freeze_encoder);
      break;
    case Fault::Kind::add_counts:
      side.encoder.add(fault.counts);
      break;
    case Fault::Kind::change_floor:
      room_.replace_floor(fault.surface);
      break;
    default:
      break;
  }
}

bool Mechanics::hangs(Side side) const {
  const bool is_left = side == Side::left;
  if (is_left ? left_.lifted : right_.lifted) return true;
  const double half_base_m = 0.5 * chassis_config_.wheel_base_m;
  return room_.has_cliffs() && room_.is_cliff(chassis_.in_room(0.0, is_left ? half_base_m : -half_base_m));
}

double Mechanics::kinetic_energy_j() const {
  return chassis_.kinetic_energy_j() + left_.unit.kinetic_energy_j() + right_.unit.kinetic_energy_j();
}

}  // namespace wheelwright::simulation
