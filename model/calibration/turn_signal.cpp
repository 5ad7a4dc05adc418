#include "model/calibration/turn_signal.hpp"

#include <algorithm>
#include <cmath>

#include "model/statistics/order_statistics.hpp"

namespace wheelwright {
namespace {

double turning_ticks(const TurnSample& sample, const TurnSample& start) {
  const double left = static_cast<double>(sample.ticks.left - start.ticks.left);
  const double right = static_cast<double>(sample.ticks.right - start.ticks.right);
  return 0.5 * std::abs(right - left);
}

void remove_means(TurnSignal& signal) {
  for (std::size_t s = 0; s < TurnSignal::sensors; ++s) {
    double sum = 0.0;
    for (const auto& entry : signal.values) sum += entry[s];
    const double mean = sum / static_cast<double>(signal.values.size());
    for (auto& entry : signal.values) entry[s] -= mean;
  }
}

// Noise shows in second differences, surroundings hardly do. The median of their size is robust against edges
// of obstacles; its floor keeps a sensor that sees nothing from counting for ever.
void weigh_by_noise(TurnSignal& signal) {
  for (std::size_t s = 0; s < TurnSignal::sensors; ++s) {
    std::vector<double> bends;
    for (std::size_t i = 2; i < signal.values.size(); ++i) {
      bends.push_back(
          std::abs(signal.values[i][s] - 2.0 * signal.values[i - 1][s] + signal.values[i - 2][s]));
    }
    if (bends.empty()) continue;
    const double deviation =
        std::max(deviations_of_median_size * median(std::move(bends)) / std::sqrt(6.0), 1.0);
    signal.weight.at(s) = 1.0 / (deviation * deviation);
  }
}

// Between entries the signal is read by straight lines, which would average noise away just halfway between
// them and so draw every best match there. Smoothed over less than an obstacle's width it no longer matters.
void smooth(TurnSignal& signal) {
  constexpr int passes = 4;
  for (int pass = 0; pass < passes; ++pass) {
    auto before = signal.values.front();
    for (std::size_t i = 1; i + 1 < signal.values.size(); ++i) {
      const auto here = signal.values[i];
      for (std::size_t s = 0; s < TurnSignal::sensors; ++s) {
        signal.values[i].at(s) = 0.25 * before.at(s) + 0.5 * here.at(s) + 0.25 * signal.values[i + 1].at(s);
      }
      before = here;
    }
  }
}

}  // namespace

TurnWays split_at_reversal(std::span<const TurnSample> samples) {
  // What a robot swings back when it stops is less.
  constexpr double shortest_way_ticks = 100.0;
  if (samples.empty()) return {};
  const auto turned = [&](const TurnSample& sample) { return turning_ticks(sample, samples.front()); };
  const auto furthest = std::ranges::max_element(samples, {}, turned);
  const auto first = static_cast<std::size_t>(furthest - samples.begin());
  if (turned(*furthest) - turned(samples.back()) < shortest_way_ticks) return {samples, {}};
  return {samples.first(first + 1), samples.subspan(first)};
}

TurnSignal resample_turn(std::span<const TurnSample> samples, double step_ticks) {
  TurnSignal signal;
  signal.step_ticks = step_ticks;
  double next = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double before = turning_ticks(samples[k - 1], samples.front());
    const double here = turning_ticks(samples[k], samples.front());
    for (; here > before && next <= here; next += step_ticks) {
      if (next < before) continue;
      const double share = (next - before) / (here - before);
      auto& entry = signal.values.emplace_back();
      for (std::size_t s = 0; s < TurnSignal::sensors; ++s) {
        entry.at(s) =
            (1.0 - share) * samples[k - 1].light_bumper.at(s) + share * samples[k].light_bumper.at(s);
      }
    }
  }
  if (signal.values.empty()) return signal;
  remove_means(signal);
  weigh_by_noise(signal);
  smooth(signal);
  return signal;
}

double match_at_lag(const TurnSignal& signal, double lag, std::size_t first, std::size_t last) {
  const auto whole = static_cast<std::size_t>(lag);
  const double share = lag - static_cast<double>(whole);
  if (whole + 1 >= signal.values.size()) return -1.0;
  last = std::min(last, signal.values.size() - whole - 1);
  double product = 0.0;
  double here_power = 0.0;
  double there_power = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const auto& here = signal.values[i];
    const auto& there = signal.values[i + whole];
    const auto& after = signal.values[i + whole + 1];
    for (std::size_t s = 0; s < TurnSignal::sensors; ++s) {
      const double shifted = (1.0 - share) * there.at(s) + share * after.at(s);
      product += signal.weight.at(s) * shifted * here.at(s);
      here_power += signal.weight.at(s) * here.at(s) * here.at(s);
      there_power += signal.weight.at(s) * shifted * shifted;
    }
  }
  const double power = std::sqrt(here_power * there_power);
  return power > 0.0 ? product / power : -1.0;
}

}  // namespace wheelwright
