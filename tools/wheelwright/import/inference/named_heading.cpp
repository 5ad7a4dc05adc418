#include "tools/wheelwright/import/inference/named_heading.hpp"

#include <numbers>
#include <optional>
#include <string>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/inference/floor_plane.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

void take_euler_angles(const Stream& stream, const Channel& heading, const Channel* roll,
                       ReferenceMapping& reference) {
  reference.theta = ChannelName{stream.name, heading.name};
  const std::string unit = meaning_of(stream, heading).unit;
  if (find_unit(angle_units(), unit)) reference.angle_unit = unit;
  if (roll == nullptr) return;
  constexpr double largest_rad = 7.0;
  const bool in_degrees = largest(roll->values) > largest_rad;
  if (!folds_heading(roll->values, heading.values, in_degrees ? 360.0 : 2.0 * std::numbers::pi)) return;
  reference.roll = ChannelName{stream.name, roll->name};
  if (in_degrees) reference.angle_unit = "deg";
}

// Beside a place, an angle that says no more is the heading.
void take_angle(const Named& x, ReferenceMapping& reference) {
  for (const Channel& channel : x.stream->channels) {
    const NameWords words(channel.name);
    const NameMeaning meaning = meaning_of(*x.stream, channel);
    if (!words.has_any({"phi", "angle", "rot", "rotation", "bearing", "azimuth", "course", "cog", "winkel",
                        "kurs", "richtung", "cap", "angulo", "rumbo", "angolo"}) ||
        words.has_any({"steer", "steering", "wheel", "joint", "motor", "rate", "vel", "speed", "roll",
                       "pitch", "odom"}) ||
        meaning.side != NamedSide::none || is_held(channel.values))
      continue;
    reference.theta = ChannelName{x.stream->name, channel.name};
    if (find_unit(angle_units(), meaning.unit)) reference.angle_unit = meaning.unit;
    return;
  }
}

}  // namespace

void take_quaternion(const Stream& stream, const std::array<const Channel*, 4>& xyzw, bool y_is_up,
                     ReferenceMapping& reference) {
  const auto name = [&stream](const Channel* channel) {
    return channel == nullptr ? std::nullopt : std::optional(ChannelName{stream.name, channel->name});
  };
  reference.qx = name(xyzw[y_is_up ? 2 : 0]);
  reference.qy = name(xyzw[y_is_up ? 0 : 1]);
  reference.qz = name(xyzw[y_is_up ? 1 : 2]);
  reference.qw = name(xyzw[3]);
}

void take_heading(const Named& x, bool y_is_up, bool has_heading, const NamedChannels& named,
                  ReferenceMapping& reference) {
  const auto part = [&](Quantity quantity) {
    const Named* found = named.beside(x, quantity);
    return found == nullptr ? nullptr : found->channel;
  };
  const Channel* about_x = part(Quantity::qx);
  const Channel* about_y = part(Quantity::qy);
  const Channel* about_z = part(Quantity::qz);
  const Channel* real = part(Quantity::qw);
  const Channel* about_height = y_is_up ? about_y : about_z;
  if (real != nullptr && about_height != nullptr) {
    take_quaternion(*x.stream, {about_x, about_y, about_z, real}, y_is_up, reference);
  } else if (has_heading) {
    const Named* theta = named.beside(x, Quantity::heading);
    reference.theta = theta->name();
    if (find_unit(angle_units(), theta->meaning.unit)) reference.angle_unit = theta->meaning.unit;
  } else if (about_height != nullptr) {
    take_euler_angles(*x.stream, *about_height, y_is_up ? about_x : nullptr, reference);
  } else {
    take_angle(x, reference);
  }
}

}  // namespace wheelwright::import
