#include "tools/wheelwright/import/conversion/drive_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/stamps.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// A mapped channel and where its values go.
struct Source {
  const Stream* stream;
  const Channel* channel;
  Column* target;
};

class Gathering {
 public:
  Gathering(std::span<const Recording> recordings, const Mapping& mapping)
      : recordings_(recordings), mapping_(mapping) {}

  tl::expected<DriveColumns, std::string> run() {
    if (mapping_.command) {
      add(mapping_.command->first, columns_.command[0]);
      if (mapping_.command->second) add(*mapping_.command->second, columns_.command[1]);
    }
    if (mapping_.wheels) {
      add(mapping_.wheels->left, columns_.wheel[0]);
      if (mapping_.wheels->right) add(*mapping_.wheels->right, columns_.wheel[1]);
    }
    add_reference();
    if (mapping_.gyro) add(mapping_.gyro->column, columns_.gyro);
    if (mapping_.battery) add(mapping_.battery->column, columns_.battery);
    if (!problem_.empty()) return tl::unexpected(problem_);
    if (sources_.empty()) return tl::unexpected(name() + ": nothing in it is mapped to a robot");
    if (!merge()) return tl::unexpected(problem_);
    make_headings();
    return std::move(columns_);
  }

 private:
  std::string name() const { return recordings_.empty() ? std::string("nothing") : recordings_.front().name; }

  void add(const ChannelName& wanted, Column& target) {
    const FoundChannel found = find_channel(recordings_, wanted);
    if (found.channel == nullptr) {
      problem_ = name() + ": there is no one column '" + config::excerpt(wanted.text()) +
                 "'; 'wheelwright inspect' lists them";
      return;
    }
    sources_.push_back({found.stream, found.channel, &target});
  }

  void add_reference() {
    if (!mapping_.reference) return;
    const ReferenceMapping& reference = *mapping_.reference;
    if (reference.x) add(*reference.x, columns_.x);
    if (reference.y) add(*reference.y, columns_.y);
    if (reference.theta) add(*reference.theta, columns_.theta_rad);
    if (!reference.qw || !reference.qz) return;
    add(*reference.qz, quaternion_[2]);
    add(*reference.qw, quaternion_[3]);
    if (reference.qx) add(*reference.qx, quaternion_[0]);
    if (reference.qy) add(*reference.qy, quaternion_[1]);
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
        problem_ = name() + ": has no time; say how far its rows are apart: --set time.period_s=0.05";
        return false;
      }
    }
    shift_reference(streams, times);
    if (streams.size() == 1) {
      columns_.t_s = std::move(times.front());
      columns_.places = streams.front()->places;
      for (const auto& source : sources_) *source.target = source.channel->values;
      return true;
    }
    make_wheels_even(streams, times);
    merge_streams(streams, times);
    return true;
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
    if (!mapping_.reference || !mapping_.reference->shift_s || !mapping_.reference->x) return;
    const FoundChannel found = find_channel(recordings_, *mapping_.reference->x);
    for (std::size_t s = 0; s < streams.size(); ++s) {
      if (streams[s] != found.stream) continue;
      for (double& t : times[s]) t += *mapping_.reference->shift_s;
    }
  }

  void merge_streams(const std::vector<const Stream*>& streams, const std::vector<Column>& times) {
    struct Row {
      double t_s;
      std::size_t stream;
      std::size_t row;
    };
    std::vector<Row> rows;
    for (std::size_t s = 0; s < streams.size(); ++s) {
      for (std::size_t i = 0; i < times[s].size(); ++i) {
        if (std::isfinite(times[s][i])) rows.push_back({times[s][i], s, i});
      }
    }
    std::ranges::stable_sort(rows, {}, &Row::t_s);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == 0 || rows[i].t_s > columns_.t_s.back()) columns_.t_s.push_back(rows[i].t_s);
    }
    for (const auto& source : sources_) source.target->assign(columns_.t_s.size(), nothing);
    std::size_t at = 0;
    for (const Row& row : rows) {
      while (columns_.t_s[at] < row.t_s) ++at;
      for (const auto& source : sources_) {
        if (source.stream == streams[row.stream]) (*source.target)[at] = source.channel->values[row.row];
      }
    }
  }

  // Yaw of a quaternion, or a heading in the unit of its column.
  void make_headings() {
    if (!mapping_.reference) return;
    const auto& [qx, qy, qz, qw] = quaternion_;
    if (!qw.empty()) {
      columns_.theta_rad.resize(qw.size());
      for (std::size_t i = 0; i < qw.size(); ++i) {
        const double x = qx.empty() ? 0.0 : qx[i];
        const double y = qy.empty() ? 0.0 : qy[i];
        columns_.theta_rad[i] =
            std::atan2(2.0 * (qw[i] * qz[i] + x * y), qw[i] * qw[i] + x * x - y * y - qz[i] * qz[i]);
      }
      return;
    }
    const auto unit = find_unit(angle_units(), mapping_.reference->angle_unit);
    for (double& theta : columns_.theta_rad) theta *= unit ? unit->in_si : 1.0;
  }

  std::span<const Recording> recordings_;
  const Mapping& mapping_;
  DriveColumns columns_;
  std::array<Column, 4> quaternion_;  // x, y, z, w
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
  return Gathering(recordings, mapping).run();
}

}  // namespace wheelwright::import
