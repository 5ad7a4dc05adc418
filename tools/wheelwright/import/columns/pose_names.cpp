#include "tools/wheelwright/import/columns/pose_names.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace wheelwright::import {
namespace {

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool is_x(std::string_view last) {
  return is_one_of(last, {"x", "px", "tx", "cx", "posx", "xpos"});
}
bool is_y(std::string_view last) {
  return is_one_of(last, {"y", "py", "ty", "cy", "posy", "ypos"});
}

// Never of what was measured.
bool is_of_a_goal(const NameWords& words) {
  return words.has_any({"goal", "target", "tgt", "des", "desired", "wanted", "waypoint", "wp", "setpoint",
                        "planned", "plan", "next", "soll", "consigne"});
}

bool is_place_to_go(const NameWords& words) {
  if (!is_of_a_goal(words) || words.has_any({"vel", "velocity", "speed", "linear", "angular", "v", "acc"}))
    return false;
  return is_x(words.last()) || is_y(words.last()) || words.has_any({"x", "y"});
}

bool has_place_to_go(const Stream& stream) {
  return std::ranges::any_of(stream.channels,
                             [](const Channel& channel) { return is_place_to_go(NameWords(channel.name)); });
}

bool is_heading(const NameWords& words) {
  return words.has_any(
      {"theta", "yaw", "heading", "psi", "th", "orientation", "hdg", "compass", "bearing", "head"});
}

// A quaternion, or turns about the axes.
std::optional<Quantity> part_of_rotation(const NameWords& words) {
  const auto last = words.last();
  const bool is_rotation =
      words.has_any({"orientation", "rotation", "quaternion", "quat", "q", "rot", "euler", "eulerangles"});
  if (last == "qx" || last == "rx" || (is_rotation && last == "x")) return Quantity::qx;
  if (last == "qy" || last == "ry" || (is_rotation && last == "y")) return Quantity::qy;
  if (last == "qz" || last == "rz" || (is_rotation && last == "z")) return Quantity::qz;
  if (last == "qw" || last == "rw" || (is_rotation && last == "w")) return Quantity::qw;
  return std::nullopt;
}

// "lat" beside a longitude: alone it is lateral.
std::optional<Quantity> on_the_globe(const NameWords& words, const Stream& stream) {
  const auto any_has = [&stream](std::initializer_list<std::string_view> of) {
    return std::ranges::any_of(stream.channels,
                               [&](const Channel& channel) { return NameWords(channel.name).has_any(of); });
  };
  if (words.has_any({"err", "error", "std", "sigma", "var", "covariance"})) return std::nullopt;
  if (words.has_any({"latitude", "lat"}) && any_has({"longitude", "lon", "lng", "long"}))
    return Quantity::latitude;
  if (words.has_any({"longitude", "lon", "lng", "long"}) && any_has({"latitude", "lat"}))
    return Quantity::longitude;
  return std::nullopt;
}

// "pos_n", "ned.e".
bool is_direction_of_place(const NameWords& words, std::string_view letter) {
  return words.words().size() == 2 && words.last() == letter &&
         is_one_of(words.words().front(), {"pos", "position", "p", "ned", "local"});
}

}  // namespace

bool is_northward(const NameWords& words) {
  return words.has_any({"north", "northing"}) || is_direction_of_place(words, "n");
}

bool is_eastward(const NameWords& words) {
  return words.has_any({"east", "easting"}) || is_direction_of_place(words, "e");
}

bool may_be_wanted(const NameWords& words) {
  return words.has_any({"ref", "reference", "path", "traj", "trajectory"}) ||
         (words.words().size() == 2 && words.last() == "d");
}

std::optional<Quantity> pose_quantity(const NameWords& words, bool is_command, const Stream& stream) {
  const auto last = words.last();
  const bool is_rate = words.has_any({"linear", "angular", "twist", "velocity", "vel", "speed", "rate", "acc",
                                      "accel", "acceleration", "force", "gyro", "mag", "dot"});
  if (is_rate) return std::nullopt;
  if (const auto part = part_of_rotation(words)) return part;
  if (is_place_to_go(words)) return Quantity::wanted;
  if (is_of_a_goal(words) && is_heading(words) && has_place_to_go(stream)) return Quantity::wanted;
  if (is_command) return std::nullopt;
  if (const auto known = on_the_globe(words, stream)) return known;
  const bool of_source = words.words().size() == 2;  // "x_odom", "y_ref"
  if (of_source && words.words().front() == "x") return Quantity::x;
  if (of_source && words.words().front() == "y") return Quantity::y;
  if (is_x(last)) return Quantity::x;
  if (is_y(last)) return Quantity::y;
  if (is_northward(words)) return Quantity::x;
  if (is_eastward(words)) return Quantity::y;
  if (is_heading(words)) return Quantity::heading;
  return std::nullopt;
}

}  // namespace wheelwright::import
