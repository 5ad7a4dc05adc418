#include "model/gap/adequacy/reversal_residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr double reversal_window_s = 0.7;
constexpr std::size_t min_reversals = 10;

struct ReversalWindow {
  double sum_squares = 0.0;  // of innovations
  double count = 0.0;
  double lowest_m = std::numeric_limits<double>::infinity();  // free-run error
  double highest_m = -std::numeric_limits<double>::infinity();

  void add(double innovation, double error_m) {
    sum_squares += innovation * innovation;
    count += 1.0;
    lowest_m = std::min(lowest_m, error_m);
    highest_m = std::max(highest_m, error_m);
  }
  double power() const { return sum_squares / count; }
  double squared_span_m2() const { return (highest_m - lowest_m) * (highest_m - lowest_m); }
};

// Mean squared innovation over the time since a reversal.
class PowerSinceReversal {
 public:
  void add(double since_s, double innovation) {
    const auto bin = static_cast<std::size_t>(since_s / bin_s);
    if (bin >= bins) return;
    sum_squares_.at(bin) += innovation * innovation;
    counts_.at(bin) += 1.0;
  }
  std::vector<std::pair<double, double>> points() const {
    std::vector<std::pair<double, double>> all;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const double middle_s = bin_s * (static_cast<double>(bin) + 0.5);
      if (counts_.at(bin) > 0.0) all.emplace_back(middle_s, sum_squares_.at(bin) / counts_.at(bin));
    }
    return all;
  }

 private:
  static constexpr double bin_s = 0.1;
  static constexpr std::size_t bins = 20;
  std::array<double, bins> sum_squares_{};
  std::array<double, bins> counts_{};
};

struct ReversalWindows {
  std::vector<ReversalWindow> after_reversal;
  std::vector<ReversalWindow> elsewhere;
  PowerSinceReversal since_reversal;
  double duration_s = 0.0;
};

double command_of(const GapRun& run, Channel wheel, std::size_t period) {
  const WheelPair& command = run.commands_m_s[std::min(period, run.commands_m_s.size() - 1)];
  return wheel == Channel::left ? command.left : command.right;
}

// Periods in which the command has another sign than the last that was not zero.
std::vector<std::size_t> reversals_of(const GapRun& run, Channel wheel) {
  std::vector<std::size_t> reversals;
  double last_m_s = 0.0;
  for (std::size_t k = 0; k < run.commands_m_s.size(); ++k) {
    const double command_m_s = command_of(run, wheel, k);
    if (command_m_s == 0.0) continue;
    if (command_m_s * last_m_s < 0.0) reversals.push_back(k);
    last_m_s = command_m_s;
  }
  return reversals;
}

void add_windows(const GapRun& run, const ResidualTrack& track, ReversalWindows& all) {
  if (run.commands_m_s.empty() || track.time_s.empty()) return;
  const std::vector<std::size_t> reversals = reversals_of(run, track.channel);
  std::size_t next = 0;
  bool after_reversal = false;
  double end_s = -1.0;  // of the present window
  std::optional<double> reversed_s;
  ReversalWindow present;
  const auto close = [&] {
    if (present.count > 0.0) (after_reversal ? all.after_reversal : all.elsewhere).push_back(present);
    present = {};
  };
  for (std::size_t i = 0; i < track.innovation.size(); ++i) {
    const bool reverses = next < reversals.size() && track.period[i] >= reversals[next];
    while (next < reversals.size() && track.period[i] >= reversals[next]) ++next;
    if (reverses) reversed_s = track.time_s[i];
    if (reverses || track.time_s[i] >= end_s) {
      close();
      after_reversal = reverses;
      end_s = track.time_s[i] + reversal_window_s;
    }
    if (track.discontinuity[i] != 0 || command_of(run, track.channel, track.period[i]) == 0.0) continue;
    present.add(track.innovation[i], track.error[i]);
    if (reversed_s) all.since_reversal.add(track.time_s[i] - *reversed_s, track.innovation[i]);
  }
  close();
  all.duration_s += track.time_s.back() - track.time_s.front();
}

template <typename Value>
double median_of(const std::vector<ReversalWindow>& windows, Value value) {
  std::vector<double> values;
  values.reserve(windows.size());
  for (const ReversalWindow& window : windows) values.push_back((window.*value)());
  return median(std::move(values));
}

// One-sided: that the first are larger. By the normal approximation of the rank sum.
double rank_sum_p_value(const std::vector<ReversalWindow>& larger, const std::vector<ReversalWindow>& than) {
  std::vector<double> others;
  others.reserve(than.size());
  for (const ReversalWindow& window : than) others.push_back(window.power());
  std::ranges::sort(others);
  double above = 0.0;
  for (const ReversalWindow& window : larger) {
    const auto [first, last] = std::equal_range(others.begin(), others.end(), window.power());
    above += static_cast<double>(first - others.begin()) + 0.5 * static_cast<double>(last - first);
  }
  const auto n = static_cast<double>(larger.size());
  const auto m = static_cast<double>(than.size());
  const double deviations = (above - 0.5 * n * m) / std::sqrt(n * m * (n + m + 1.0) / 12.0);
  return 0.5 * std::erfc(deviations / std::sqrt(2.0));
}

double sum_squares_of(const std::vector<ReversalWindow>& windows) {
  double sum = 0.0;
  for (const ReversalWindow& window : windows) sum += window.sum_squares;
  return sum;
}

}  // namespace

std::optional<ReversalResidual> reversal_residual(const FitProblem& problem,
                                                  std::span<const ResidualTrack* const> tracks) {
  ReversalWindows all;
  for (const ResidualTrack* track : tracks) add_windows(problem.runs()[track->run], *track, all);
  if (all.after_reversal.size() < min_reversals || all.elsewhere.size() < min_reversals) return std::nullopt;
  ReversalResidual found;
  found.p_value = rank_sum_p_value(all.after_reversal, all.elsewhere);
  const double power_elsewhere = median_of(all.elsewhere, &ReversalWindow::power);
  if (power_elsewhere > 0.0)
    found.ratio = median_of(all.after_reversal, &ReversalWindow::power) / power_elsewhere;
  const double excess = found.ratio > 1.0 ? 1.0 - 1.0 / found.ratio : 0.0;
  const double excess_m2 = excess * median_of(all.after_reversal, &ReversalWindow::squared_span_m2);
  const auto reversals = static_cast<double>(all.after_reversal.size());
  found.size = std::sqrt(excess_m2 * reversals * horizon_s / all.duration_s);
  const double after = sum_squares_of(all.after_reversal);
  const double power = after + sum_squares_of(all.elsewhere);
  if (power > 0.0) found.share = after / power;
  found.power = all.since_reversal.points();
  found.share_of_time = reversals / (reversals + static_cast<double>(all.elsewhere.size()));
  return found;
}

}  // namespace wheelwright::gap
