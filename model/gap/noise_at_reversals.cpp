#include "model/gap/noise_at_reversals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace wheelwright::gap {
namespace {

constexpr double behind_s = 0.7;
constexpr double at_rest_m_s = 1e-3;

struct Power {
  double squares = 0.0;
  double readings = 0.0;

  void add(double innovation) {
    squares += innovation * innovation;
    readings += 1.0;
  }
  void add(const Power& other) {
    squares += other.squares;
    readings += other.readings;
  }
  double mean() const { return readings > 0.0 ? squares / readings : 0.0; }
};

struct Reversal {
  std::size_t period;
  Power power = {};
  double least_error_m = std::numeric_limits<double>::infinity();
  double largest_error_m = -std::numeric_limits<double>::infinity();
};

double of_wheel(const WheelPair& pair, Channel wheel) {
  return wheel == Channel::left ? pair.left : pair.right;
}

std::vector<Reversal> reversals_of(const GapRun& run, Channel wheel) {
  std::vector<Reversal> found;
  double last_m_s = 0.0;
  for (std::size_t k = 0; k < run.commands_m_s.size(); ++k) {
    const double command_m_s = of_wheel(run.commands_m_s[k], wheel);
    if (std::abs(command_m_s) < at_rest_m_s) continue;
    if (command_m_s * last_m_s < 0.0) found.push_back({k});
    last_m_s = command_m_s;
  }
  return found;
}

// The last one before a moment, if it is not long ago.
Reversal* just_before(std::vector<Reversal>& reversals, std::size_t period, double period_s) {
  const auto next = std::ranges::upper_bound(reversals, period, {}, &Reversal::period);
  if (next == reversals.begin()) return nullptr;
  Reversal& last = *std::prev(next);
  return static_cast<double>(period - last.period) * period_s < behind_s ? &last : nullptr;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

// Of both wheels of each run, two to a run.
using WheelsReversals = std::vector<std::array<std::vector<Reversal>, 2>>;

WheelsReversals reversals_of(const GapProblem& problem) {
  WheelsReversals all;
  for (const GapRun& run : problem.runs())
    all.push_back({reversals_of(run, Channel::left), reversals_of(run, Channel::right)});
  return all;
}

}  // namespace

NoiseAtReversals noise_at_reversals(const GapProblem& problem, const TrialModel& model,
                                    std::span<const double> residuals) {
  std::vector<RunErrors> errors;
  for (const GapRun& run : problem.runs()) errors.push_back(free_run_errors(model, run));
  WheelsReversals reversals = reversals_of(problem);
  Power elsewhere;
  for (std::size_t i = 0; i < problem.places().size(); ++i) {
    const auto& place = problem.places()[i];
    if (!place.channel || *place.channel > Channel::right || residuals[i] == 0.0) continue;
    const auto wheel = static_cast<std::size_t>(*place.channel);
    const double period_s = problem.runs()[place.run].period_s;
    Reversal* reversal = just_before(reversals[place.run].at(wheel), place.period, period_s);
    if (reversal == nullptr) {
      elsewhere.add(residuals[i]);
      continue;
    }
    const double error_m = errors[place.run].series.at(wheel)[place.reading];
    reversal->power.add(residuals[i]);
    reversal->least_error_m = std::min(reversal->least_error_m, error_m);
    reversal->largest_error_m = std::max(reversal->largest_error_m, error_m);
  }
  Power behind;
  std::vector<double> powers;
  std::vector<double> spans_m;
  for (const auto& wheels : reversals) {
    for (const auto& wheel : wheels) {
      for (const Reversal& reversal : wheel) {
        if (reversal.power.readings == 0.0) continue;
        behind.add(reversal.power);
        powers.push_back(reversal.power.mean());
        spans_m.push_back(reversal.largest_error_m - reversal.least_error_m);
      }
    }
  }
  if (powers.empty() || elsewhere.squares == 0.0) return {};
  return {powers.size(), median(powers) / elsewhere.mean(), median(spans_m),
          behind.squares / (behind.squares + elsewhere.squares),
          behind.readings / (behind.readings + elsewhere.readings)};
}

bool too_much_for_noise(const NoiseAtReversals& noise) {
  constexpr std::size_t often = 10;
  constexpr double far_above_the_rest = 2.2;  // of 64 clean logs none came above 1.6 that moved by so far
  constexpr double least_span_m = 5e-4;
  return noise.reversals >= often && noise.times >= far_above_the_rest && noise.error_span_m >= least_span_m;
}

}  // namespace wheelwright::gap
