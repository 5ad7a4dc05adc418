#include "tools/wheelwright/import/inference/named_roles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/column_shapes.hpp"
#include "tools/wheelwright/import/inference/name_words.hpp"
#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/inference/named_reference.hpp"
#include "tools/wheelwright/import/inference/units/battery_unit.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

class ByNames {
 public:
  ByNames(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& findings)
      : recordings_(recordings), named_(recordings, mapping), mapping_(mapping), findings_(findings) {}

  void run() {
    if (!mapping_.wheels) find_wheels();
    if (!mapping_.command) find_command();
    if (!mapping_.wheels) find_body_motion();
    if (!mapping_.reference)
      mapping_.reference = find_named_reference(recordings_, named_, mapping_.wheels.has_value(), findings_);
    find_scalar(mapping_.gyro, Quantity::gyro, angular_units());
    const bool is_given = mapping_.battery.has_value();
    find_scalar(mapping_.battery, Quantity::battery, voltage_units());
    if (!is_given) check_battery(recordings_, mapping_, findings_);
    if (!mapping_.time.column) find_time();
  }

  void find_wheels() {
    struct Kind {
      Quantity quantity;
      WheelKind kind;
    };
    constexpr Kind kinds[] = {{Quantity::count, WheelKind::counts},
                              {Quantity::angle, WheelKind::angle},
                              {Quantity::distance, WheelKind::distance},
                              {Quantity::speed, WheelKind::speed}};
    for (const auto& [quantity, kind] : kinds) {
      if (const auto found = named_.sides(quantity, findings_))
        return take_wheels(kind, found->first, found->second);
    }
    for (const auto& [quantity, kind] : kinds) {
      if (const auto two = named_.numbered_pair(quantity, findings_))
        return take_wheels(kind, two->first, two->second);
    }
    for (const auto& [quantity, kind] : kinds) {
      // Of several without a side nobody knows which is which.
      if (named_.all(quantity, NamedSide::none).size() > 1) continue;
      if (const auto found = named_.single(quantity)) return take_wheels(kind, *found, std::nullopt);
    }
  }

  static bool is_per_row(const Named& named) {
    const NameWords words(named.channel->name);
    if (words.words().size() == 2 && words.words().front() == "d") return true;
    return words.has_any(
        {"delta", "diff", "inc", "increment", "increments", "dticks", "dcount", "dcounts", "dcnt", "denc"});
  }

  // Of a wheel: an omega that is faster than any robot in m/s.
  static bool is_turn_rate(const Named& named) {
    return NameWords(named.channel->name).has_any({"omega", "w"}) &&
           largest(named.channel->values) > fastest_m_s;
  }

  void take_wheels(WheelKind kind, const Named& left, const std::optional<Named>& right) {
    WheelMapping wheels;
    wheels.kind = kind;
    wheels.left = left.name();
    if (right) wheels.right = right->name();
    wheels.unit = left.meaning.unit;
    // Parts of a count are none.
    wheels.per_row = is_per_row(left);
    if (kind == WheelKind::counts && !are_whole(left.channel->values))
      wheels.kind = wheels.per_row ? WheelKind::distance : WheelKind::angle;
    if (wheels.kind == WheelKind::counts) wheels.unit.clear();
    const std::span<const Unit> units = wheels.kind == WheelKind::speed      ? speed_units()
                                        : wheels.kind == WheelKind::distance ? distance_units()
                                                                             : angle_units();
    if (wheels.kind != WheelKind::counts && !find_unit(units, wheels.unit)) {
      const bool turns = wheels.kind == WheelKind::speed && is_turn_rate(left);
      wheels.unit = turns ? "rad/s" : units.front().name;
      wheels.unit_assumed = !turns;
    }
    mapping_.wheels = wheels;
  }

  void find_command() {
    if (take_radius() || take_curvature()) return;
    if (const auto found = named_.sides(Quantity::command, findings_))
      return take_signed(CommandKind::wheels, found->first, found->second);
    if (const auto found = named_.sides(Quantity::duty, findings_))
      return take_signed(CommandKind::duty, found->first, found->second);
    for (const auto& [quantity, kind] :
         {std::pair{Quantity::command, CommandKind::wheels}, {Quantity::duty, CommandKind::duty}}) {
      if (const auto two = named_.numbered_pair(quantity, findings_))
        return take_signed(kind, two->first, two->second);
    }
    if (take_throttle()) return;
    const auto linear = named_.all(Quantity::linear_command, NamedSide::none);
    auto angular = named_.all(Quantity::angular_command, NamedSide::none);
    for (const auto& steering : named_.all(Quantity::steering, NamedSide::none)) angular.push_back(steering);
    if (const auto found = NamedChannels::pair(linear, angular, findings_)) {
      return take_command(CommandKind::twist, found->first, found->second);
    }
    // Speeds of the body beside wheels or places that were measured, and held: they are what was asked for.
    const auto speeds = named_.all(Quantity::linear_speed, NamedSide::none);
    if (const auto found =
            NamedChannels::pair(speeds, named_.all(Quantity::angular_speed, NamedSide::none), findings_);
        found && (mapping_.wheels || has_places()) && is_held(found->first.channel->values)) {
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
    if (!linear.empty()) take_command(CommandKind::wheels, linear.front(), std::nullopt);
  }

  bool has_places() const {
    return !named_.all(Quantity::x, NamedSide::none).empty() &&
           !named_.all(Quantity::y, NamedSide::none).empty();
  }

  // With the bits of direction beside it.
  void take_signed(CommandKind kind, const Named& left, const Named& right) {
    take_command(kind, left, right);
    const bool has_sign = std::ranges::any_of(left.channel->values, [](double duty) { return duty < 0.0; });
    auto bits = named_.sides(Quantity::direction, findings_);
    if (!bits) bits = named_.numbered_pair(Quantity::direction, findings_);
    if (const auto both = named_.single(Quantity::direction); both && !bits) bits = NamedPair{*both, *both};
    if (!bits || has_sign || !is_bit(*bits->first.channel) || !is_bit(*bits->second.channel)) return;
    mapping_.command->direction = {bits->first.name(), bits->second.name()};
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
    mapping_.command->by_radius = true;
    mapping_.command->unit = "mm/s";
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
    mapping_.command->by_radius = true;
    mapping_.command->by_curvature = true;
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
    mapping_.command = command;
  }

  // Forward and turning speed that the robot measured itself: odometry.
  void find_body_motion() {
    const auto turning = named_.all(Quantity::angular_speed, NamedSide::none);
    const auto found =
        NamedChannels::pair(named_.all(Quantity::linear_speed, NamedSide::none), turning, findings_);
    if (!found || (mapping_.command && mapping_.command->first == found->first.name())) return;
    take_wheels(WheelKind::speed, found->first, found->second);
    mapping_.wheels->body_motion = true;
    findings_.push_back("no wheels: forward and turning speed " + found->first.name().text() + " and " +
                        found->second.name().text() + " stand in for them");
  }

  void find_scalar(std::optional<ScalarMapping>& scalar, Quantity quantity,
                   std::span<const Unit> units) const {
    const auto found = named_.all(quantity, NamedSide::none);
    if (scalar || found.empty()) return;
    const std::string& unit = found.front().meaning.unit;
    const bool is_stated = find_unit(units, unit).has_value();
    scalar = ScalarMapping{found.front().name(), is_stated ? unit : std::string(units.front().name)};
    scalar->unit_is_stated = is_stated || !found.front().stream->type.empty();  // of messages: SI
  }

  // A column of the stream that holds the wheels, else the commands, else the reference.
  void find_time() {
    const Stream* stream = nullptr;
    if (mapping_.reference && mapping_.reference->x)
      stream = find_channel(recordings_, *mapping_.reference->x).stream;
    if (mapping_.command) stream = find_channel(recordings_, mapping_.command->first).stream;
    if (mapping_.wheels) stream = find_channel(recordings_, mapping_.wheels->left).stream;
    const Named* found = nullptr;
    for (const auto& named : named_.list()) {
      if (named.meaning.quantity != Quantity::time || named.stream != stream) continue;
      if (!named.stream->received_s.empty()) return;  // stamps of messages are found by themselves
      const bool is_simulated = NameWords(named.channel->name).has_any({"sim", "simulation", "simulated"});
      if (found == nullptr || is_simulated) found = &named;
      if (is_simulated) break;  // a simulator's robot moves by its time, not by that of the wall
    }
    if (found != nullptr) {
      mapping_.time.column = ChannelName{"", found->channel->name};
      return;
    }
    if (stream == nullptr || !stream->received_s.empty()) return;
    const auto frames = std::ranges::find_if(stream->channels, counts_frames);
    if (frames != stream->channels.end()) mapping_.time.column = ChannelName{"", frames->name};
  }

  std::span<const Recording> recordings_;
  NamedChannels named_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
};

}  // namespace

void set_kind_of_stated_wheels(std::span<const Recording> recordings, const GivenMapping& given,
                               Mapping& mapping) {
  if (!mapping.wheels || given.says("wheels.kind") || mapping.wheels->kind != WheelKind::counts) return;
  const FoundChannel found = find_channel(recordings, mapping.wheels->left);
  if (found.channel == nullptr) return;
  const NameMeaning meaning = meaning_of(*found.stream, *found.channel);
  const auto take = [&](WheelKind kind, std::span<const Unit> units) {
    mapping.wheels->kind = kind;
    if (given.says("wheels.unit")) return;
    mapping.wheels->unit_assumed = !find_unit(units, meaning.unit);
    mapping.wheels->unit = mapping.wheels->unit_assumed ? std::string(units.front().name) : meaning.unit;
  };
  if (meaning.quantity == Quantity::speed || meaning.quantity == Quantity::command) {
    take(WheelKind::speed, speed_units());
  } else if (meaning.quantity == Quantity::angle ||
             (given.says("wheels.wheel_radius_m") && !are_whole(found.channel->values))) {
    take(WheelKind::angle, angle_units());
  } else if (meaning.quantity == Quantity::distance) {
    take(WheelKind::distance, distance_units());
  }
}

void map_by_names(std::span<const Recording> recordings, Mapping& mapping,
                  std::vector<std::string>& findings) {
  ByNames(recordings, mapping, findings).run();
}

}  // namespace wheelwright::import
