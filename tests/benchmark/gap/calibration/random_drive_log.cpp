#include "tests/benchmark/gap/calibration/random_drive_log.hpp"

#include <array>
#include <cmath>

#include "model/simulation/model_simulation.hpp"

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

WheelPair rolled_m(const DriveLog& log) {
  const WheelTicks& last = *log.samples.back().ticks;
  return {static_cast<double>(last.left) * metres_per_tick,
          static_cast<double>(last.right) * metres_per_tick};
}

DriveLog measured_drive(const RobotModel& model, DriveLog log, const DriveNoise& noise,
                        const WheelPair& initial_travel_m, Random& random) {
  ModelSimulation simulation(model);
  simulation.reset({}, initial_travel_m);
  const double deviation_m = noise.drift_m_per_sqrt_s * std::sqrt(log.period_s);
  for (DriveSample& sample : log.samples) {
    const WheelPair distance_m = simulation.distance_m();
    sample.ticks = WheelTicks{counts(distance_m.left), counts(distance_m.right)};
    const Pose pose = simulation.observed_pose();
    sample.reference_x_m = pose.x_m + normal(noise.reference_m, random);
    sample.reference_y_m = pose.y_m + normal(noise.reference_m, random);
    sample.reference_theta_rad = pose.theta_rad + normal(noise.reference_rad, random);
    simulation.step(sample.command_m_s, *sample.battery_v);
    const WheelPair drift_m{normal(deviation_m, random), normal(deviation_m, random)};
    simulation.set_pose(compose(simulation.pose(), {0.5 * (drift_m.left + drift_m.right), 0.0,
                                                    (drift_m.right - drift_m.left) / log.wheel_base_m}));
    const WheelPair& way_m = simulation.distance_m();
    simulation.set_distance_m({way_m.left + drift_m.left, way_m.right + drift_m.right});
  }
  return log;
}

}  // namespace wheelwright::calibration
