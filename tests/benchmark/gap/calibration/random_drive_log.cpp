#include "tests/benchmark/gap/calibration/random_drive_log.hpp"

#include <array>
#include <cmath>

#include "model/free_run.hpp"

namespace wheelwright::calibration {
namespace {

constexpr double wheel_base_m = 0.235;
constexpr double metres_per_tick = 0.000444565;
constexpr double full_battery_v = 16.2;
constexpr double battery_fall_v_s = 0.012;

double uniform(double from, double to, Random& random) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

double normal(double deviation, Random& random) {
  return std::normal_distribution<double>(0.0, deviation)(random);
}

struct Segment {
  double duration_s = 0.0;
  WheelPair from;
  WheelPair to;
};

Segment random_segment(const WheelPair& before, double largest_m_s, Random& random) {
  enum { forward, backward, arc, spin, any, stop };
  std::discrete_distribution<int> kind{3.0, 2.0, 3.0, 2.0, 3.0, 1.0};
  const double speed = uniform(0.1, 1.0, random) * largest_m_s;
  const double side = uniform(-1.0, 1.0, random);
  Segment segment{uniform(0.4, 2.5, random), {}, {}};
  switch (kind(random)) {
    case forward:
      segment.to = {speed, speed};
      break;
    case backward:
      segment.to = {-speed, -speed};
      break;
    case arc:
      segment.to = {speed * std::min(1.0, 1.0 - side), speed * std::min(1.0, 1.0 + side)};
      break;
    case spin:
      segment.to = {std::copysign(speed, side), -std::copysign(speed, side)};
      break;
    case any:
      segment.to = {uniform(-largest_m_s, largest_m_s, random), uniform(-largest_m_s, largest_m_s, random)};
      break;
    default:
      segment.to = {};
      break;
  }
  const bool is_ramp = uniform(0.0, 1.0, random) < 0.2;
  segment.from = is_ramp ? before : segment.to;
  return segment;
}

std::int64_t counts(double distance_m) {
  return std::llround(distance_m / metres_per_tick);
}

}  // namespace

DriveLog random_commands(const DriveProgram& program, const std::string& name, Random& random) {
  DriveLog log;
  log.name = name;
  log.wheel_base_m = wheel_base_m;
  log.period_s = program.period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  Segment segment;
  double begin_s = 0.0;
  for (double t_s = 0.0; t_s < program.duration_s; t_s += program.period_s) {
    if (t_s >= begin_s + segment.duration_s) {
      begin_s = t_s;
      segment = random_segment(segment.to, program.largest_m_s, random);
    }
    const double share = (t_s - begin_s) / segment.duration_s;
    DriveSample sample;
    sample.t_s = t_s;
    sample.command_m_s = {std::lerp(segment.from.left, segment.to.left, share),
                          std::lerp(segment.from.right, segment.to.right, share)};
    sample.battery_v = full_battery_v - battery_fall_v_s * t_s;
    log.samples.push_back(sample);
  }
  return log;
}

DriveLog measured_drive(const RobotModel& model, DriveLog log, const DriveNoise& noise, Random& random) {
  const auto motion = free_run(model, log);
  WheelPair drifted_m;
  Pose pose = motion.front().pose;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    if (k > 0) {
      const double deviation_m = noise.drift_m_per_sqrt_s * std::sqrt(motion[k].t_s - motion[k - 1].t_s);
      const WheelPair step_m{normal(deviation_m, random), normal(deviation_m, random)};
      drifted_m = {drifted_m.left + step_m.left, drifted_m.right + step_m.right};
      Pose step = relative_to(motion[k - 1].pose, motion[k].pose);
      step.x_m += 0.5 * (step_m.left + step_m.right);
      step.theta_rad += (step_m.right - step_m.left) / log.wheel_base_m;
      pose = placed_at(pose, step);
    }
    DriveSample& sample = log.samples[k];
    sample.ticks = WheelTicks{counts(motion[k].distance_m.left + drifted_m.left),
                              counts(motion[k].distance_m.right + drifted_m.right)};
    sample.reference_x_m = pose.x_m + normal(noise.reference_m, random);
    sample.reference_y_m = pose.y_m + normal(noise.reference_m, random);
    sample.reference_theta_rad = pose.theta_rad + normal(noise.reference_rad, random);
  }
  return log;
}

}  // namespace wheelwright::calibration
