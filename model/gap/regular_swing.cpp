#include "model/gap/regular_swing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace wheelwright::gap {
namespace {

constexpr double swings_in_a_run = 4.0;  // at least
constexpr double per_resolution = 2.0;   // steps of frequency for each that a run tells apart
constexpr double shortest_way_m = 0.012;
constexpr double shortest_time_s = 0.125;
constexpr double shortest_periods = 3.0;

// Readings of one channel of one run, along time or way.
struct Track {
  std::size_t run = 0;
  Channel channel = Channel::left;
  std::vector<double> at;
  std::vector<double> value;
};

struct Frequencies {
  double first = 0.0;  // 1/s or 1/m
  double step = 0.0;
  std::size_t count = 0;
  double at(std::size_t index) const { return first + step * static_cast<double>(index); }
};

std::vector<Track> tracks_of(const GapProblem& problem, std::span<const double> residuals,
                             RegularSwing::Over over) {
  std::vector<Track> tracks;
  const auto& places = problem.places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& place = places[i];
    if (!place.channel) continue;
    const GapRun& run = problem.runs()[place.run];
    const bool of_wheel = *place.channel == Channel::left || *place.channel == Channel::right;
    if (over == RegularSwing::Over::way && !of_wheel) continue;
    if (tracks.empty() || tracks.back().run != place.run || tracks.back().channel != *place.channel) {
      tracks.push_back({place.run, *place.channel, {}, {}});
    }
    tracks.back().at.push_back(over == RegularSwing::Over::way
                                   ? run[*place.channel].value[place.reading]
                                   : run.period_s * static_cast<double>(place.period));
    tracks.back().value.push_back(residuals[i]);
  }
  return tracks;
}

Frequencies frequencies_for(const std::vector<Track>& tracks, double shortest) {
  double longest = 0.0;
  for (const Track& track : tracks) {
    const auto [from, to] = std::ranges::minmax(track.at);
    longest = std::max(longest, to - from);
  }
  if (longest < 2.0 * swings_in_a_run * shortest) return {};
  Frequencies all;
  all.first = swings_in_a_run / longest;
  all.step = 1.0 / (per_resolution * longest);
  all.count = static_cast<std::size_t>((1.0 / shortest - all.first) / all.step);
  return all;
}

// Sums of value times wave, for each frequency: the wave of one follows from that of the one before.
std::vector<std::complex<double>> waves(const Track& track, const Frequencies& frequencies) {
  std::vector<std::complex<double>> sums(frequencies.count);
  for (std::size_t k = 0; k < track.at.size(); ++k) {
    const double turn = 2.0 * std::numbers::pi * track.at[k];
    std::complex<double> wave = std::polar(track.value[k], turn * frequencies.first);
    const std::complex<double> next = std::polar(1.0, turn * frequencies.step);
    for (auto& sum : sums) {
      sum += wave;
      wave *= next;
    }
  }
  return sums;
}

// Of the power of all tracks, what a swing of each frequency holds, with a phase of its own in each track.
std::vector<double> shares(const std::vector<Track>& tracks, const Frequencies& frequencies) {
  std::vector<double> power(frequencies.count, 0.0);
  double all = 0.0;
  for (const Track& track : tracks) {
    const auto sums = waves(track, frequencies);
    for (std::size_t i = 0; i < power.size(); ++i) {
      power[i] += 2.0 * std::norm(sums[i]) / static_cast<double>(track.at.size());
    }
    all += squares_of(track.value);
  }
  for (double& one : power) one /= std::max(all, 1e-300);
  return power;
}

double usual_around(const std::vector<double>& power, std::size_t place) {
  constexpr std::size_t near = 40;
  constexpr std::size_t of_the_peak = 4;
  std::vector<double> around;
  for (std::size_t i = place > near ? place - near : 0; i < std::min(power.size(), place + near); ++i) {
    if (i + of_the_peak < place || i > place + of_the_peak) around.push_back(power[i]);
  }
  if (around.empty()) return power[place];
  const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
  std::ranges::nth_element(around, middle);
  return *middle;
}

std::optional<RegularSwing> strongest(const std::vector<Track>& tracks, RegularSwing::Over over,
                                      double shortest) {
  constexpr double least_share = 0.05;
  constexpr double stands_out = 12.0;
  const Frequencies frequencies = frequencies_for(tracks, shortest);
  if (frequencies.count == 0) return std::nullopt;
  const auto power = shares(tracks, frequencies);
  const auto place = static_cast<std::size_t>(std::ranges::max_element(power) - power.begin());
  if (power[place] < least_share || power[place] < stands_out * usual_around(power, place)) {
    return std::nullopt;
  }
  return RegularSwing{over, 1.0 / frequencies.at(place), power[place]};
}

// Of the errors of travel, root mean square over all tracks.
double amplitude_m(const GapProblem& problem, const TrialModel& model, double period_s) {
  double squares = 0.0;
  std::size_t count = 0;
  for (const GapRun& run : problem.runs()) {
    const RunErrors errors = free_run_errors(model, run);
    for (const Channel channel : {Channel::left, Channel::right, Channel::forward}) {
      const auto& error = errors.series[static_cast<std::size_t>(channel)];
      if (error.size() < 2) continue;
      Track track;
      for (std::size_t k = 1; k < error.size(); ++k) {
        track.at.push_back(run.period_s * static_cast<double>(run[channel].at[k].period));
        track.value.push_back(error[k] - error[k - 1]);
      }
      const auto sums = waves(track, {1.0 / period_s, 0.0, 1});
      const double of_steps = 2.0 * std::abs(sums.front()) / static_cast<double>(track.at.size());
      const double of_travel = of_steps / (2.0 * std::sin(std::numbers::pi * run.period_s / period_s));
      squares += of_travel * of_travel;
      ++count;
    }
  }
  return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

std::optional<RegularSwing> regular_swing(const GapProblem& problem, const TrialModel& model,
                                          std::span<const double> residuals) {
  constexpr double beyond_rounding = 5.0;
  const double period_s = problem.runs().front().period_s;
  const auto by_time =
      strongest(tracks_of(problem, residuals, RegularSwing::Over::time), RegularSwing::Over::time,
                std::max(shortest_time_s, shortest_periods * period_s));
  const auto by_way = strongest(tracks_of(problem, residuals, RegularSwing::Over::way),
                                RegularSwing::Over::way, shortest_way_m);
  if (by_way && (!by_time || by_way->share > by_time->share)) return by_way;
  if (!by_time) return std::nullopt;
  const double rounding_m = problem.smallest_reading(static_cast<std::size_t>(Channel::left));
  if (amplitude_m(problem, model, by_time->period) < beyond_rounding * rounding_m) return std::nullopt;
  return by_time;
}

}  // namespace wheelwright::gap
