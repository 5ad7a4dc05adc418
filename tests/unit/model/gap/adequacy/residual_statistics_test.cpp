// Statistics of the predictive check on series whose law is known.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "model/gap/adequacy/dependence.hpp"
#include "model/gap/adequacy/periodic_residual.hpp"
#include "model/gap/adequacy/swing_amplitude.hpp"
#include "model/gap/adequacy/tail_probability.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr std::size_t readings = 2000;

// A random walk of 1 mm per reading with what is added to it; its innovations are its steps over 1 mm.
// `colour` correlates neighbouring innovations.
ResidualTrack track_of(unsigned seed, const std::function<double(double time_s)>& added_m,
                       double colour = 0.0) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  ResidualTrack track;
  double walk_m = 0.0;
  double step = 0.0;
  for (std::size_t i = 0; i < readings; ++i) {
    const double time_s = period_s * static_cast<double>(i);
    step = colour * step + std::sqrt(1.0 - colour * colour) * normal(engine);
    if (i > 0) walk_m += 1e-3 * step;
    const double error_m = walk_m + added_m(time_s);
    track.period.push_back(i);
    track.time_s.push_back(time_s);
    track.innovation.push_back(i == 0 ? 0.0 : 1e3 * (error_m - track.error.back()));
    track.error.push_back(error_m);
    track.discontinuity.push_back(i == 0 ? 1 : 0);
  }
  return track;
}

double none(double) {
  return 0.0;
}

struct TwoRuns {
  explicit TwoRuns(unsigned seed, const std::function<double(double)>& added_m = none, double colour = 0.0)
      : tracks{track_of(2 * seed, added_m, colour), track_of(2 * seed + 1, added_m, colour)} {}

  std::optional<PeriodicResidual> periodic() const {
    const std::vector<const ResidualTrack*> all{&tracks[0], &tracks[1]};
    const std::vector<std::vector<double>> at{tracks[0].time_s, tracks[1].time_s};
    return periodic_residual(all, at, PeriodicResidual::Over::time);
  }
  std::optional<Dependence> on(const std::function<double(double time_s)>& quantity) const {
    const std::vector<const ResidualTrack*> all{&tracks[0], &tracks[1]};
    Covariate covariate{"the heading", "rad", {}};
    for (const ResidualTrack& track : tracks) {
      auto& values = covariate.value.emplace_back();
      for (const double time_s : track.time_s) values.push_back(quantity(time_s));
    }
    return dependence(all, covariate);
  }

  std::array<ResidualTrack, 2> tracks;
};

double slow_turn(double time_s) {
  return std::remainder(0.9 * time_s, 2.0 * std::numbers::pi);
}

// How many of so many p-values lie below a level.
template <typename PValue>
int below(double level, int count, PValue p_value) {
  int found = 0;
  for (int seed = 0; seed < count; ++seed) found += p_value(static_cast<unsigned>(seed)) < level ? 1 : 0;
  return found;
}

}  // namespace

TEST_CASE("The tail of chi squared agrees with printed tables, and far out with its closed form") {
  CHECK_THAT(chi_squared_tail(3.841, 1), WithinRel(0.05, 0.001));
  CHECK_THAT(chi_squared_tail(18.475, 7), WithinRel(0.01, 0.001));
  CHECK_THAT(chi_squared_tail(29.588, 10), WithinRel(0.001, 0.001));
  CHECK_THAT(chi_squared_tail(50.0, 4), WithinRel(26.0 * std::exp(-25.0), 1e-9));
  CHECK(chi_squared_tail(0.0, 3) == 1.0);
  CHECK_THAT(smallest_of(1e-10, 50.0), WithinRel(5e-9, 0.01));
  CHECK_THAT(smallest_of(0.01, 2.0), WithinRel(0.0199, 1e-9));
}

TEST_CASE("A swing within a random walk is found with its period and its size") {
  const auto found =
      TwoRuns(1, [](double t) { return 0.006 * std::sin(2.0 * std::numbers::pi * t / 1.43); }).periodic();
  REQUIRE(found);
  CHECK(found->p_value < 1e-4);
  CHECK_THAT(found->period, WithinRel(1.43, 0.02));
  CHECK_THAT(found->amplitude, WithinRel(0.006, 0.3));
}

TEST_CASE("A swing that is struck again and again in any phase has the size that a plot shows") {
  constexpr double amplitude_m = 0.008;
  const auto struck = [](double time_s) {
    const double blow = std::floor(time_s / 7.0);
    const double phase = 2.4 * blow * blow;  // of another phase each time
    return amplitude_m * std::sin(2.0 * std::numbers::pi * time_s / 1.1 + phase);
  };
  const auto found = TwoRuns(3, struck).periodic();
  REQUIRE(found);
  CHECK(found->p_value < 1e-4);
  CHECK_THAT(found->period, WithinRel(1.1, 0.1));
  CHECK_THAT(found->amplitude, WithinRel(amplitude_m, 0.3));
}

TEST_CASE("A swing that comes now and then has the size that it has there") {
  const auto at_times = [](double time_s) {
    const bool swings = std::fmod(time_s, 20.0) < 6.0;
    return swings ? 0.012 * std::sin(2.0 * std::numbers::pi * time_s / 0.7) : 0.0;
  };
  const auto found = TwoRuns(4, at_times).periodic();
  REQUIRE(found);
  CHECK_THAT(found->period, WithinRel(0.7, 0.03));
  CHECK_THAT(found->amplitude, WithinRel(0.012, 0.3));
  const auto crest = std::ranges::max_element(found->folded, {}, &std::pair<double, double>::second);
  REQUIRE(crest != found->folded.end());
  CHECK_THAT(crest->second, WithinRel(0.012, 0.4));
}

TEST_CASE("A random walk without a swing has no amplitude to speak of at any period") {
  for (const double period_s : {0.5, 1.0, 2.0, 4.0}) {
    SwingAmplitude swing(period_s);
    for (unsigned seed = 0; seed < 40; ++seed) {
      const ResidualTrack track = track_of(9100 + seed, none);
      swing.add(track.error, track.time_s);
    }
    // Least squares alone find 1.2 and 1.8 mm in a second.
    CHECK(std::sqrt(swing.mean_square()) < 0.0006 * std::sqrt(period_s));
    CHECK(swing.amplitude() < 0.0012 * std::sqrt(period_s));
  }
}

TEST_CASE("A swing at the end of a run that is no whole number of windows long is measured") {
  std::vector<double> error_m;
  std::vector<double> at_s;
  for (int k = 0; k < 700; ++k) {
    at_s.push_back(0.01 * k);
    error_m.push_back(at_s.back() < 4.5 ? 0.0 : 0.01 * std::sin(2.0 * std::numbers::pi * at_s.back()));
  }
  SwingAmplitude swing(1.0);
  swing.add(error_m, at_s);
  CHECK_THAT(swing.amplitude(), WithinRel(0.007, 0.3));
  CHECK(swing.strongest().to == error_m.size());
}

TEST_CASE("A jump is no swing, and what is shorter than four periods is not measured") {
  std::vector<double> error_m(1000, 0.0);
  std::vector<double> at_s(1000);
  for (std::size_t k = 0; k < at_s.size(); ++k) at_s[k] = 0.01 * static_cast<double>(k);
  std::vector<char> breaks(1000, 0);
  breaks[520] = 1;
  std::fill(error_m.begin() + 520, error_m.end(), 0.065);
  SwingAmplitude swing(1.0);
  swing.add(error_m, at_s, breaks);
  CHECK(swing.amplitude() < 1e-6);
  SwingAmplitude slower(3.0);
  slower.add(error_m, at_s, breaks);
  CHECK(slower.amplitude() == 0.0);
  CHECK(slower.strongest().to == 0);
}

TEST_CASE("Over the travel of a wheel that goes to and fro a swing is measured by the range that it covers") {
  std::vector<double> error_m;
  std::vector<double> at_m;
  for (int k = 0; k < 2000; ++k) {
    at_m.push_back(0.5 + 0.5 * std::sin(0.01 * k));
    error_m.push_back(0.004 * std::sin(2.0 * std::numbers::pi * at_m.back() / 0.2 + 0.3));
  }
  SwingAmplitude swing(0.2);
  swing.add(error_m, at_m);
  CHECK_THAT(swing.amplitude(), WithinRel(0.004, 0.1));
}

TEST_CASE("Readings too far apart to hold a sine have no amplitude, whatever they are") {
  std::vector<double> error_m;
  std::vector<double> at_m;
  for (int k = 0; k < 400; ++k) {
    at_m.push_back(0.025 * k);
    error_m.push_back(k % 3 == 0 ? 0.01 : -0.01);
  }
  SwingAmplitude swing(0.0125);
  swing.add(error_m, at_m);
  CHECK(swing.amplitude() == 0.0);
}

TEST_CASE("White innovations seldom show a period: p-values are uniform within what 200 series tell") {
  const auto p_value = [](unsigned seed) { return TwoRuns(seed + 9700).periodic()->p_value; };
  const int at_ten_percent = below(0.1, 200, p_value);
  CHECK(at_ten_percent >= 6);
  CHECK(at_ten_percent <= 36);
}

TEST_CASE("Noise of another colour than modelled has no period") {
  const auto p_value = [](unsigned seed) { return TwoRuns(seed + 9300, none, 0.9).periodic()->p_value; };
  CHECK(below(0.001, 100, p_value) <= 1);
}

TEST_CASE("A drift that depends on the heading is found, with the headings where it is largest") {
  double sum_m = 0.0;
  const auto with_drift = [&](double t) {
    if (t == 0.0) sum_m = 0.0;
    if (slow_turn(t) > 2.0) sum_m += 1e-3;
    return sum_m;
  };
  const auto found = TwoRuns(3, with_drift).on(slow_turn);
  REQUIRE(found);
  CHECK(found->p_value < 1e-4);
  CHECK_THAT(found->size, WithinRel(0.0157, 0.25));  // what eight bins hold of it, without the walk
  CHECK(found->to > 2.0);
}

TEST_CASE("White innovations depend on nothing, nor do correlated ones") {
  const auto white = [](unsigned seed) { return TwoRuns(seed + 8100).on(slow_turn)->p_value; };
  const auto coloured = [](unsigned seed) { return TwoRuns(seed + 8500, none, 0.95).on(slow_turn)->p_value; };
  CHECK(below(0.1, 200, white) <= 36);
  CHECK(below(0.01, 200, coloured) <= 7);
}

TEST_CASE("Where a quantity hardly varies there is nothing to depend on") {
  CHECK_FALSE(TwoRuns(4).on([](double) { return 1.0; }));
}

TEST_CASE("What follows the sign of another quantity is found, and cancels without it") {
  // A drift of 20 mm/s for 0.4 s after each change of command, in the direction of the change.
  const auto sign_at = [](double t) { return static_cast<int>(t / 1.5) % 2 == 0 ? 1.0 : -1.0; };
  const auto since = [](double t) { return std::fmod(t, 1.5); };
  double sum_m = 0.0;
  const TwoRuns runs(7, [&](double t) {
    if (t == 0.0) sum_m = 0.0;
    if (since(t) < 0.4) sum_m += sign_at(t) * 0.02 * period_s;
    return sum_m;
  });
  const std::vector<const ResidualTrack*> all{&runs.tracks[0], &runs.tracks[1]};
  Covariate covariate{"the time since a change of command", "s", {}, {}};
  for (const ResidualTrack& track : runs.tracks) {
    auto& values = covariate.value.emplace_back();
    auto& signs = covariate.sign.emplace_back();
    for (const double time_s : track.time_s) {
      values.push_back(since(time_s));
      signs.push_back(sign_at(time_s));
    }
  }
  const auto found = dependence(all, covariate);
  REQUIRE(found);
  CHECK(found->p_value < 1e-4);
  CHECK(found->to < 0.45);
  covariate.sign.clear();
  CHECK(dependence(all, covariate)->p_value > 0.01);
}
