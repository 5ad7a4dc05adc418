#include "tools/wheelwright/import/conversion/simulated_time.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"

namespace wheelwright::import {
namespace {

constexpr std::size_t min_stamps = 20;
// Latencies of messages are less than this; clocks of two computers go apart by less than a hundredth.
constexpr double min_apart_s = 0.5;
constexpr double min_rate_off = 0.01;
constexpr double max_rates_apart = 0.02;  // of topics of one clock

struct Stamped {
  const Stream* stream = nullptr;
  const std::vector<double>* stamps = nullptr;

  double recorded_s() const { return stream->received_s.back() - stream->received_s.front(); }
  double stamped_s() const { return stamps->back() - stamps->front(); }
  double rate() const { return stamped_s() / recorded_s(); }
};

std::optional<Stamped> stamped(const Stream& stream) {
  const Channel* channel = stamps_of_sender(stream);
  if (channel == nullptr || stream.received_s.size() < min_stamps ||
      channel->values.size() != stream.received_s.size())
    return std::nullopt;
  const Stamped found{&stream, &channel->values};
  const bool is_clock =
      std::ranges::all_of(channel->values, [](double stamp) { return std::isfinite(stamp); }) &&
      std::ranges::is_sorted(channel->values) && std::ranges::is_sorted(stream.received_s) &&
      found.stamped_s() > 0.0 && found.recorded_s() > 0.0;
  return is_clock ? std::optional(found) : std::nullopt;
}

bool goes_otherwise(const Stamped& clock) {
  return std::abs(clock.stamped_s() - clock.recorded_s()) > min_apart_s &&
         std::abs(clock.rate() - 1.0) > min_rate_off;
}

// The time of the stamps at a time of the recorder.
double stamp_at(const Stamped& clock, double received_s) {
  const auto& received = clock.stream->received_s;
  const auto after = std::ranges::upper_bound(received, received_s);
  if (after == received.begin())
    return clock.stamps->front() + clock.rate() * (received_s - received.front());
  const auto i = static_cast<std::size_t>(after - received.begin());
  if (after == received.end()) return clock.stamps->back() + clock.rate() * (received_s - received.back());
  const double step_s = received[i] - received[i - 1];
  const double part = step_s > 0.0 ? (received_s - received[i - 1]) / step_s : 0.0;
  return (*clock.stamps)[i - 1] + part * ((*clock.stamps)[i] - (*clock.stamps)[i - 1]);
}

}  // namespace

void take_simulated_time(Recording& recording) {
  std::optional<Stamped> clock;
  for (const Stream& stream : recording.streams) {
    const auto found = stamped(stream);
    if (!found) continue;
    if (!goes_otherwise(*found)) return;
    if (clock && std::abs(clock->rate() / found->rate() - 1.0) > max_rates_apart) return;
    if (!clock || found->stream->rows > clock->stream->rows) clock = found;
  }
  if (!clock) return;
  const double rate = clock->rate();
  const Stream clock_as_it_was = *clock->stream;
  const Stamped as_it_was{&clock_as_it_was, &stamps_of_sender(clock_as_it_was)->values};
  for (Stream& stream : recording.streams) {
    const auto own = stamped(stream);
    if (own) {
      stream.received_s = *own->stamps;
    } else {
      for (double& t : stream.received_s) t = stamp_at(as_it_was, t);
    }
  }
  recording.remarks.push_back(
      "the stamps of the messages go at " + config::fixed_number(rate, 3) +
      " times the speed of the clock of the recorder, as in a simulation: times are those "
      "of the stamps");
}

}  // namespace wheelwright::import
