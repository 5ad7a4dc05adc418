#include "tools/wheelwright/import/inference/named_roles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/name_words.hpp"
#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/inference/named_reference.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

class ByNames {
 public:
  ByNames(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& findings)
      : recordings_(recordings), named_(recordings), mapping_(mapping), findings_(findings) {}

  void run() {
    if (!mapping_.wheels) find_wheels();
    if (!mapping_.command) find_command();
    if (!mapping_.wheels) find_body_motion();
    if (!mapping_.reference)
      mapping_.reference = find_named_reference(recordings_, named_, mapping_.wheels.has_value(), findings_);
    find_scalar(mapping_.gyro, Quantity::gyro, angular_units());
    find_scalar(mapping_.battery, Quantity::battery, voltage_units());
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

  static bool are_whole(const std::vector<double>& values) {
    return std::ranges::all_of(
        values, [](double value) { return !std::isfinite(value) || value == std::round(value); });
  }

  static bool is_per_row(const Named& named) {
    return NameWords(named.channel->name)
        .has_any({"delta", "diff", "inc", "increment", "increments", "dticks"});
  }

  void take_wheels(WheelKind kind, const Named& left, const std::optional<Named>& right) {
    WheelMapping wheels;
    wheels.kind = kind;
    wheels.left = left.name();
    if (right) wheels.right = right->name();
    wheels.unit = left.meaning.unit;
    // Parts of a count are none.
    if (kind == WheelKind::counts && !are_whole(left.channel->values)) wheels.kind = WheelKind::angle;
    wheels.per_row = is_per_row(left);
    if (wheels.kind == WheelKind::counts) wheels.unit.clear();
    const std::span<const Unit> units = wheels.kind == WheelKind::speed      ? speed_units()
                                        : wheels.kind == WheelKind::distance ? distance_units()
                                                                             : angle_units();
    if (wheels.kind != WheelKind::counts && !find_unit(units, wheels.unit)) {
      wheels.unit = units.front().name;
      wheels.unit_assumed = true;
    }
    mapping_.wheels = wheels;
  }

  void find_command() {
    if (const auto found = named_.sides(Quantity::command, findings_))
      return take_command(CommandKind::wheels, found->first, found->second);
    if (const auto found = named_.sides(Quantity::duty, findings_))
      return take_command(CommandKind::duty, found->first, found->second);
    for (const auto& [quantity, kind] :
         {std::pair{Quantity::command, CommandKind::wheels}, {Quantity::duty, CommandKind::duty}}) {
      if (const auto two = named_.numbered_pair(quantity, findings_))
        return take_command(kind, two->first, two->second);
    }
    const auto linear = named_.all(Quantity::linear_command, NamedSide::none);
    if (const auto found =
            NamedChannels::pair(linear, named_.all(Quantity::angular_command, NamedSide::none), findings_)) {
      return take_command(CommandKind::twist, found->first, found->second);
    }
    // Speeds of the body beside wheels that were measured, and held: they are what was asked for.
    const auto speeds = named_.all(Quantity::linear_speed, NamedSide::none);
    if (const auto found =
            NamedChannels::pair(speeds, named_.all(Quantity::angular_speed, NamedSide::none), findings_);
        found && mapping_.wheels && is_held(found->first.channel->values)) {
      findings_.push_back(found->first.name().text() + " and " + found->second.name().text() +
                          " are held for most rows and are taken for commands");
      return take_command(CommandKind::twist, found->first, found->second);
    }
    if (const auto found = named_.single(Quantity::duty))
      return take_command(CommandKind::duty, *found, std::nullopt);
    if (const auto found = named_.single(Quantity::command))
      return take_command(CommandKind::wheels, *found, std::nullopt);
    if (!linear.empty()) take_command(CommandKind::wheels, linear.front(), std::nullopt);
  }

  void take_command(CommandKind kind, const Named& first, const std::optional<Named>& second) {
    CommandMapping command;
    command.kind = kind;
    command.first = first.name();
    if (second) command.second = second->name();
    if (!first.meaning.unit.empty() && find_unit(speed_units(), first.meaning.unit))
      command.unit = first.meaning.unit;
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
    scalar =
        ScalarMapping{found.front().name(), find_unit(units, unit) ? unit : std::string(units.front().name)};
  }

  // A column of the stream that holds the wheels, else the commands, else the reference.
  void find_time() {
    const Stream* stream = nullptr;
    if (mapping_.reference && mapping_.reference->x)
      stream = find_channel(recordings_, *mapping_.reference->x).stream;
    if (mapping_.command) stream = find_channel(recordings_, mapping_.command->first).stream;
    if (mapping_.wheels) stream = find_channel(recordings_, mapping_.wheels->left).stream;
    for (const auto& named : named_.list()) {
      if (named.meaning.quantity != Quantity::time || named.stream != stream) continue;
      if (!named.stream->received_s.empty()) return;  // stamps of messages are found by themselves
      mapping_.time.column = ChannelName{"", named.channel->name};
      return;
    }
  }

  std::span<const Recording> recordings_;
  NamedChannels named_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
};

}  // namespace

void map_by_names(std::span<const Recording> recordings, Mapping& mapping,
                  std::vector<std::string>& findings) {
  ByNames(recordings, mapping, findings).run();
}

bool is_held(const std::vector<double>& values) {
  constexpr double most_changes = 0.3;  // of the rows
  std::size_t changes = 0;
  std::size_t count = 0;
  double last = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (count > 0 && value != last) ++changes;
    last = value;
    ++count;
  }
  return changes > 0 && static_cast<double>(changes) < most_changes * static_cast<double>(count);
}

}  // namespace wheelwright::import
