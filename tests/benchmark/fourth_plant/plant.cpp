#include "tests/benchmark/fourth_plant/plant.hpp"

#include <cmath>

namespace plants::fourth {

Plant::Plant(const Robot& robot, const Pose& start, double battery_v, const Random& random)
    : robot_(robot),
      noise_random_(random.child(0)),
      block_random_(random.child(1)),
      drives_{WheelDrive(robot.drives[left_side], fine_step_s),
              WheelDrive(robot.drives[right_side], fine_step_s)},
      dead_times_{DeadTime(robot.dead_time_s, fine_step_s), DeadTime(robot.dead_time_s, fine_step_s)},
      battery_(robot.battery, battery_v) {
  moment_.step_s = fine_step_s;
  moment_.battery_v = battery_v;
  moment_.pose = start;
  moment_.random = &block_random_;
  // A counter starts anywhere within a tick.
  for (double& counted_m : counted_m_) counted_m = noise_random_.uniform(0.0, robot.metres_per_tick);
}

void Plant::step(const PerWheel<double>& command_m_s) {
  PerWheel<double> asked_m_s{};
  for (const std::size_t wheel : {left_side, right_side})
    asked_m_s[wheel] = dead_times_[wheel](command_m_s[wheel], moment_);
  for (PairBlock& block : robot_.diagram.radio) asked_m_s = block(asked_m_s, moment_);
  const PerWheel<double> rolled_m_s{turn_wheel(left_side, asked_m_s[left_side]),
                                    turn_wheel(right_side, asked_m_s[right_side])};
  const double effort = 0.5 * (std::abs(rolled_m_s[left_side]) + std::abs(rolled_m_s[right_side]));
  roll(rolled_m_s);
  moment_.battery_v = battery_.step(effort / robot_.top_m_s, fine_step_s);
  moment_.time_s += fine_step_s;
}

// The speed at which the wheel rolls on the floor.
double Plant::turn_wheel(std::size_t wheel, double asked_m_s) {
  Diagram& diagram = robot_.diagram;
  const double wanted_m_s = through(diagram.command[wheel], asked_m_s, moment_);
  double speed_m_s = drives_[wheel].step(wanted_m_s, diagram.drive[wheel], diagram.load[wheel], moment_);
  speed_m_s += noise(wheel, speed_m_s);
  speed_m_s = through(diagram.gear[wheel], speed_m_s, moment_);
  counted_m_[wheel] += fine_step_s * through(diagram.count[wheel], speed_m_s, moment_);
  return through(diagram.floor[wheel], speed_m_s, moment_);
}

// Rough floors and gears shake a wheel while it turns and leave it alone while it stands.
double Plant::noise(std::size_t wheel, double speed_m_s) {
  constexpr double plain_m_s = 0.02;
  const double decay = std::exp(-fine_step_s / robot_.wheel_noise_memory_s);
  const double fresh_m_s = noise_random_.normal(robot_.wheel_noise_m_s * std::sqrt(1.0 - decay * decay));
  noise_m_s_[wheel] = decay * noise_m_s_[wheel] + fresh_m_s;
  return noise_m_s_[wheel] * std::tanh(std::abs(speed_m_s) / plain_m_s);
}

void Plant::roll(const PerWheel<double>& rolled_m_s) {
  Twist twist{0.5 * (rolled_m_s[left_side] + rolled_m_s[right_side]), 0.0,
              (rolled_m_s[right_side] - rolled_m_s[left_side]) / robot_.wheel_base_m};
  for (BodyBlock& block : robot_.diagram.body) twist = block(twist, moment_);
  const double turned_rad = twist.turn_rad_s * fine_step_s;
  Pose halfway = moment_.pose;
  halfway.heading_rad += 0.5 * turned_rad;
  const Pose moved = point_of_body(halfway, twist.forward_m_s * fine_step_s, twist.left_m_s * fine_step_s);
  moment_.pose = {moved.x_m, moved.y_m, halfway.heading_rad + 0.5 * turned_rad};
}

PerWheel<long> Plant::ticks() const {
  const auto counted = [this](std::size_t wheel) {
    return static_cast<long>(std::floor(counted_m_[wheel] / robot_.metres_per_tick));
  };
  return {counted(left_side), counted(right_side)};
}

}  // namespace plants::fourth
