#include "tools/wheelwright/import/inference/numbered_roles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/inference/assignment.hpp"
#include "tools/wheelwright/import/inference/column_shapes.hpp"
#include "tools/wheelwright/import/inference/gain_units.hpp"
#include "tools/wheelwright/import/inference/pose_columns.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/inference/step_response.hpp"
#include "tools/wheelwright/import/inference/unused_columns.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t min_stream_rows = 50;
constexpr std::size_t max_columns = 40;
constexpr double sure_explained = 0.6;
constexpr double as_even_as_time = 0.3;
constexpr std::size_t max_rows = 20'000;

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
    t_s_ = t_s;
    std::vector<const Channel*> commands;
    std::vector<Candidate> wheels;
    collect(commands, wheels);
    if (commands.empty() || wheels.empty() || commands.size() > max_columns ||
        wheels.size() > 2 * max_columns)
      return;
    const auto best = best_assignment(commands, wheels);
    if (!best || best->explained < sure_explained) return;
    take(*best);
  }

  const std::vector<const Channel*>& unused() const { return unused_; }

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
      if (!mapping_.command && is_held(channel->values) && !looks_counted(channel->values))
        commands.push_back(channel);
      if (mapping_.wheels) continue;
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

  std::vector<double> speed_of(const Candidate& candidate) const {
    std::vector<double> values = candidate.channel->values;
    if (!candidate.cumulative) return values;
    if (const auto bits = wrapped_bits(values)) unwrap(values, *bits);
    std::vector<double> speed(values.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 1; i < values.size(); ++i)
      speed[i] = (values[i] - values[i - 1]) / (t_s_[i] - t_s_[i - 1]);
    return speed;
  }

  ResponseFit fit(const std::vector<double>& speed, const Channel& command) const {
    ResponseRows rows;
    const std::size_t count = std::min(speed.size(), max_rows);
    rows.speed.assign(speed.begin(), speed.begin() + static_cast<std::ptrdiff_t>(count));
    rows.command.assign(count, std::numeric_limits<double>::quiet_NaN());
    double last = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < count; ++i) {
      rows.command[i] = last;
      if (std::isfinite(command.values[i])) last = command.values[i];
    }
    rows.run_ends = {count};
    return fit_response(rows);
  }

  std::optional<Assignment> best_assignment(const std::vector<const Channel*>& commands,
                                            const std::vector<Candidate>& wheels) const {
    std::vector<std::vector<double>> speeds;
    speeds.reserve(wheels.size());
    for (const auto& wheel : wheels) speeds.push_back(speed_of(wheel));
    std::optional<Assignment> best;
    const auto offer = [&](const Assignment& assignment) {
      if (assignment.explained >= sure_explained && (!best || assignment.nats > best->nats))
        best = assignment;
    };
    std::vector<std::vector<ResponseFit>> fits(wheels.size());
    for (std::size_t w = 0; w < wheels.size(); ++w) {
      for (const Channel* command : commands)
        fits[w].push_back(command == wheels[w].channel ? ResponseFit{} : fit(speeds[w], *command));
    }
    for (std::size_t w = 0; w < wheels.size(); ++w) {
      for (std::size_t c = 0; c < commands.size(); ++c) {
        offer({CommandKind::wheels,
               {commands[c], nullptr},
               {wheels[w], {}},
               fits[w][c].nats,
               fits[w][c].explained});
      }
    }
    for (std::size_t a = 0; a < wheels.size(); ++a) {
      for (std::size_t b = a + 1; b < wheels.size(); ++b) {
        if (wheels[a].channel == wheels[b].channel || wheels[a].cumulative != wheels[b].cumulative) continue;
        offer_pairs(commands, wheels, fits, a, b, offer);
        if (commands.size() > 1) offer_twists(commands, wheels, speeds, a, b, offer);
      }
    }
    return best;
  }

  template <typename Offer>
  static void offer_pairs(const std::vector<const Channel*>& commands, const std::vector<Candidate>& wheels,
                          const std::vector<std::vector<ResponseFit>>& fits, std::size_t a, std::size_t b,
                          const Offer& offer) {
    for (std::size_t c = 0; c < commands.size(); ++c) {
      for (std::size_t d = 0; d < commands.size(); ++d) {
        if (commands[c] == wheels[a].channel || commands[d] == wheels[b].channel) continue;
        if (c == d && (wheels[a].channel == commands[c] || commands.size() > 1)) continue;
        offer({CommandKind::wheels,
               {commands[c], c == d ? nullptr : commands[d]},
               {wheels[a], wheels[b]},
               fits[a][c].nats + fits[b][d].nats,
               std::min(fits[a][c].explained, fits[b][d].explained)});
      }
    }
  }

  template <typename Offer>
  void offer_twists(const std::vector<const Channel*>& commands, const std::vector<Candidate>& wheels,
                    const std::vector<std::vector<double>>& speeds, std::size_t a, std::size_t b,
                    const Offer& offer) const {
    std::vector<double> forward = speeds[a];
    std::vector<double> turning = speeds[b];
    for (std::size_t i = 0; i < forward.size(); ++i) {
      const double left = forward[i];
      forward[i] = 0.5 * (left + turning[i]);
      turning[i] -= left;
    }
    for (std::size_t c = 0; c < commands.size(); ++c) {
      for (std::size_t d = 0; d < commands.size(); ++d) {
        const bool is_wheel = commands[c] == wheels[a].channel || commands[c] == wheels[b].channel ||
                              commands[d] == wheels[a].channel || commands[d] == wheels[b].channel;
        if (c == d || is_wheel) continue;
        const ResponseFit linear = fit(forward, *commands[c]);
        const ResponseFit angular = fit(turning, *commands[d]);
        Assignment assignment{CommandKind::twist,
                              {commands[c], commands[d]},
                              {wheels[a], wheels[b]},
                              linear.nats + angular.nats,
                              std::min(linear.explained, angular.explained)};
        if (angular.gain < 0.0) std::swap(assignment.wheel[0], assignment.wheel[1]);
        offer(assignment);
      }
    }
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
  std::vector<double> t_s_;
};

}  // namespace

void map_by_numbers(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings) {
  if (mapping.command && mapping.wheels && mapping.time.column) return;
  const Stream* stream = longest_table(recordings);
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
  if (mapping.time.column || mapping.time.period_s)
    find_step(*stream, t_s, by_numbers.unused(), given, mapping, findings);
  if (!mapping.reference && mapping.command && mapping.wheels)
    find_pose_columns(*stream, t_s, by_numbers.unused(), sides_are_known, mapping, findings);
}

}  // namespace wheelwright::import
