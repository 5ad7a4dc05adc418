#include "model/gap/adequacy/intermittent_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "model/gap/adequacy/tail_probability.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr double window_s = 0.3;
constexpr std::size_t min_windows = 50;
constexpr double deviations = 5.0;
constexpr double same_event_s = 1.0;
constexpr std::size_t groups = 6;      // of windows that are alike in speed
constexpr std::size_t min_alike = 10;  // of which a median says something

struct Window {
  std::size_t run = 0;
  double time_s = 0.0;
  double sum = 0.0;  // of innovations
  double count = 0.0;
  double change = 0.0;  // of the free-run error
  double forward_m_s = 0.0;
  double turning_rad_s = 0.0;
  double deviation = 0.0;  // of windows like this one

  double standardised() const { return sum / std::sqrt(count); }
};

std::vector<Window> windows_of(const ResidualTrack& track, const std::vector<double>& forward_m_s,
                               const std::vector<double>& turning_rad_s) {
  std::vector<Window> windows;
  for (std::size_t i = 1; i < track.innovation.size(); ++i) {
    if (track.discontinuity[i] != 0) continue;
    const double begin_s = window_s * std::floor(track.time_s[i] / window_s);
    if (windows.empty() || windows.back().time_s != begin_s) windows.push_back({track.run, begin_s});
    Window& window = windows.back();
    window.sum += track.innovation[i];
    window.count += 1.0;
    window.change += track.error[i] - track.error[i - 1];
    window.forward_m_s = std::max(window.forward_m_s, forward_m_s[i]);
    window.turning_rad_s = std::max(window.turning_rad_s, turning_rad_s[i]);
  }
  return windows;
}

// Of a normal distribution, by the median size.
double deviation_of(std::span<const Window> windows) {
  std::vector<double> sizes;
  sizes.reserve(windows.size());
  for (const Window& window : windows) sizes.push_back(std::abs(window.standardised()));
  return deviations_of_median_size * median(sizes);
}

// At least that of the windows of about the same `speed`; where there are few of those, the largest of any
// speed.
void raise_deviations(std::vector<Window>& windows, double Window::*speed) {
  const double fastest = (*std::ranges::max_element(windows, {}, speed)).*speed;
  if (!(fastest > 0.0)) return;
  const auto group_of = [&](const Window& window) {
    return std::min(groups - 1,
                    static_cast<std::size_t>(static_cast<double>(groups) * window.*speed / fastest));
  };
  std::array<std::vector<Window>, groups> alike;
  for (const Window& window : windows) alike.at(group_of(window)).push_back(window);
  std::array<double, groups> deviation{};
  for (std::size_t i = 0; i < groups; ++i)
    if (alike.at(i).size() >= min_alike) deviation.at(i) = deviation_of(alike.at(i));
  const double largest = *std::ranges::max_element(deviation);
  for (Window& window : windows) {
    const std::size_t group = group_of(window);
    window.deviation =
        std::max(window.deviation, alike.at(group).size() >= min_alike ? deviation.at(group) : largest);
  }
}

}  // namespace

std::optional<IntermittentEvents> intermittent_events(std::span<const ResidualTrack* const> tracks,
                                                      const RecentCommands& commands, double visible) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i < tracks.size(); ++i)
    std::ranges::copy(windows_of(*tracks[i], commands.forward_m_s[i], commands.turning_rad_s[i]),
                      std::back_inserter(windows));
  if (windows.size() < min_windows) return std::nullopt;
  const double of_all = deviation_of(windows);
  for (Window& window : windows) window.deviation = of_all;
  raise_deviations(windows, &Window::forward_m_s);
  raise_deviations(windows, &Window::turning_rad_s);
  std::ranges::sort(windows, std::greater<>{},
                    [](const Window& window) { return std::abs(window.standardised()); });

  IntermittentEvents found;
  double power = 0.0;
  double of_events = 0.0;
  double squared_changes = 0.0;
  double with_event = 0.0;
  for (const Window& window : windows) {
    const double squared = window.standardised() * window.standardised();
    power += squared;
    const bool is_event = std::abs(window.standardised()) > deviations * window.deviation;
    if (!is_event || std::abs(window.change) < visible) continue;
    of_events += squared;
    squared_changes += window.change * window.change;
    with_event += 1.0;
    const bool is_known = std::ranges::any_of(found.events, [&](const IntermittentEvents::Event& event) {
      return event.run == window.run && std::abs(event.time_s - window.time_s) < same_event_s;
    });
    if (!is_known) found.events.push_back({window.run, window.time_s});
  }
  if (found.events.empty()) return std::nullopt;
  for (const Window& window : windows) {
    if (window.run == found.events.front().run) found.changes.emplace_back(window.time_s, window.change);
  }
  std::ranges::sort(found.changes);
  const auto count = static_cast<double>(windows.size());
  found.share = of_events / power;
  found.share_of_time = with_event / count;
  found.size = std::sqrt(squared_changes * horizon_s / (count * window_s));
  found.p_value = poisson_tail(found.events.size(), count * std::erfc(deviations / std::sqrt(2.0)));
  return found;
}

}  // namespace wheelwright::gap
