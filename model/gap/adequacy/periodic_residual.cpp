#include "model/gap/adequacy/periodic_residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "model/gap/adequacy/swing_amplitude.hpp"
#include "model/gap/adequacy/tail_probability.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_cycles = 4.0;            // in the longest run
constexpr double steps_per_resolution = 2.0;  // of frequency
constexpr double shortest_period_s = 0.2;
constexpr double shortest_period_m = 0.012;
constexpr double shortest_readings = 3.0;

struct Frequencies {
  double first = 0.0;  // 1/s or 1/m
  double step = 0.0;
  std::size_t count = 0;
  double at(std::size_t index) const { return first + step * static_cast<double>(index); }
};

Frequencies frequencies_for(std::span<const std::vector<double>> at, double shortest) {
  double longest = 0.0;
  for (const auto& positions : at) {
    if (positions.empty()) continue;
    const auto [from, to] = std::ranges::minmax(positions);
    longest = std::max(longest, to - from);
  }
  if (longest < 2.0 * min_cycles * shortest) return {};
  const double first = min_cycles / longest;
  const double step = 1.0 / (steps_per_resolution * longest);
  return {first, step, static_cast<std::size_t>((1.0 / shortest - first) / step)};
}

// What each value is beyond its share of the one before: a spectrum that falls over all frequencies becomes
// flat, a line stays. The share is the correlation of neighbours.
std::vector<double> prewhitened(std::span<const double> values) {
  double sum_squares = 0.0;
  double products = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sum_squares += values[k] * values[k];
    if (k > 0) products += values[k] * values[k - 1];
  }
  const double share = sum_squares > 0.0 ? products / sum_squares : 0.0;
  std::vector<double> result(values.begin(), values.end());
  for (std::size_t k = values.size(); k-- > 1;) result[k] -= share * values[k - 1];
  return result;
}

// Adds |sum of value times wave|^2 / sum of value^2 to the power at each frequency; the wave at one frequency
// follows from that at the one before.
void add_power(std::span<const double> values, std::span<const double> at, const Frequencies& frequencies,
               std::vector<double>& power) {
  std::vector<std::complex<double>> sums(frequencies.count);
  double sum_squares = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k] == 0.0) continue;
    sum_squares += values[k] * values[k];
    const double angle = 2.0 * std::numbers::pi * at[k];
    std::complex<double> wave = std::polar(values[k], angle * frequencies.first);
    const std::complex<double> next = std::polar(1.0, angle * frequencies.step);
    for (auto& sum : sums) {
      sum += wave;
      wave *= next;
    }
  }
  if (sum_squares <= 0.0) return;
  for (std::size_t i = 0; i < power.size(); ++i) power[i] += std::norm(sums[i]) / sum_squares;
}

// Over the frequencies around one, those of the peak itself left out.
double median_around(const std::vector<double>& power, std::size_t place) {
  constexpr std::size_t width = 60;
  constexpr std::size_t peak = 4;
  const std::size_t begin = place > width ? place - width : 0;
  std::vector<double> context;
  for (std::size_t i = begin; i < std::min(power.size(), place + width); ++i) {
    if (i + peak < place || i > place + peak) context.push_back(power[i]);
  }
  if (context.empty()) return 0.0;
  return median(std::move(context));
}

// Mean square of the free-run error about its mean over each four periods.
double mean_square_within(const ResidualTrack& track, std::span<const double> at, double period) {
  constexpr double periods = 4.0;
  double sum_squares = 0.0;
  double count = 0.0;
  for (std::size_t from = 0; from < track.error.size();) {
    std::size_t to = from;
    while (to + 1 < track.error.size() && std::abs(at[to + 1] - at[from]) < periods * period) ++to;
    double mean = 0.0;
    for (std::size_t i = from; i <= to; ++i) mean += track.error[i] / static_cast<double>(to - from + 1);
    for (std::size_t i = from; i <= to; ++i) sum_squares += (track.error[i] - mean) * (track.error[i] - mean);
    count += static_cast<double>(to - from + 1);
    from = to + 1;
  }
  return count > 0.0 ? sum_squares / count : 0.0;
}

// The error about its mean over each period of a window, folded onto one period.
std::vector<std::pair<double, double>> folded(std::span<const double> error, std::span<const double> at,
                                              double period) {
  constexpr std::size_t bins = 24;
  std::array<double, bins> sums{};
  std::array<double, bins> counts{};
  for (std::size_t from = 0; from < error.size();) {
    std::size_t to = from;
    while (to + 1 < error.size() && std::abs(at[to + 1] - at[from]) < period) ++to;
    double mean = 0.0;
    for (std::size_t i = from; i <= to; ++i) mean += error[i] / static_cast<double>(to - from + 1);
    for (std::size_t i = from; i <= to; ++i) {
      const double turns = at[i] / period;
      const auto bin = static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(bins));
      sums.at(std::min(bin, bins - 1)) += error[i] - mean;
      counts.at(std::min(bin, bins - 1)) += 1.0;
    }
    from = to + 1;
  }
  std::vector<std::pair<double, double>> curve;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (counts.at(bin) == 0.0) continue;
    const double position = (static_cast<double>(bin) + 0.5) / static_cast<double>(bins);
    curve.emplace_back(position * period, sums.at(bin) / counts.at(bin));
  }
  return curve;
}

// Between neighbouring readings, those at the same place left out; of the track that was read least often.
double usual_step(std::span<const std::vector<double>> at) {
  double longest = 0.0;
  for (const auto& positions : at) {
    std::vector<double> steps;
    for (std::size_t k = 1; k < positions.size(); ++k) {
      const double step = std::abs(positions[k] - positions[k - 1]);
      if (step > 0.0) steps.push_back(step);
    }
    if (!steps.empty()) longest = std::max(longest, median(std::move(steps)));
  }
  return longest;
}

// A shorter one would stand for another: coarse counts that are read seldom repeat at many periods.
double shortest_period(std::span<const std::vector<double>> at, PeriodicResidual::Over over) {
  return std::max(over == PeriodicResidual::Over::travel ? shortest_period_m : shortest_period_s,
                  shortest_readings * usual_step(at));
}

}  // namespace

std::optional<PeriodicResidual> periodic_residual(std::span<const ResidualTrack* const> tracks,
                                                  std::span<const std::vector<double>> at,
                                                  PeriodicResidual::Over over) {
  if (tracks.empty()) return std::nullopt;
  const Frequencies frequencies = frequencies_for(at, shortest_period(at, over));
  if (frequencies.count == 0) return std::nullopt;
  std::vector<double> power(frequencies.count, 0.0);
  for (std::size_t t = 0; t < tracks.size(); ++t)
    add_power(prewhitened(tracks[t]->innovation), at[t], frequencies, power);

  const int degrees = 2 * static_cast<int>(tracks.size());
  const double median =
      0.5 * degrees * std::pow(1.0 - 2.0 / (9.0 * degrees), 3);  // Wilson and Hilferty, 1931
  std::size_t peak = 0;
  double highest = 0.0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    const double context = median_around(power, i);
    if (context <= 0.0 || power[i] / context <= highest) continue;
    highest = power[i] / context;
    peak = i;
  }
  PeriodicResidual found;
  found.over = over;
  found.period = 1.0 / frequencies.at(peak);
  // Neighbouring frequencies overlap, and the median of a neighbourhood scatters: by simulation of white
  // series the peak is that of 1.6 independent ones for each.
  const double independent = 1.6 * static_cast<double>(frequencies.count);
  found.p_value = smallest_of(chi_squared_tail(2.0 * median * highest, degrees), independent);
  SwingAmplitude swing(found.period);
  double mean_square = 0.0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    swing.add(tracks[t]->error, at[t], tracks[t]->discontinuity);
    mean_square += mean_square_within(*tracks[t], at[t], found.period) / static_cast<double>(tracks.size());
  }
  found.amplitude = swing.amplitude();
  if (mean_square > 0.0) found.share = std::min(1.0, 0.5 * swing.mean_square() / mean_square);
  const auto& [series, from, to] = swing.strongest();
  found.folded = folded(std::span(tracks[series]->error).subspan(from, to - from),
                        std::span(at[series]).subspan(from, to - from), found.period);
  return found;
}

}  // namespace wheelwright::gap
