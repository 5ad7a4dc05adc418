#include "tools/wheelwright/import/conversion/stream_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "tools/wheelwright/import/inference/column_names.hpp"

namespace wheelwright::import {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double most_between_stamps_s = 1.0;
constexpr double usual_period_s = 0.03;

double median_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) steps.push_back(times[i] - times[i - 1]);
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

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

// Stamps of the sender, where a message has them and its clock is that of the recorder.
const Channel* stamps_of(const Stream& stream) {
  for (const auto& channel : stream.channels) {
    if (channel.name == "header.stamp" || channel.name == "stamp") return &channel;
  }
  return nullptr;
}

bool agree(const std::vector<double>& stamps, const std::vector<double>& received_s) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (std::isfinite(stamps[i])) differences.push_back(std::abs(received_s[i] - stamps[i]));
  }
  if (differences.size() < stamps.size()) return false;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return middle != differences.end() && *middle < most_between_stamps_s;
}

// A time of day goes on past midnight.
void unwrap_midnight(std::vector<double>& t_s) {
  constexpr double day_s = 86400.0;
  double days = 0.0;
  double last = nothing;
  for (double& t : t_s) {
    if (std::isfinite(last) && t < last - day_s / 2) days += day_s;
    if (std::isfinite(t)) last = t;
    t += days;
  }
}

std::vector<double> in_seconds(std::vector<double> values, TimeUnit unit) {
  for (double& t : values) t *= seconds_in(unit);
  if (unit == TimeUnit::hms) unwrap_midnight(values);
  return values;
}

const Channel* own_time(const Stream& stream) {
  if (is_tum(stream)) return &stream.channels.front();
  for (const auto& channel : stream.channels) {
    if (meaning_of(stream, channel).quantity == Quantity::time) return &channel;
  }
  return nullptr;
}

TimeUnit unit_of(const Channel& channel, std::optional<double> period_s) {
  if (channel.unit == "hms") return TimeUnit::hms;
  if (channel.unit == "iso") return TimeUnit::iso;
  return time_unit(channel.values, period_s);
}

}  // namespace

const Channel* channel_of(const Stream& stream, const std::string& name) {
  if (const Channel* channel = stream.find(name)) return channel;
  const bool is_number =
      !name.empty() && name.size() < 6 && name.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t number = is_number ? std::stoul(name) : 0;
  return number >= 1 && number <= stream.channels.size() ? &stream.channels[number - 1] : nullptr;
}

const Channel* channel_of(const Stream& stream, const ChannelName& name) {
  if (!name.stream.empty()) return name.stream == stream.name ? channel_of(stream, name.channel) : nullptr;
  if (const Channel* channel = channel_of(stream, name.channel)) return channel;
  const bool is_long = name.channel.size() > stream.name.size() + 1 && !stream.name.empty();
  if (!is_long || !name.channel.starts_with(stream.name + ":")) return nullptr;
  return channel_of(stream, name.channel.substr(stream.name.size() + 1));
}

bool is_tum(const Stream& stream) {
  if (stream.channels.size() != 8 || stream.channels.front().name != "1") return false;
  std::size_t unit_quaternions = 0;
  const std::size_t rows = stream.channels.front().values.size();
  for (std::size_t i = 0; i < rows; ++i) {
    double squares = 0.0;
    for (std::size_t k = 4; k < 8; ++k)
      squares += stream.channels[k].values[i] * stream.channels[k].values[i];
    if (std::abs(squares - 1.0) < 0.02) ++unit_quaternions;
  }
  return rows > 1 && unit_quaternions * 10 > rows * 9;
}

TimeUnit time_unit(const std::vector<double>& times, std::optional<double> period_s) {
  double size = 0.0;
  bool whole = true;
  for (const double t : times) {
    if (!std::isfinite(t)) continue;
    size = std::max(size, std::abs(t));
    whole = whole && t == std::round(t);
  }
  if (size > 1e8 && !(period_s && size < 1e11 && whole)) {
    return size < 1e11 ? TimeUnit::s : size < 1e14 ? TimeUnit::ms : size < 1e17 ? TimeUnit::us : TimeUnit::ns;
  }
  const double step = median_step(times);
  if (!(step > 0.0)) return TimeUnit::s;
  constexpr std::array units{std::pair{TimeUnit::s, 1.0}, std::pair{TimeUnit::ms, 1e-3},
                             std::pair{TimeUnit::us, 1e-6}, std::pair{TimeUnit::ns, 1e-9}};
  TimeUnit best = TimeUnit::s;
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& [unit, seconds] : units) {
    double apart = std::abs(std::log(step * seconds / period_s.value_or(usual_period_s)));
    // Parts of a unit are written of seconds.
    if (!whole && unit == TimeUnit::s) apart -= 3.0;
    if (apart < lowest) {
      lowest = apart;
      best = unit;
    }
  }
  return best;
}

std::vector<double> stream_times(const Stream& stream, const TimeMapping& time) {
  if (time.column) {
    if (const Channel* channel = channel_of(stream, *time.column)) {
      return in_seconds(channel->values, time.unit);
    }
  }
  if (!stream.received_s.empty()) {
    const Channel* stamps = stamps_of(stream);
    return stamps != nullptr && agree(stamps->values, stream.received_s) ? stamps->values : stream.received_s;
  }
  if (const Channel* channel = own_time(stream)) {
    return in_seconds(channel->values, unit_of(*channel, time.period_s));
  }
  if (!time.period_s) return {};
  std::vector<double> t_s(stream.rows);
  for (std::size_t i = 0; i < t_s.size(); ++i) t_s[i] = *time.period_s * static_cast<double>(i);
  return t_s;
}

}  // namespace wheelwright::import
