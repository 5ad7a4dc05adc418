#include "tools/wheelwright/import/conversion/drive_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double most_between_stamps_s = 1.0;

// A mapped channel and where its values go.
struct Source {
  const Stream* stream;
  const Channel* channel;
  Column* target;
};

double seconds_in(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::ms:
      return 1e-3;
    case TimeUnit::us:
      return 1e-6;
    case TimeUnit::ns:
      return 1e-9;
    case TimeUnit::s:
    case TimeUnit::hms:
    case TimeUnit::iso:
      break;
  }
  return 1.0;
}

const Channel* channel_of(const Stream& stream, const std::string& name) {
  if (const Channel* channel = stream.find(name)) return channel;
  const bool is_number =
      !name.empty() && name.size() < 6 && name.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t number = is_number ? std::stoul(name) : 0;
  return number >= 1 && number <= stream.channels.size() ? &stream.channels[number - 1] : nullptr;
}

// Stamps of the sender, where a message has them and its clock is that of the recorder.
const Channel* stamps_of(const Stream& stream) {
  for (const auto& channel : stream.channels) {
    if (channel.name == "header.stamp" || channel.name == "stamp") return &channel;
  }
  return nullptr;
}

bool agree(const Column& stamps, const Column& received_s) {
  Column differences;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (std::isfinite(stamps[i])) differences.push_back(std::abs(received_s[i] - stamps[i]));
  }
  if (differences.size() < stamps.size()) return false;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return middle != differences.end() && *middle < most_between_stamps_s;
}

// A time of day goes on past midnight.
void unwrap_midnight(Column& t_s) {
  constexpr double day_s = 86400.0;
  double days = 0.0;
  double last = nothing;
  for (double& t : t_s) {
    if (std::isfinite(last) && t < last - day_s / 2) days += day_s;
    if (std::isfinite(t)) last = t;
    t += days;
  }
}

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
      if (mapping_.time.unit == TimeUnit::hms) unwrap_midnight(times.back());
    }
    if (streams.size() == 1) {
      columns_.t_s = std::move(times.front());
      columns_.places = streams.front()->places;
      for (const auto& source : sources_) *source.target = source.channel->values;
      return true;
    }
    merge_streams(streams, times);
    return true;
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
      if (!name.stream.empty() && stream.name != name.stream) continue;
      const Channel* channel = channel_of(stream, name.channel);
      if (channel == nullptr) continue;
      found = {&stream, channel};
      ++count;
    }
  }
  return count == 1 ? found : FoundChannel{};
}

Column stream_times(const Stream& stream, const TimeMapping& time) {
  if (time.column && (time.column->stream.empty() || time.column->stream == stream.name)) {
    if (const Channel* channel = channel_of(stream, time.column->channel)) {
      Column t_s = channel->values;
      for (double& t : t_s) t *= seconds_in(time.unit);
      return t_s;
    }
  }
  if (!stream.received_s.empty()) {
    const Channel* stamps = stamps_of(stream);
    return stamps != nullptr && agree(stamps->values, stream.received_s) ? stamps->values : stream.received_s;
  }
  if (!time.period_s) return {};
  Column t_s(stream.rows);
  for (std::size_t i = 0; i < t_s.size(); ++i) t_s[i] = *time.period_s * static_cast<double>(i);
  return t_s;
}

tl::expected<DriveColumns, std::string> gather(std::span<const Recording> recordings,
                                               const Mapping& mapping) {
  return Gathering(recordings, mapping).run();
}

}  // namespace wheelwright::import
