#include "tests/support/gap_plant/plant_sensors.hpp"

#include <cmath>

namespace wheelwright::test {

PlantSensors::PlantSensors(const PlantParameters& robot, double period_s, bool wrap_heading,
                           std::uint64_t seed)
    : robot_(robot), period_s_(period_s), wrap_heading_(wrap_heading), random_(seed) {
  std::uniform_int_distribution<std::int64_t> start(-5000, 30000);  // as left over from drives before
  left_.offset = start(random_);
  right_.offset = start(random_);
}

// Counts that arrive while a burst of loss lasts are gone for good.
std::int64_t PlantSensors::count(Encoder& encoder, double rim_m) {
  const auto now = static_cast<std::int64_t>(std::floor(rim_m / robot_.metres_per_tick));
  if (robot_.dropout_share > 0.0) {
    const double starts_per_row = robot_.dropout_share * period_s_ / robot_.dropout_s;
    if (std::uniform_real_distribution<double>(0.0, 1.0)(random_) < starts_per_row) {
      const double lasts_s = std::exponential_distribution<double>(1.0 / robot_.dropout_s)(random_);
      encoder.lost_rows += 1 + static_cast<int>(lasts_s / period_s_);
    }
    if (encoder.lost_rows > 0) {
      --encoder.lost_rows;
      encoder.offset -= now - encoder.last;
    }
  }
  encoder.last = now;
  return now + encoder.offset;
}

void PlantSensors::measure(DriveSample& sample, const WheelPair& rim_m, const Pose& pose, const Twist& twist,
                           double battery_v) {
  sample.ticks = WheelTicks{count(left_, rim_m.left), count(right_, rim_m.right)};
  const double cosine = std::cos(pose.theta_rad);
  const double sine = std::sin(pose.theta_rad);
  const Pose& point = robot_.measured_point;
  sample.reference_x_m = pose.x_m + cosine * point.x_m - sine * point.y_m + noise(robot_.reference_noise_m);
  sample.reference_y_m = pose.y_m + sine * point.x_m + cosine * point.y_m + noise(robot_.reference_noise_m);
  const double heading = pose.theta_rad + noise(robot_.reference_noise_rad);
  sample.reference_theta_rad = wrap_heading_ ? wrap_angle(heading) : heading;
  sample.gyro_z_rad_s = twist.w_rad_s + robot_.gyro_bias_rad_s + noise(robot_.gyro_noise_rad_s);
  sample.battery_v = battery_v + noise(robot_.battery_noise_v);
}

}  // namespace wheelwright::test
