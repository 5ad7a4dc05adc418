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
// or the load on the motors takes back in part (direction_gain, yaw_bias) is none of them, and neither is the
// dead zone of an output stage, whose soft knee moves it by about a per cent.
struct SizedEffect {
  std::string_view effect;
  std::string_view parameter;
  double parameter_per_size = 1.0;
  std::string_view how = "";  // it is hidden, of several ways; empty: in any
};

constexpr double wheel_base_m = test::PlantParameters{}.wheel_base_m;
constexpr std::array sized_effects{
    SizedEffect{"backlash", "gap"},
    SizedEffect{"command_quantization", "step"},
    SizedEffect{"dead_zone", "threshold", 1.0, "firmware ignores small commands"},
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

test::GapCase robot_of(const Pair& pair, bool hidden, test::Severity severity) {
  test::GapCaseSpec spec;
  spec.name = hidden ? std::string(pair.effect->name) : "clean";
  spec.severity = severity;
  spec.seed = pair.seed;
  spec.runs = 3;
  spec.seconds = 40.0;
  return test::make_gap_case(spec);
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

// The hidden size of a robot if it is the library's parameter.
std::optional<double> parameter_of(const test::GapCase& robot, const SizedEffect& sized) {
  if (robot.hidden.empty()) return std::nullopt;
  const test::HiddenInCase& hidden = robot.hidden.front();
  if (!sized.how.empty() && hidden.how != sized.how) return std::nullopt;
  return sized.parameter_per_size * hidden.size;
}

void check_sizes(const gap::SimulationGap& gap, const Pair& pair, const test::GapCase& simulator,
                 const test::GapCase& robot, Count& count) {
  const auto sized = std::ranges::find(sized_effects, pair.effect->name, &SizedEffect::effect);
  const auto said = std::ranges::find(gap.differences, pair.effect->name, &gap::EffectDifference::effect);
  if (sized == sized_effects.end() || said == gap.differences.end()) return;
  const auto parameter =
      std::ranges::find(said->parameters, sized->parameter, &gap::ParameterDifference::name);
  if (parameter == said->parameters.end()) return;
  const auto check = [&](const std::optional<gap::Known>& known, const std::optional<double>& truth,
                         const char* where) {
    if (!known || !truth) return;
    const bool holds = holds_size(*known, *truth);
    count.add(holds);
    if (!holds)
      std::cerr << "  outside, in the " << where << ": " << *truth << " is not in [" << known->interval.lower
                << ", " << known->interval.upper << "]\n";
  };
  check(parameter->simulation, parameter_of(simulator, *sized), "simulator");
  check(parameter->robot, parameter_of(robot, *sized), "robot");
}

void try_pair(const Pair& pair, Tally& tally) {
  const bool in_both = pair.kind == DifferenceKind::wrong_size || pair.kind == DifferenceKind::same;
  const bool in_simulation = in_both || pair.kind == DifferenceKind::surplus;
  const bool in_robot = in_both || pair.kind == DifferenceKind::missing;
  const auto size = pair.kind == DifferenceKind::wrong_size ? test::Severity::small : test::Severity::large;
  const test::GapCase simulator = robot_of(pair, in_simulation, size);
  const test::GapCase robot = robot_of(pair, in_robot, test::Severity::large);
  const auto real = answering_later(robot.runs, pair.later_periods);
  const auto gap = gap::analyse_simulation_gap(simulator.runs, real, {}, gap::serial_for,
                                               [](const std::string&, double) {});
  const bool right = gap && says(*gap, pair);
  const auto& hidden = robot.hidden.empty() ? simulator.hidden : robot.hidden;
  std::cerr << (right ? "right: " : "wrong: ") << pair.effect->name << " (" << hidden.front().how << ") "
            << gap::kind_name(pair.kind) << " later by " << pair.later_periods << " seed " << pair.seed
            << ": " << (gap ? gap->robot.summary : gap.error().reason) << "\n";
  tally.right[pair.kind].add(right);
  if (right) check_sizes(*gap, pair, simulator, robot, tally.size);
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
  int from = 0;
  app.add_option("--from", from, "The first pair to try, counted from 0")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::mt19937_64 random(seed);
  Tally tally;
  for (int i = 0; i < from + pairs; ++i) {
    const Pair pair = random_pair(random);
    if (i >= from) try_pair(pair, tally);
  }
  std::cout << "said rightly\n";
  for (const auto& [kind, count] : tally.right) print(std::string(gap::kind_name(kind)), count);
  print("95 % interval of a size, holds the truth", tally.size);
  print("a longer delay, to half a period", tally.delay);
  print("no other delay where there is none", tally.no_delay);
  std::cout << "said wrongly\n";
  print("another effect is said to differ", tally.extra);
  return 0;
}
