#include "tools/wheelwright/import/inference/named_roles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/body_motion.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/inference/named_commands.hpp"
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
    if (!mapping_.command)
      mapping_.command = find_named_command(named_, mapping_.wheels.has_value(), findings_);
    if (!mapping_.wheels) find_body_motion();
    if (!mapping_.wheels) find_body_travel();
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
      if (const auto found = best_sides(quantity)) return take_wheels(kind, found->first, found->second);
    }
    for (const auto& [quantity, kind] : kinds) {
      if (const auto two = named_.numbered_pair(quantity, findings_))
        return take_wheels(kind, two->first, two->second);
    }
    // "Speed_A", "rpm2": of two motors, not of the body. "w1" before "V1", which may be volts.
    for (const Quantity quantity : {Quantity::angular_speed, Quantity::linear_speed}) {
      if (const auto two = named_.numbered_pair(quantity, findings_))
        return take_wheels(WheelKind::speed, two->first, two->second);
    }
    for (const auto& [quantity, kind] : kinds) {
      // Of several without a side nobody knows which is which.
      if (named_.all(quantity, NamedSide::none).size() > 1) continue;
      if (const auto found = named_.single(quantity)) return take_wheels(kind, *found, std::nullopt);
    }
  }

  // Counters before what may be increments, or distances to a wall ("dL"); speeds with a unit before volts.
  std::optional<NamedPair> best_sides(Quantity quantity) const {
    const auto of_side = [&](NamedSide side) {
      auto list = named_.all(quantity, side);
      const auto is_second_choice = [&](const Named& named) {
        return quantity == Quantity::count   ? NameWords(named.channel->name).words().front() == "d"
               : quantity == Quantity::speed ? named.meaning.unit.empty()
                                             : false;
      };
      std::stable_partition(list.begin(), list.end(),
                            [&](const Named& named) { return !is_second_choice(named); });
      return list;
    };
    return NamedChannels::pair(of_side(NamedSide::left), of_side(NamedSide::right), findings_);
  }

  static bool is_per_row(const Named& named) {
    const NameWords words(named.channel->name);
    if (words.words().size() == 2 && words.words().front() == "d") return true;
    return words.has_any(
        {"delta", "diff", "inc", "increment", "increments", "dticks", "dcount", "dcounts", "dcnt", "denc"});
  }

  // The angle of an absolute encoder, 0 to 4095 for a turn.
  static bool goes_around_in_counts(const Named& named) {
    constexpr int fewest_bits = 10;
    const auto& values = named.channel->values;
    return !find_unit(angle_units(), named.meaning.unit) && are_whole(values) &&
           wrapped_bits(values).value_or(0) >= fewest_bits;
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
    if (wheels.kind == WheelKind::angle && goes_around_in_counts(left)) wheels.kind = WheelKind::counts;
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

  // Forward and turning speed that the robot measured itself: odometry.
  void find_body_motion() {
    const auto turning = named_.all(Quantity::angular_speed, NamedSide::none);
    const auto found =
        NamedChannels::pair(named_.all(Quantity::linear_speed, NamedSide::none), turning, findings_);
    if (!found || (mapping_.command && mapping_.command->first == found->first.name())) return;
    take_body_motion(WheelKind::speed, *found);
    findings_.push_back("no wheels: forward and turning speed " + found->first.name().text() + " and " +
                        found->second.name().text() + " stand in for them");
  }

  // How far it went and turned, as a Create says it.
  void find_body_travel() {
    if (named_.has_places()) return;
    const auto found = NamedChannels::pair(named_.all(Quantity::travelled, NamedSide::none),
                                           named_.all(Quantity::turned, NamedSide::none), findings_);
    if (!found) return;
    take_body_motion(WheelKind::distance, *found);
    WheelMapping& wheels = *mapping_.wheels;
    if (wheels.unit_assumed && are_whole(found->first.channel->values)) {
      wheels.unit = "mm";
      wheels.unit_assumed = false;
    }
    if (wheels.angular_unit.empty() && are_whole(found->second.channel->values)) wheels.angular_unit = "deg";
    findings_.push_back("no wheels: how far the robot went and turned, " + found->first.name().text() +
                        " and " + found->second.name().text() + ", stand in for them, in " + wheels.unit +
                        " and " + (wheels.angular_unit.empty() ? "rad" : wheels.angular_unit));
  }

  void take_body_motion(WheelKind kind, const NamedPair& motion) {
    take_wheels(kind, motion.first, motion.second);
    WheelMapping& wheels = *mapping_.wheels;
    wheels.body_motion = true;
    if (const auto unit = find_unit(turning_units(wheels), motion.second.meaning.unit))
      wheels.angular_unit = unit->name;
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
      mapping_.time.column = ChannelName{"", clock_of_device(*found->stream, *found->channel).name};
      return;
    }
    if (stream == nullptr || !stream->received_s.empty()) return;
    const auto frames = std::ranges::find_if(stream->channels, counts_frames);
    if (frames != stream->channels.end()) mapping_.time.column = ChannelName{"", frames->name};
  }

  // Where stamps were given as rows arrived, in bunches, and the clock of the device stands beside them:
  // that.
  const Channel& clock_of_device(const Stream& stream, const Channel& clock) const {
    constexpr double even = 0.9;
    constexpr double bunched = 0.5;
    if (evenness(clock.values) >= bunched) return clock;
    for (const Channel& other : stream.channels) {
      if (evenness(other.values) < even || !go_alike(clock.values, other.values)) continue;
      findings_.push_back("time is '" + config::excerpt(other.name) +
                          "', which goes by even steps; those of '" + config::excerpt(clock.name) +
                          "' come in bunches");
      return other;
    }
    return clock;
  }

  // Seconds, milliseconds, ... of the same time.
  static bool go_alike(const std::vector<double>& one, const std::vector<double>& other) {
    constexpr double rate_error = 0.02;
    const double ratio = (one.back() - one.front()) / (other.back() - other.front());
    return ratio > 0.0 &&
           std::ranges::any_of(std::array{1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9},
                               [&](double unit) { return std::abs(ratio / unit - 1.0) < rate_error; });
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
