#include "tools/wheelwright/import/conversion/drive_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "config/load/printable_text.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/body_motion.hpp"
#include "tools/wheelwright/import/conversion/command_timeout.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/join_streams.hpp"
#include "tools/wheelwright/import/conversion/misread_counts.hpp"
#include "tools/wheelwright/import/conversion/missing_keys.hpp"
#include "tools/wheelwright/import/conversion/own_rows.hpp"
#include "tools/wheelwright/import/conversion/reference_poses.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/conversion/time_units.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wrapped_angles.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

// A mapped channel and where its values go.
struct Source {
  const Stream* stream;
  const std::vector<double>* values;
  Column* target;
  Joining joining;
};

class Gathering {
 public:
  Gathering(std::span<const Recording> recordings, const Mapping& mapping, std::size_t max_rows)
      : recordings_(recordings), mapping_(mapping), max_rows_(max_rows) {}

  tl::expected<DriveColumns, std::string> run() {
    if (mapping_.command) {
      add(mapping_.command->first, columns_.command[0], Joining::held);
      if (mapping_.command->second) add(*mapping_.command->second, columns_.command[1], Joining::held);
    }
    if (mapping_.command) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (const auto& bit = mapping_.command->direction[side])
          add(*bit, columns_.direction[side], Joining::held);
      }
    }
    if (mapping_.wheels) {
      add(mapping_.wheels->left, columns_.wheel[0]);
      if (mapping_.wheels->right) add(*mapping_.wheels->right, columns_.wheel[1]);
    }
    add_reference();
    if (mapping_.gyro) add(mapping_.gyro->column, columns_.gyro);
    if (mapping_.battery) add(mapping_.battery->column, columns_.battery, Joining::held);
    if (!problem_.empty()) return tl::unexpected(problem_);
    if (sources_.empty()) return tl::unexpected(name() + ": " + what_is_missing(mapping_));
    if (!merge()) return tl::unexpected(problem_);
    if (mapping_.wheels) leave_out_misread_counts(columns_, *mapping_.wheels);
    body_motion_to_wheels(columns_, mapping_);
    if (mapping_.command) {
      if (mapping_.command->by_radius && mapping_.command->second) turn_by_radius(columns_, mapping_);
      subtract_neutral(columns_, mapping_.command->neutral);
      apply_directions(columns_, mapping_.command->forward);
      reverse_commands(columns_, *mapping_.command);
      if (mapping_.command->timeout_s) stop_after_timeout(columns_, *mapping_.command->timeout_s);
    }
    return std::move(columns_);
  }

 private:
  std::string name() const { return recordings_.empty() ? std::string("nothing") : recordings_.front().name; }

  void add(const ChannelName& wanted, Column& target, Joining joining = Joining::between) {
    const FoundChannel found = find_channel(recordings_, wanted);
    if (found.channel == nullptr) return say_missing(wanted);
    sources_.push_back({found.stream, &found.channel->values, &target, joining});
  }

  void say_missing(const ChannelName& wanted) {
    problem_ = name() + ": there is no one column '" + config::excerpt(wanted.text()) +
               "'; 'wheelwright inspect' lists them";
  }

  void add_reference() {
    if (!mapping_.reference) return;
    auto poses = reference_poses(recordings_, *mapping_.reference);
    if (!poses) return say_missing(poses.error());
    reference_ = *std::move(poses);
    if (!reference_.remark.empty()) columns_.remarks.push_back(reference_.remark);
    for (const auto& [values, target] : {std::pair{&reference_.x, &columns_.x},
                                         {&reference_.y, &columns_.y},
                                         {&reference_.heading_rad, &columns_.theta_rad}}) {
      if (values->stream != nullptr)
        sources_.push_back({values->stream, &values->values, target, Joining::between});
    }
  }

  bool merge() {
    std::vector<const Stream*> streams;
    for (const auto& source : sources_) {
      if (std::ranges::find(streams, source.stream) == streams.end()) streams.push_back(source.stream);
    }
    std::vector<Column> times;
    for (const Stream* stream : streams) {
      times.push_back(stream_times(*stream, mapping_.time));
      if (times.back().empty()) {
        problem_ = (streams.size() > 1 ? stream->name : name()) +
                   (mapping_.time.unit == TimeUnit::frame
                        ? ": its time is a number of frames, and their rate is not known: --set "
                          "time.rate_hz=30"
                        : ": has no time; say how far its rows are apart: --set time.period_s=0.05");
        return false;
      }
    }
    for (const Stream* stream : streams) say_clock_wraps(*stream);
    shift_reference(streams, times);
    if (streams.size() == 1) {
      if (take_own_rows(*streams.front(), times.front())) return true;
      if (streams.front()->rows > max_rows_) {
        take_part(*streams.front(), times.front());
        return true;
      }
      columns_.t_s = std::move(times.front());
      columns_.places = streams.front()->places;
      columns_.run_starts = streams.front()->run_starts;
      for (const auto& source : sources_) *source.target = *source.values;
      return true;
    }
    make_wheels_even(streams, times);
    merge_streams(streams, times);
    return true;
  }

  // Where rows of other columns lie between those of the wheels.
  bool take_own_rows(const Stream& stream, const Column& t_s) {
    if (!mapping_.wheels) return false;
    const Channel* wheel = find_channel(recordings_, mapping_.wheels->left).channel;
    const Channel* time = time_channel(stream, mapping_.time);
    std::vector<const Column*> others;
    for (const auto& channel : stream.channels)
      if (&channel != wheel && &channel != time) others.push_back(&channel.values);
    const auto rows = rows_of_its_own(wheel->values, others);
    if (!rows) return false;
    columns_.t_s = at_rows(t_s, *rows);
    for (const std::size_t row : *rows)
      if (row < stream.places.size()) columns_.places.push_back(stream.places[row]);
    for (const std::size_t start : stream.run_starts) {
      const auto first = std::ranges::lower_bound(*rows, start);
      columns_.run_starts.push_back(static_cast<std::size_t>(first - rows->begin()));
    }
    unwrap_angles(reference_.heading_rad.values);
    for (const auto& source : sources_)
      *source.target = join_own_rows(t_s, *source.values, *rows, source.joining);
    return true;
  }

  // Where the first of the held columns (the command) changes for the first time, and what follows.
  void take_part(const Stream& stream, const Column& t_s) {
    constexpr std::size_t rows_before = 100;
    std::size_t moves = stream.rows;
    for (const auto& source : sources_) {
      if (source.joining != Joining::held) continue;
      const auto& values = *source.values;
      const auto change = std::ranges::adjacent_find(
          values, [](double a, double b) { return std::isfinite(a) && std::isfinite(b) && a != b; });
      moves = std::min(moves, static_cast<std::size_t>(change - values.begin()));
    }
    const std::size_t begin = moves == stream.rows  ? stream.rows - max_rows_  // nothing changes
                              : moves > rows_before ? moves - rows_before
                                                    : 0;
    const auto part = [&](const auto& all) {
      const auto from = all.begin() + static_cast<std::ptrdiff_t>(std::min(begin, all.size()));
      return std::decay_t<decltype(all)>(
          from, all.begin() + static_cast<std::ptrdiff_t>(std::min(begin + max_rows_, all.size())));
    };
    columns_.t_s = part(t_s);
    columns_.places = part(stream.places);
    for (const std::size_t start : stream.run_starts) {
      if (start >= begin + max_rows_) continue;
      if (columns_.run_starts.empty() || start > begin)
        columns_.run_starts.push_back(start > begin ? start - begin : 0);
    }
    if (!columns_.run_starts.empty()) columns_.run_starts.front() = 0;
    for (const auto& source : sources_) *source.target = part(*source.values);
  }

  void say_clock_wraps(const Stream& stream) {
    const Channel* channel = time_channel(stream, mapping_.time);
    if (channel == nullptr || mapping_.time.unit == TimeUnit::hms || mapping_.time.unit == TimeUnit::iso)
      return;
    Column values = channel->values;
    const auto rows = unwrap_clock(values);
    if (rows.empty()) return;
    const std::size_t row = rows.front();
    columns_.remarks.push_back(
        (row < stream.places.size() ? "line " + std::to_string(stream.places[row])
                                    : "row " + std::to_string(row + 1)) +
        ": the counter of time starts again behind " + config::plain_number(channel->values[row - 1]) +
        (rows.size() > 1 ? " (" + std::to_string(rows.size()) + " times)" : "") + "; taken to go on");
  }

  // Counts that were handled in bunches, before rows of other streams lie between them.
  void make_wheels_even(const std::vector<const Stream*>& streams, std::vector<Column>& times) {
    if (!mapping_.wheels || mapping_.wheels->kind == WheelKind::speed) return;
    const FoundChannel found = find_channel(recordings_, mapping_.wheels->left);
    for (std::size_t s = 0; s < streams.size(); ++s) {
      if (streams[s] != found.stream || !std::ranges::is_sorted(times[s])) continue;
      Column travel = found.channel->values;
      if (const auto bits = wrapped_bits(travel)) unwrap(travel, *bits);
      if (const auto even = even_stamps(times[s], travel)) {
        columns_.remarks.push_back(streams[s]->name + ": " + even->text());
        times[s] = even->t_s;
      }
    }
  }

  void shift_reference(const std::vector<const Stream*>& streams, std::vector<Column>& times) const {
    if (!mapping_.reference || !mapping_.reference->x) return;
    if (!mapping_.reference->shift_s && !mapping_.reference->clock_rate) return;
    const double shift_s = mapping_.reference->shift_s.value_or(0.0);
    const double rate = mapping_.reference->clock_rate.value_or(1.0);
    const FoundChannel found = find_channel(recordings_, *mapping_.reference->x);
    for (std::size_t s = 0; s < streams.size(); ++s) {
      if (streams[s] != found.stream) continue;
      const auto first = std::ranges::find_if(times[s], [](double t) { return std::isfinite(t); });
      if (first == times[s].end()) continue;
      const double first_s = *first;
      for (double& t : times[s]) t = first_s + shift_s + rate * (t - first_s);
    }
  }

  // Rows are those of the wheels, and all else is joined to them; without wheels there is a row wherever any
  // stream has one, so that poses stand at their own times (CommandTimeline takes commands at any).
  void merge_streams(const std::vector<const Stream*>& streams, std::vector<Column>& times) {
    const Stream* wheels =
        mapping_.wheels ? find_channel(recordings_, mapping_.wheels->left).stream : nullptr;
    const auto of_wheels = std::ranges::find(streams, wheels);
    if (of_wheels == streams.end()) return unite_streams(streams, times);
    columns_.t_s = times[static_cast<std::size_t>(of_wheels - streams.begin())];
    columns_.places = wheels->places;
    unwrap_angles(reference_.heading_rad.values);  // a heading between two is on the short way
    for (const auto& source : sources_) {
      const auto at = static_cast<std::size_t>(std::ranges::find(streams, source.stream) - streams.begin());
      *source.target = source.stream == wheels
                           ? *source.values
                           : join(times[at], *source.values, columns_.t_s, source.joining);
    }
  }

  void unite_streams(const std::vector<const Stream*>& streams, const std::vector<Column>& times) {
    const UnitedRows united = unite_rows(times);
    columns_.t_s = united.t_s;
    for (const auto& source : sources_) {
      source.target->assign(columns_.t_s.size(), nothing);
      const auto s = static_cast<std::size_t>(std::ranges::find(streams, source.stream) - streams.begin());
      for (std::size_t i = 0; i < times[s].size(); ++i) {
        if (std::isfinite(times[s][i])) (*source.target)[united.rows[s][i]] = (*source.values)[i];
      }
    }
  }

  std::span<const Recording> recordings_;
  const Mapping& mapping_;
  std::size_t max_rows_;
  DriveColumns columns_;
  ReferencePoses reference_;
  std::vector<Source> sources_;
  std::string problem_;
};

}  // namespace

std::string DriveColumns::place(std::size_t row) const {
  return row < places.size() ? "line " + std::to_string(places[row]) : "row " + std::to_string(row + 1);
}

FoundChannel find_channel(std::span<const Recording> recordings, const ChannelName& name) {
  FoundChannel found;
  std::size_t count = 0;
  for (const auto& recording : recordings) {
    for (const auto& stream : recording.streams) {
      const Channel* channel = channel_of(stream, name);
      if (channel == nullptr) continue;
      found = {&stream, channel};
      ++count;
    }
  }
  return count == 1 ? found : FoundChannel{};
}

tl::expected<DriveColumns, std::string> gather(std::span<const Recording> recordings,
                                               const Mapping& mapping) {
  return Gathering(recordings, mapping, std::numeric_limits<std::size_t>::max()).run();
}

tl::expected<DriveColumns, std::string> gather_sample(std::span<const Recording> recordings,
                                                      const Mapping& mapping) {
  constexpr std::size_t sample_rows = 100'000;
  return Gathering(recordings, mapping, sample_rows).run();
}

}  // namespace wheelwright::import
