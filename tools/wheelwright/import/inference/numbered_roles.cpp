#include "tools/wheelwright/import/inference/numbered_roles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/assignment.hpp"
#include "tools/wheelwright/import/inference/joined_tables.hpp"
#include "tools/wheelwright/import/inference/motion_assignments.hpp"
#include "tools/wheelwright/import/inference/pose_columns.hpp"
#include "tools/wheelwright/import/inference/step_response.hpp"
#include "tools/wheelwright/import/inference/unused_columns.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t min_stream_rows = 50;
constexpr std::size_t max_columns = 40;
constexpr std::size_t max_unheld_columns = 12;
constexpr double as_even_as_time = 0.3;
// By which wheels come behind a command; that which is held is one unless the wheels go before it.
constexpr double least_rows_unheld = 0.9;
constexpr double least_rows_held = 0.3;

const Stream* longest_table(std::span<const Recording> recordings) {
  const Stream* longest = nullptr;
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      if (!stream.received_s.empty() || stream.channels.empty()) continue;
      if (longest == nullptr || stream.rows > longest->rows) longest = &stream;
    }
  }
  return longest;
}

class ByNumbers {
 public:
  ByNumbers(const Stream& stream, Mapping& mapping, std::vector<std::string>& findings)
      : stream_(stream), mapping_(mapping), findings_(findings) {
    for (const auto& channel : stream.channels) {
      if (!is_used(mapping, stream, channel)) unused_.push_back(&channel);
    }
  }

  void find_time() {
    std::vector<const Channel*> indices;
    std::ranges::copy_if(unused_, std::back_inserter(indices),
                         [](const Channel* channel) { return is_row_index(channel->values); });
    const bool other_time = std::ranges::any_of(unused_, [](const Channel* channel) {
      return !is_row_index(channel->values) && evenness(channel->values) > as_even_as_time;
    });
    if (other_time) {
      for (const Channel* index : indices) std::erase(unused_, index);
    }
    const Channel* best = nullptr;
    double max_even = 0.02;
    for (const Channel* channel : unused_) {
      const double even = evenness(channel->values);
      if (even <= max_even) continue;
      max_even = even;
      best = channel;
    }
    if (best == nullptr) return;
    mapping_.time.column = ChannelName{"", best->name};
    std::erase(unused_, best);
    findings_.push_back("time is " + column_in_words(*best) + ": it rises at every row");
  }

  void find_motion(const std::vector<double>& t_s) {
    std::vector<const Channel*> commands;
    std::vector<Candidate> wheels;
    collect(commands, wheels);
    if (commands.size() > max_columns || wheels.size() > 2 * max_columns) return;
    auto possible = possible_assignments(commands, wheels, t_s, mapping_.wheel_base_m);
    std::erase_if(possible, [this](const Assignment& each) { return contradicts_names(each); });
    if (possible.empty()) return;
    const Assignment best = best_of(possible);
    // Beside counters by name, a measured speed that is repeated in faster rows is held as a command is.
    const bool are_counted = mapping_.wheels && mapping_.wheels->kind != WheelKind::speed;
    if (are_counted && !mapping_.command && !commands_lead(best, t_s, least_rows_held)) return;
    take(best);
    if (best.wheel[1].channel == nullptr) note_still_counter(commands);
  }

  // Commands that change at every row, as a joystick's do: any column may be one then, and wheels are
  // counted.
  void find_unheld_motion(const std::vector<double>& t_s) {
    std::vector<const Channel*> commands;
    std::vector<Candidate> wheels;
    for (const Channel* channel : unused_) {
      if (!std::isfinite(quantum(channel->values))) continue;  // a constant
      if (may_command(*channel) && !looks_counted(channel->values)) commands.push_back(channel);
      if (may_be_wheel(*channel) && are_whole(channel->values)) wheels.push_back({channel, true});
    }
    if (commands.size() > max_unheld_columns) return;
    auto possible = possible_assignments(commands, wheels, t_s, mapping_.wheel_base_m);
    std::erase_if(possible, [this](const Assignment& each) { return contradicts_names(each); });
    if (possible.empty()) return;
    const Assignment best = best_of(possible);
    if (!has_rival(best, possible) && commands_lead(best, t_s, least_rows_unheld)) take(best);
  }

  const std::vector<const Channel*>& unused() const { return unused_; }
  std::vector<const Channel*> unused_and_no_pose() const {
    std::vector<const Channel*> channels = unused_;
    std::erase_if(channels, [this](const Channel* channel) { return is_of_a_pose(*channel); });
    return channels;
  }

 private:
  void collect(std::vector<const Channel*>& commands, std::vector<Candidate>& wheels) const {
    if (mapping_.command) {
      for (const auto& channel : stream_.channels) {
        if (channel_of(stream_, mapping_.command->first) == &channel) commands.push_back(&channel);
        if (mapping_.command->second && channel_of(stream_, *mapping_.command->second) == &channel)
          commands.push_back(&channel);
      }
    }
    for (const Channel* channel : unused_) {
      if (!mapping_.command && may_command(*channel) && is_held(channel->values) &&
          !looks_counted(channel->values))
        commands.push_back(channel);
      if (mapping_.wheels || !may_be_wheel(*channel) || !std::isfinite(quantum(channel->values))) continue;
      wheels.push_back({channel, true});
      wheels.push_back({channel, false});
    }
    if (!mapping_.wheels) return;
    for (const auto& channel : stream_.channels) {
      const bool is_left = channel_of(stream_, mapping_.wheels->left) == &channel;
      const bool is_right =
          mapping_.wheels->right && channel_of(stream_, *mapping_.wheels->right) == &channel;
      if (is_left || is_right) wheels.push_back({&channel, mapping_.wheels->kind != WheelKind::speed});
    }
  }

  bool is_of_a_pose(const Channel& channel) const {
    return is_named(channel, {Quantity::x, Quantity::y, Quantity::z, Quantity::heading, Quantity::qx,
                              Quantity::qy, Quantity::qz, Quantity::qw, Quantity::wanted});
  }

  // A name that names no role for certain, or the key of a line, may say what numbers are: "CMD", "ENC",
  // "odom_x".
  bool is_named(const Channel& channel, std::initializer_list<Quantity> quantities) const {
    return std::ranges::find(quantities, meaning_of(stream_, channel).quantity) != quantities.end();
  }
  bool is_command(const Channel& channel) const {
    return is_named(channel, {Quantity::command, Quantity::duty});
  }
  bool may_command(const Channel& channel) const {
    const bool are_named =
        std::ranges::any_of(unused_, [this](const Channel* other) { return is_command(*other); });
    return are_named ? is_command(channel) : !is_named(channel, {Quantity::count});
  }
  // One wheel that is the speed of the body, or that follows the column of the other side; two wheels whose
  // names are those of different things.
  bool contradicts_names(const Assignment& each) const {
    const auto meaning = [this](const Channel* channel) { return meaning_of(stream_, *channel); };
    if (each.wheel[1].channel == nullptr) {
      const NameMeaning wheel = meaning(each.wheel[0].channel);
      const NamedSide commanded = meaning(each.command[0]).side;
      const bool is_of_body =
          is_named(*each.wheel[0].channel,
                   {Quantity::linear_speed, Quantity::angular_speed, Quantity::travelled, Quantity::turned});
      return is_of_body || (mapping_.command && mapping_.command->is_of_body()) ||
             (wheel.side != NamedSide::none && commanded != NamedSide::none && wheel.side != commanded);
    }
    return meaning(each.wheel[0].channel).quantity != meaning(each.wheel[1].channel).quantity;
  }

  // The input of a controller is what it measures, beside the setpoint that is the command.
  bool may_be_wheel(const Channel& channel) const {
    const bool is_input = mapping_.command.has_value() && NameWords(channel.name).has("input");
    return !is_of_a_pose(channel) && (is_input || !is_command(channel));
  }

  // One wheel for two commands: the counter of the other may be a column that never moves.
  void note_still_counter(const std::vector<const Channel*>& commands) const {
    const auto second = std::ranges::find_if(commands, [this](const Channel* channel) {
      return std::ranges::find(unused_, channel) != unused_.end();
    });
    const auto still = std::ranges::find_if(unused_, [](const Channel* channel) {
      return are_whole(channel->values) && !std::isfinite(quantum(channel->values));
    });
    if (second == commands.end() || still == unused_.end()) return;
    findings_.push_back(column_in_words(**still) + " never moves, and " + column_in_words(**second) +
                        " goes as a command does: if they are of the other wheel, its encoder is silent");
  }

  static const Assignment& best_of(const std::vector<Assignment>& possible) {
    return *std::ranges::max_element(possible, {}, [](const Assignment& each) { return each.nats; });
  }

  // Whether a column that `best` has no use for could be a command as well: then which one is is a guess, as
  // a measured speed explains the counts too.
  static bool has_rival(const Assignment& best, const std::vector<Assignment>& possible) {
    const auto is_used = [&best](const Channel* channel) {
      return channel == nullptr || channel == best.command[0] || channel == best.command[1] ||
             channel == best.wheel[0].channel || channel == best.wheel[1].channel;
    };
    return std::ranges::any_of(possible, [&](const Assignment& each) {
      return !is_used(each.command[0]) || !is_used(each.command[1]);
    });
  }

  void take(const Assignment& best) {
    take_assignment(stream_, best, mapping_, findings_);
    for (const Channel* channel :
         {best.command[0], best.command[1], best.wheel[0].channel, best.wheel[1].channel})
      std::erase(unused_, channel);
  }

  const Stream& stream_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
  std::vector<const Channel*> unused_;
};

}  // namespace

void map_by_numbers(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings) {
  if (mapping.command && mapping.wheels && mapping.time.column) return;
  const auto joined = joined_tables(recordings);
  const Stream* stream = joined ? &*joined : longest_table(recordings);
  if (stream == nullptr || stream->rows < min_stream_rows) return;
  ByNumbers by_numbers(*stream, mapping, findings);
  if (!mapping.time.column && !given.says("time.period_s")) by_numbers.find_time();
  if (mapping.time.column && !given.says("time.unit") &&
      channel_of(*stream, *mapping.time.column) != nullptr) {
    mapping.time.unit =
        time_unit_of(*stream, *channel_of(*stream, *mapping.time.column), mapping.time.period_s);
  }
  TimeMapping time = mapping.time;
  if (!time.column && !time.period_s) time.period_s = 1.0;  // any will do to compare assignments
  const Column t_s = stream_times(*stream, time);
  if (t_s.empty() || (mapping.command && mapping.wheels)) return;
  const bool sides_are_known = mapping.command.has_value() || mapping.wheels.has_value();
  by_numbers.find_motion(t_s);
  const bool may_be_step =
      !mapping.reference && (!mapping.command || !mapping.command->second) && !mapping.wheels;
  if (may_be_step && (mapping.time.column || mapping.time.period_s))
    find_step(*stream, t_s, by_numbers.unused_and_no_pose(), given, mapping, findings);
  if (!mapping.command && !mapping.wheels) by_numbers.find_unheld_motion(t_s);
  if (!mapping.reference && mapping.command && mapping.wheels)
    find_pose_columns(*stream, t_s, by_numbers.unused(), sides_are_known, mapping, findings);
}

}  // namespace wheelwright::import
