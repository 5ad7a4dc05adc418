#include "tools/wheelwright/import/inference/named_commands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

class CommandFinder {
 public:
  CommandFinder(const NamedChannels& named, bool has_wheels, std::vector<std::string>& findings)
      : named_(named), has_wheels_(has_wheels), findings_(findings) {}

  std::optional<CommandMapping> find() {
    find_command();
    return std::move(found_);
  }

 private:
  void find_command() {
    if (take_radius() || take_curvature()) return;
    if (const auto found = named_.sides(Quantity::command, findings_))
      return take_signed(CommandKind::wheels, found->first, found->second);
    if (const auto two = named_.numbered_pair(Quantity::command, findings_))
      return take_signed(CommandKind::wheels, two->first, two->second);
    // What a controller in the robot makes of a speed is no command to it.
    if (take_twist()) return;
    if (const auto found = named_.sides(Quantity::duty, findings_))
      return take_signed(CommandKind::duty, found->first, found->second);
    if (const auto two = named_.numbered_pair(Quantity::duty, findings_))
      return take_signed(CommandKind::duty, two->first, two->second);
    if (take_throttle()) return;
    // "axis0.input_vel" and "axis1.input_vel" beside wheels that are called so.
    if (has_wheels_) {
      if (const auto two = named_.numbered_pair(Quantity::linear_command, findings_))
        return take_signed(CommandKind::wheels, two->first, two->second);
    }
    // Speeds of the body beside places that were measured, and held: they are what was asked for. Beside
    // wheels these show it (leading_speeds.hpp).
    const auto speeds = named_.all(Quantity::linear_speed, NamedSide::none);
    if (const auto found =
            NamedChannels::pair(speeds, named_.all(Quantity::angular_speed, NamedSide::none), findings_);
        found && !has_wheels_ && named_.has_places() && is_held(found->first.channel->values) &&
        !was_measured(*found->first.channel)) {
      findings_.push_back(found->first.name().text() + " and " + found->second.name().text() +
                          " are held for most rows and are taken for commands");
      return take_command(CommandKind::twist, found->first, found->second);
    }
    for (const Quantity quantity : {Quantity::throttle, Quantity::duty}) {
      if (const auto found = named_.single(quantity))
        return take_command(CommandKind::duty, *found, std::nullopt);
    }
    if (const auto found = named_.single(Quantity::command))
      return take_command(CommandKind::wheels, *found, std::nullopt);
    const auto linear = named_.all(Quantity::linear_command, NamedSide::none);
    if (!linear.empty()) take_command(CommandKind::wheels, linear.front(), std::nullopt);
  }

  bool take_twist() {
    const auto linear = named_.all(Quantity::linear_command, NamedSide::none);
    auto angular = named_.all(Quantity::angular_command, NamedSide::none);
    for (const auto& steering : named_.all(Quantity::steering, NamedSide::none)) angular.push_back(steering);
    const auto found = NamedChannels::pair(linear, angular, findings_);
    if (found) take_command(CommandKind::twist, found->first, found->second);
    return found.has_value();
  }

  static bool was_measured(const Channel& channel) {
    return NameWords(channel.name)
        .has_any({"odom", "odometry", "meas", "measured", "act", "actual", "est", "estimated", "fb",
                  "feedback", "enc", "encoder", "filtered", "real", "current", "ist", "ekf", "state"});
  }

  // With the bits of direction beside it.
  void take_signed(CommandKind kind, const Named& left, const Named& right) {
    take_command(kind, left, right);
    const bool has_sign = std::ranges::any_of(left.channel->values, [](double duty) { return duty < 0.0; });
    auto bits = named_.sides(Quantity::direction, findings_);
    if (!bits) bits = named_.numbered_pair(Quantity::direction, findings_);
    if (const auto both = named_.single(Quantity::direction); both && !bits) bits = NamedPair{*both, *both};
    if (!bits || has_sign || !is_bit(*bits->first.channel) || !is_bit(*bits->second.channel)) return;
    found_->direction = {bits->first.name(), bits->second.name()};
    findings_.push_back(bits->first.name().text() + " and " + bits->second.name().text() +
                        " are taken for the direction of the commands, 1 for forward");
  }

  // Two values, one of them 1; or 1 and -1, and 0 for neither.
  static bool is_bit(const Channel& channel) {
    const bool is_signed = std::ranges::find(channel.values, -1.0) != channel.values.end();
    double other = 1.0;
    for (const double value : channel.values) {
      if (!std::isfinite(value) || value == 1.0 || (is_signed && value == 0.0)) continue;
      if (other != 1.0 && value != other) return false;
      other = value;
    }
    return other != 1.0 && std::abs(other) <= 2.0;
  }

  // A velocity and the radius of the turn, in whole millimetres, as a Create takes them.
  bool take_radius() {
    constexpr double smallest_mm = 100.0;
    const auto radii = named_.all(Quantity::radius, NamedSide::none);
    auto velocities = named_.all(Quantity::linear_command, NamedSide::none);
    for (const auto& speed : named_.all(Quantity::linear_speed, NamedSide::none)) velocities.push_back(speed);
    const auto found = NamedChannels::pair(velocities, radii, findings_);
    if (!found || !are_whole(found->second.channel->values) || !are_whole(found->first.channel->values) ||
        largest(found->second.channel->values) < smallest_mm)
      return false;
    take_command(CommandKind::wheels, found->first, found->second);
    found_->by_radius = true;
    found_->unit = "mm/s";
    findings_.push_back("commands are a velocity and the radius of the turn, in mm/s and mm: " +
                        found->first.name().text() + " and " + found->second.name().text());
    return true;
  }

  // A velocity and one over the radius of the turn, in 1/m.
  bool take_curvature() {
    auto velocities = named_.all(Quantity::linear_command, NamedSide::none);
    for (const auto& speed : named_.all(Quantity::linear_speed, NamedSide::none)) velocities.push_back(speed);
    const auto found =
        NamedChannels::pair(velocities, named_.all(Quantity::curvature, NamedSide::none), findings_);
    if (!found) return false;
    take_command(CommandKind::wheels, found->first, found->second);
    found_->by_radius = true;
    found_->by_curvature = true;
    findings_.push_back("commands are a velocity and a curvature, in 1/m: " + found->first.name().text() +
                        " and " + found->second.name().text());
    return true;
  }

  // Throttle and steering of a remote control, mixed to the two wheels by the robot.
  bool take_throttle() {
    const auto throttle = named_.all(Quantity::throttle, NamedSide::none);
    auto steering = named_.all(Quantity::steering, NamedSide::none);
    for (const auto& turning : named_.all(Quantity::angular_command, NamedSide::none))
      steering.push_back(turning);
    const auto found = NamedChannels::pair(throttle, steering, findings_);
    if (found) take_command(CommandKind::throttle, found->first, found->second);
    return found.has_value();
  }

  void take_command(CommandKind kind, const Named& first, const std::optional<Named>& second) {
    CommandMapping command;
    command.kind = kind;
    command.first = first.name();
    if (second) command.second = second->name();
    if (!first.meaning.unit.empty() && find_unit(speed_units(), first.meaning.unit)) {
      command.unit = first.meaning.unit;
    } else if (kind == CommandKind::wheels && is_turn_rate(first)) {
      command.unit = "rad/s";
    }
    if (kind == CommandKind::twist && second && find_unit(angular_units(), second->meaning.unit)) {
      command.angular_unit = second->meaning.unit;
    }
    found_ = std::move(command);
  }

  const NamedChannels& named_;
  bool has_wheels_;
  std::vector<std::string>& findings_;
  std::optional<CommandMapping> found_;
};

}  // namespace

std::optional<CommandMapping> find_named_command(const NamedChannels& named, bool has_wheels,
                                                 std::vector<std::string>& findings) {
  return CommandFinder(named, has_wheels, findings).find();
}

}  // namespace wheelwright::import
