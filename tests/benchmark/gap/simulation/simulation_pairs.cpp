// How often `gap --simulation` says rightly how a simulator and a robot differ: both are robots of the gap
// benchmark, with one effect hidden in either, in both by the same size or by another, or in none, and with
// commands that take effect later in the robot, or not. Where the size that is hidden is a parameter of the
// library, also how often its interval holds it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <vector>

#include "model/gap/simulation_gap.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/gap_plant/plant_parameters.hpp"

namespace wheelwright {
namespace {

using gap::DifferenceKind;

struct Pair {
  const test::HiddenEffect* effect = nullptr;
  DifferenceKind kind = DifferenceKind::missing;
  std::size_t later_periods = 0;  // that the robot answers
  std::uint64_t seed = 0;
};

struct Count {
  int hits = 0;
  int all = 0;
  void add(bool hit) {
    hits += hit ? 1 : 0;
    ++all;
  }
};

// An effect whose size in the robot is a parameter of the library, but for its sign. What a speed controller
// or the load on the motors takes back in part (direction_gain, yaw_bias) is none of them.
struct SizedEffect {
  std::string_view effect;
  std::string_view parameter;
  double parameter_per_size = 1.0;
};

constexpr double wheel_base_m = test::PlantParameters{}.wheel_base_m;
constexpr std::array sized_effects{
    SizedEffect{"backlash", "gap"},
    SizedEffect{"command_quantization", "step"},
    SizedEffect{"dead_zone", "threshold"},
    SizedEffect{"distance_scale", "change"},
    SizedEffect{"saturation", "limit"},
    SizedEffect{"effective_track", "excess", wheel_base_m},
    SizedEffect{"wheel_scale_mismatch", "mismatch"},
};

struct Tally {
  std::map<DifferenceKind, Count> right;
  Count extra;     // pairs in which some other effect is said to differ
  Count size;      // of what is said rightly, in the simulator and in the robot: its interval holds the truth
  Count delay;     // that is there and said, to half a period
  Count no_delay;  // that is not there and not said
};

// That a linear model with counts holds by itself, or that no simulation shows.
bool is_left_out(const test::HiddenEffect& effect) {
  return test::is_outside_library(effect) || effect.name == "encoder_dropout" ||
         effect.name == "transport_delay";
}

std::vector<DriveLog> runs_of(const Pair& pair, bool hidden, test::Severity severity) {
  test::GapCaseSpec spec;
  spec.name = hidden ? std::string(pair.effect->name) : "clean";
  spec.severity = severity;
  spec.seed = pair.seed;
  spec.runs = 3;
  spec.seconds = 40.0;
  return test::make_gap_case(spec).runs;
}

std::vector<DriveLog> answering_later(std::vector<DriveLog> runs, std::size_t periods) {
  for (DriveLog& run : runs) {
    for (std::size_t row = 0; row + periods < run.samples.size(); ++row)
      run.samples[row].command_m_s = run.samples[row + periods].command_m_s;
    run.samples.resize(run.samples.size() - periods);
  }
  return runs;
}

Pair random_pair(std::mt19937_64& random) {
  std::vector<const test::HiddenEffect*> effects;
  for (const test::HiddenEffect& effect : test::hidden_effects())
    if (!is_left_out(effect)) effects.push_back(&effect);
  constexpr std::array kinds{DifferenceKind::missing, DifferenceKind::surplus, DifferenceKind::wrong_size,
                             DifferenceKind::same};
  std::uniform_int_distribution<std::size_t> any_effect(0, effects.size() - 1);
  std::uniform_int_distribution<std::size_t> any_kind(0, kinds.size() - 1);
  std::uniform_int_distribution<std::size_t> any_delay(0, 3);
  Pair pair{effects[any_effect(random)], kinds.at(any_kind(random)), 0, random()};
  const std::size_t later = any_delay(random);
  pair.later_periods = later == 1 ? 0 : later;  // one period is not always told
  return pair;
}

bool says(const gap::SimulationGap& gap, const Pair& pair) {
  const auto found = std::ranges::find(gap.differences, pair.effect->name, &gap::EffectDifference::effect);
  return found != gap.differences.end() && found->kind == pair.kind;
}

bool says_another(const gap::SimulationGap& gap, const Pair& pair) {
  return std::ranges::any_of(gap.differences, [&](const gap::EffectDifference& difference) {
    return difference.effect != pair.effect->name && difference.kind != DifferenceKind::same &&
           difference.kind != DifferenceKind::not_shown;
  });
}

// The size alone: some effects are hidden with either sign.
bool holds_size(const gap::Known& known, double size) {
  const auto [lower, upper] = known.interval;
  return (lower <= size && size <= upper) || (lower <= -size && -size <= upper);
}

struct Sizes {
  double simulation = 0.0;
  double robot = 0.0;
};

void check_sizes(const gap::SimulationGap& gap, const Pair& pair, const Sizes& truth, Count& count) {
  const auto sized = std::ranges::find(sized_effects, pair.effect->name, &SizedEffect::effect);
  const auto said = std::ranges::find(gap.differences, pair.effect->name, &gap::EffectDifference::effect);
  if (sized == sized_effects.end() || said == gap.differences.end()) return;
  const auto parameter =
      std::ranges::find(said->parameters, sized->parameter, &gap::ParameterDifference::name);
  if (parameter == said->parameters.end()) return;
  const auto check = [&](const std::optional<gap::Known>& known, double size, const char* where) {
    if (!known || size == 0.0) return;
    const double value = sized->parameter_per_size * size;
    const bool holds = holds_size(*known, value);
    count.add(holds);
    if (!holds)
      std::cerr << "  outside, in the " << where << ": " << value << " is not in [" << known->interval.lower
                << ", " << known->interval.upper << "]\n";
  };
  check(parameter->simulation, truth.simulation, "simulator");
  check(parameter->robot, truth.robot, "robot");
}

void try_pair(const Pair& pair, Tally& tally) {
  const bool in_both = pair.kind == DifferenceKind::wrong_size || pair.kind == DifferenceKind::same;
  const bool in_simulation = in_both || pair.kind == DifferenceKind::surplus;
  const bool in_robot = in_both || pair.kind == DifferenceKind::missing;
  const auto size = pair.kind == DifferenceKind::wrong_size ? test::Severity::small : test::Severity::large;
  const auto simulated = runs_of(pair, in_simulation, size);
  const auto real = answering_later(runs_of(pair, in_robot, test::Severity::large), pair.later_periods);
  const auto gap =
      gap::analyse_simulation_gap(simulated, real, {}, gap::serial_for, [](const std::string&, double) {});
  std::cerr << pair.effect->name << " " << gap::kind_name(pair.kind) << " later by " << pair.later_periods
            << " seed " << pair.seed << ": " << (gap ? gap->robot.summary : gap.error().reason) << "\n";
  tally.right[pair.kind].add(gap && says(*gap, pair));
  const double robot_size = pair.effect->size(test::Severity::large);
  if (gap && says(*gap, pair)) {
    check_sizes(*gap, pair, {in_simulation ? pair.effect->size(size) : 0.0, in_robot ? robot_size : 0.0},
                tally.size);
  }
  tally.extra.add(gap && says_another(*gap, pair));
  const auto delay = !gap ? 0.0 : [&] {
    for (const auto& change : gap->robot.linear_changes)
      if (change.what == "delay") return change.value;
    return 0.0;
  }();
  constexpr double period_s = 0.018;
  const double truth_s = period_s * static_cast<double>(pair.later_periods);
  (pair.later_periods > 0 ? tally.delay : tally.no_delay).add(std::abs(delay - truth_s) < 0.5 * period_s);
}

void print(const std::string& what, const Count& count) {
  std::cout << "  " << std::left << std::setw(44) << what << count.hits << " of " << count.all << "\n";
}

}  // namespace
}  // namespace wheelwright

int main(int argc, char** argv) {
  using namespace wheelwright;
  CLI::App app{"Counts how often gap --simulation says rightly how a simulator and a robot differ"};
  std::uint64_t seed = 1;
  int pairs = 40;
  app.add_option("--seed", seed, "Of the pairs")->capture_default_str();
  app.add_option("--pairs", pairs, "Simulators and robots")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::mt19937_64 random(seed);
  Tally tally;
  for (int i = 0; i < pairs; ++i) try_pair(random_pair(random), tally);
  std::cout << "said rightly\n";
  for (const auto& [kind, count] : tally.right) print(std::string(gap::kind_name(kind)), count);
  print("95 % interval of a size, holds the truth", tally.size);
  print("a longer delay, to half a period", tally.delay);
  print("no other delay where there is none", tally.no_delay);
  std::cout << "said wrongly\n";
  print("another effect is said to differ", tally.extra);
  return 0;
}
