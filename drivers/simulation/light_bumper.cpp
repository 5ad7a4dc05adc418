#include "drivers/simulation/light_bumper.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright::simulation {
namespace {

// Where the sensors sit, from straight ahead; the outer ones look almost sideways.
constexpr std::array<double, LightBumper::sensors> mount_rad{1.13, 0.66, 0.25, -0.25, -0.66, -1.13};

}  // namespace

double LightBumper::echo(const Chassis& body, const Room& room, double mount, double beam) const {
  const Point from =
      body.in_room(config_.mount_radius_m * std::cos(mount), config_.mount_radius_m * std::sin(mount));
  const Point ahead = body.heading();
  const double c = std::cos(mount + beam);
  const double s = std::sin(mount + beam);
  const RayHit hit = room.cast(from, {ahead.x_m * c - ahead.y_m * s, ahead.y_m * c + ahead.x_m * s});
  if (hit.distance_m >= config_.range_m) return 0.0;
  // Light spreads with the square of the distance, from a virtual source behind the window; a matt wall
  // reflects with the cosine of incidence. The amplifier fades out linearly at the end of the range.
  const double spread = config_.falloff_m / (config_.falloff_m + hit.distance_m);
  const double fade = std::min(1.0, 4.0 * (1.0 - hit.distance_m / config_.range_m));
  return config_.signal_at_contact * room.reflectance() * spread * spread * hit.cos_incidence * fade;
}

std::array<std::int32_t, LightBumper::sensors> LightBumper::look(const Chassis& body, const Room& room,
                                                                 Noise& noise) const {
  std::array<std::int32_t, sensors> signals{};
  const bool in_reach =
      room.nearest({body.pose().x_m, body.pose().y_m}).distance_m < config_.mount_radius_m + config_.range_m;
  for (std::size_t i = 0; i < sensors; ++i) {
    double signal = 0.0;
    if (in_reach && config_.beam_half_angle_rad > 0.0) {
      const double half = 0.6 * config_.beam_half_angle_rad;
      signal = 0.5 * echo(body, room, mount_rad[i], 0.0) + 0.25 * echo(body, room, mount_rad[i], half) +
               0.25 * echo(body, room, mount_rad[i], -half);
    } else if (in_reach) {
      signal = echo(body, room, mount_rad[i], 0.0);
    }
    if (config_.noise > 0.0) signal += config_.noise * noise.normal();
    signals[i] = static_cast<std::int32_t>(std::clamp(std::round(signal), 0.0, 4095.0));
  }
  return signals;
}

std::int32_t LightBumper::bits(const std::array<std::int32_t, sensors>& signals) const {
  std::int32_t bits = 0;
  for (std::size_t i = 0; i < sensors; ++i) {
    if (signals[i] >= static_cast<std::int32_t>(config_.threshold)) bits |= 1 << i;
  }
  return bits;
}

}  // namespace wheelwright::simulation
