#include "tools/wheelwright/import/inference/named_roles.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/column_names.hpp"
#include "tools/wheelwright/import/inference/name_words.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

struct Named {
  const Stream* stream;
  const Channel* channel;
  NameMeaning meaning;

  ChannelName name() const { return {stream->name, channel->name}; }
};

struct NamedPair {
  Named first;
  Named second;
};

std::vector<Named> read_names(std::span<const Recording> recordings) {
  std::vector<Named> named;
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      for (const auto& channel : stream.channels) {
        const NameMeaning meaning = meaning_of(stream, channel);
        if (meaning.quantity != Quantity::unknown) named.push_back({&stream, &channel, meaning});
      }
    }
  }
  return named;
}

class ByNames {
 public:
  ByNames(std::span<const Recording> recordings, Mapping& mapping, std::vector<std::string>& findings)
      : recordings_(recordings), named_(read_names(recordings)), mapping_(mapping), findings_(findings) {}

  void run() {
    if (!mapping_.wheels) find_wheels();
    if (!mapping_.command) find_command();
    if (!mapping_.wheels) find_body_motion();
    if (!mapping_.reference) find_reference();
    find_scalar(mapping_.gyro, Quantity::gyro, angular_units());
    find_scalar(mapping_.battery, Quantity::battery, voltage_units());
    if (!mapping_.time.column) find_time();
  }

 private:
  std::vector<Named> all(Quantity quantity, NamedSide side) const {
    std::vector<Named> result;
    for (const auto& named : named_) {
      if (named.meaning.quantity == quantity && named.meaning.side == side) result.push_back(named);
    }
    return result;
  }

  // The first two of one stream; says where there are others.
  std::optional<NamedPair> pair(const std::vector<Named>& first, const std::vector<Named>& second) {
    std::optional<NamedPair> found;
    std::string others;
    for (const auto& a : first) {
      const auto b = std::ranges::find(second, a.stream, &Named::stream);
      if (b == second.end()) continue;
      if (!found) {
        found = NamedPair{a, *b};
      } else if (a.stream != found->first.stream) {
        others += (others.empty() ? "" : ", ") + a.name().text();
      }
    }
    if (found && !others.empty()) {
      findings_.push_back(found->first.name().text() + " was taken; there are also " + others);
    }
    return found;
  }
  std::optional<NamedPair> sides(Quantity quantity) {
    return pair(all(quantity, NamedSide::left), all(quantity, NamedSide::right));
  }
  // A wheel alone, by its side or without one.
  std::optional<Named> single(Quantity quantity) const {
    for (const NamedSide side : {NamedSide::none, NamedSide::left, NamedSide::right}) {
      const auto found = all(quantity, side);
      if (!found.empty()) return found.front();
    }
    return std::nullopt;
  }

  // Two columns that differ by 1 and 2 alone: "m1_counts" and "m2_counts".
  std::optional<NamedPair> numbered_pair(Quantity quantity) {
    const auto candidates = all(quantity, NamedSide::none);
    for (const auto& first : candidates) {
      for (const auto& second : candidates) {
        std::string expected = first.channel->name;
        const auto digit = expected.find('1');
        if (digit == std::string::npos) continue;
        expected[digit] = '2';
        if (second.stream != first.stream || second.channel->name != expected) continue;
        findings_.push_back(first.channel->name + " is taken for the left wheel and " + expected +
                            " for the right one; nothing says so");
        return NamedPair{first, second};
      }
    }
    return std::nullopt;
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
      if (const auto found = sides(quantity)) return take_wheels(kind, found->first, found->second);
    }
    for (const auto& [quantity, kind] : kinds) {
      if (const auto two = numbered_pair(quantity)) return take_wheels(kind, two->first, two->second);
    }
    for (const auto& [quantity, kind] : kinds) {
      // Of several without a side nobody knows which is which.
      if (all(quantity, NamedSide::none).size() > 1) continue;
      if (const auto found = single(quantity)) return take_wheels(kind, *found, std::nullopt);
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
    if (const auto found = sides(Quantity::command))
      return take_command(CommandKind::wheels, found->first, found->second);
    if (const auto found = sides(Quantity::duty))
      return take_command(CommandKind::duty, found->first, found->second);
    for (const auto& [quantity, kind] :
         {std::pair{Quantity::command, CommandKind::wheels}, {Quantity::duty, CommandKind::duty}}) {
      if (const auto two = numbered_pair(quantity)) return take_command(kind, two->first, two->second);
    }
    const auto linear = all(Quantity::linear_command, NamedSide::none);
    if (const auto found = pair(linear, all(Quantity::angular_command, NamedSide::none))) {
      return take_command(CommandKind::twist, found->first, found->second);
    }
    // Speeds of the body beside wheels that were measured, and held: they are what was asked for.
    const auto speeds = all(Quantity::linear_speed, NamedSide::none);
    if (const auto found = pair(speeds, all(Quantity::angular_speed, NamedSide::none));
        found && mapping_.wheels && is_held(found->first.channel->values)) {
      findings_.push_back(found->first.name().text() + " and " + found->second.name().text() +
                          " are held for most rows and are taken for commands");
      return take_command(CommandKind::twist, found->first, found->second);
    }
    if (const auto found = single(Quantity::duty))
      return take_command(CommandKind::duty, *found, std::nullopt);
    if (const auto found = single(Quantity::command))
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
    const auto turning = all(Quantity::angular_speed, NamedSide::none);
    const auto found = pair(all(Quantity::linear_speed, NamedSide::none), turning);
    if (!found || (mapping_.command && mapping_.command->first == found->first.name())) return;
    take_wheels(WheelKind::speed, found->first, found->second);
    mapping_.wheels->body_motion = true;
    findings_.push_back("no wheels: forward and turning speed " + found->first.name().text() + " and " +
                        found->second.name().text() + " stand in for them");
  }

  // How much a stream looks like a measurement from outside of the robot.
  int trust(const Named& x) const {
    std::string words;
    for (const char c : x.stream->name + " " + x.channel->name + " " + x.stream->type) {
      words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    const auto says = [&](std::string_view word) { return words.find(word) != std::string::npos; };
    if (says("odom")) return mapping_.wheels ? -1 : 0;  // what the robot makes of its own counts
    if (says("mocap") || says("vicon") || says("opti") || says("truth") || says("gt") || says("ref"))
      return 3;
    return says("amcl") || says("map") || says("pose") ? 2 : 1;
  }

  const Named* same_stream(const Named& x, Quantity quantity) const {
    for (const auto& named : named_) {
      if (named.stream == x.stream && named.meaning.quantity == quantity &&
          named.meaning.side == NamedSide::none)
        return &named;
    }
    return nullptr;
  }

  // Frames that are bolted to each other do not.
  static bool moves(const Channel& channel) {
    constexpr double least_m = 0.01;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    for (const double value : channel.values) {
      if (!std::isfinite(value)) continue;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    return highest - lowest > least_m;
  }

  bool find_tum() {
    for (const auto& recording : recordings_) {
      for (const auto& stream : recording.streams) {
        if (!is_tum(stream)) continue;
        const auto column = [&](const char* number) { return ChannelName{stream.name, number}; };
        mapping_.reference = ReferenceMapping{};
        mapping_.reference->x = column("2");
        mapping_.reference->y = column("3");
        mapping_.reference->qx = column("5");
        mapping_.reference->qy = column("6");
        mapping_.reference->qz = column("7");
        mapping_.reference->qw = column("8");
        findings_.push_back("the reference is a trajectory in the TUM format (t x y z qx qy qz qw)");
        return true;
      }
    }
    return false;
  }

  void find_reference() {
    if (find_tum()) return;
    const Named* best = nullptr;
    std::string others;
    for (const auto& named : named_) {
      if (named.meaning.quantity != Quantity::x || trust(named) < 0 || !same_stream(named, Quantity::y))
        continue;
      if (!moves(*named.channel) && !moves(*same_stream(named, Quantity::y)->channel)) continue;
      if (best != nullptr && trust(named) <= trust(*best)) {
        if (named.stream != best->stream) others += ", " + named.name().text();
        continue;
      }
      best = &named;
    }
    if (best == nullptr) return find_heading_alone();
    ReferenceMapping reference;
    reference.x = best->name();
    reference.y = same_stream(*best, Quantity::y)->name();
    if (find_unit(distance_units(), best->meaning.unit)) reference.unit = best->meaning.unit;
    take_heading(*best, reference);
    if (!others.empty())
      findings_.push_back("reference: " + best->name().text() + " was taken; there are also " +
                          others.substr(2));
    mapping_.reference = reference;
  }

  void take_heading(const Named& x, ReferenceMapping& reference) const {
    const Named* qz = same_stream(x, Quantity::qz);
    const Named* qw = same_stream(x, Quantity::qw);
    if (qz != nullptr && qw != nullptr) {
      reference.qz = qz->name();
      reference.qw = qw->name();
      if (const Named* qx = same_stream(x, Quantity::qx)) reference.qx = qx->name();
      if (const Named* qy = same_stream(x, Quantity::qy)) reference.qy = qy->name();
    } else if (const Named* theta = same_stream(x, Quantity::heading)) {
      reference.theta = theta->name();
      if (find_unit(angle_units(), theta->meaning.unit)) reference.angle_unit = theta->meaning.unit;
    }
  }

  void find_heading_alone() {
    const auto headings = all(Quantity::heading, NamedSide::none);
    if (headings.empty() || trust(headings.front()) < 0) return;
    ReferenceMapping reference;
    reference.theta = headings.front().name();
    if (find_unit(angle_units(), headings.front().meaning.unit))
      reference.angle_unit = headings.front().meaning.unit;
    mapping_.reference = reference;
  }

  void find_scalar(std::optional<ScalarMapping>& scalar, Quantity quantity,
                   std::span<const Unit> units) const {
    const auto found = all(quantity, NamedSide::none);
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
    for (const auto& named : named_) {
      if (named.meaning.quantity != Quantity::time || named.stream != stream) continue;
      if (!named.stream->received_s.empty()) return;  // stamps of messages are found by themselves
      mapping_.time.column = ChannelName{"", named.channel->name};
      return;
    }
  }

  std::span<const Recording> recordings_;
  std::vector<Named> named_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
};

std::optional<double> number_between(const std::string& text, double minimum, double maximum) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= minimum) || value > maximum) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

void map_by_names(std::span<const Recording> recordings, Mapping& mapping,
                  std::vector<std::string>& findings) {
  ByNames(recordings, mapping, findings).run();
}

void map_metadata(std::span<const Recording> recordings, Mapping& mapping) {
  for (const auto& recording : recordings) {
    for (const auto& [key, text] : recording.metadata) {
      if (key == "robot" && mapping.robot.empty()) mapping.robot = text;
      if (key == "wheel_base_m" && !mapping.wheel_base_m)
        mapping.wheel_base_m = number_between(text, 0.001, 10.0);
      if (key == "period_s" && !mapping.time.period_s)
        mapping.time.period_s = number_between(text, 0.0001, 10.0);
      if (!mapping.wheels || !key.starts_with("metres_per_tick_")) continue;
      const auto scale = number_between(text, 1e-9, 1.0);
      if (key == "metres_per_tick_left" && !mapping.wheels->metres_per_count)
        mapping.wheels->metres_per_count = scale;
      if (key == "metres_per_tick_right" && scale != mapping.wheels->metres_per_count) {
        mapping.wheels->metres_per_count_right = scale;
      }
    }
  }
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
