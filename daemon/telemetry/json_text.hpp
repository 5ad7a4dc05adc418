// Pieces of JSON in the forms of Foxglove's schemas.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "config/load/text_format.hpp"
#include "model/geometry/pose.hpp"

namespace wheelwright::daemon::telemetry {

// JSON knows no infinity and nothing undefined: null.
inline std::string number(double value, int decimals) {
  return std::isfinite(value) ? config::fixed_number(value, decimals) : "null";
}

inline std::string flag(bool value) {
  return value ? "true" : "false";
}

// A text in double quotes; bytes that are no UTF-8 are replaced.
std::string json_quoted(std::string_view text);

// {"sec":..,"nsec":..}
inline std::string time_text(std::uint64_t time_ns) {
  constexpr std::uint64_t second = 1'000'000'000;
  return R"({"sec":)" + std::to_string(time_ns / second) + R"(,"nsec":)" + std::to_string(time_ns % second) +
         "}";
}

// A point of the floor, with four decimals: a tenth of a millimetre.
inline std::string point_text(double x_m, double y_m, double z_m = 0.0) {
  return R"({"x":)" + number(x_m, 4) + R"(,"y":)" + number(y_m, 4) + R"(,"z":)" + number(z_m, 3) + "}";
}

// A turn about the vertical as a quaternion.
inline std::string turn_text(double theta_rad) {
  return R"({"x":0,"y":0,"z":)" + number(std::sin(0.5 * theta_rad), 6) + R"(,"w":)" +
         number(std::cos(0.5 * theta_rad), 6) + "}";
}

inline std::string pose_text(const Pose& pose, double z_m = 0.0) {
  return R"({"position":)" + point_text(pose.x_m, pose.y_m, z_m) + R"(,"orientation":)" +
         turn_text(pose.theta_rad) + "}";
}

}  // namespace wheelwright::daemon::telemetry
