// Whether the gap workflow's intervals and probabilities hold: robots that are the library's own models, with
// one effect of random size or none, drive at random; each is analysed, and what is said is counted against
// the truth.
#include <CLI/CLI.hpp>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/analysis.hpp"
#include "model/gap/fit/trial_model.hpp"
#include "tests/benchmark/gap/calibration/hidden_setting.hpp"

namespace wheelwright::calibration {
namespace {

constexpr std::size_t runs_of_a_robot = 4;

struct Count {
  int hits = 0;
  int all = 0;
  void add(bool hit) {
    hits += hit ? 1 : 0;
    ++all;
  }
};

// Share with its 95 % interval by Wilson's formula (1927).
std::string in_percent(const Count& count) {
  if (count.all == 0) return "-";
  const double n = count.all;
  const double p = count.hits / n;
  constexpr double z = 1.96;
  const double middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n)) / (1.0 + z * z / n);
  std::ostringstream text;
  text << count.hits << " of " << count.all << std::fixed << std::setprecision(1) << "  " << 100.0 * p
       << " % [" << 100.0 * std::max(0.0, middle - half) << ", " << 100.0 * std::min(1.0, middle + half)
       << "]";
  return text.str();
}

struct Tally {
  Count false_names;    // on robots without an effect
  Count failed_checks;  // on the same
  Count named;          // right name first
  Count other_first;    // another one
  Count covered;        // intervals of a right name's parameters that hold the truth
  std::map<std::string, Count> covered_of;
  std::map<int, Count> right_by_posterior;  // tenths
};

RobotModel linear_robot(const DriveProgram& program, double wheel_base_m, Random& random) {
  std::uniform_real_distribution<double> lag_s(0.03, 0.12);
  std::uniform_int_distribution<int> delay(1, 4);
  RobotModel model;
  const auto trial =
      gap::first_guess({}, program.period_s, wheel_base_m, lag_s(random), program.period_s * delay(random));
  model.linear_part = trial.linear();
  return model;
}

// Sine and cosine, whose zero is where the analysis puts it.
bool is_of_a_wheel_angle(const ParameterInfo& parameter) {
  return parameter.name.ends_with("_sine") || parameter.name.ends_with("_cosine");
}

void count_intervals(const gap::Finding& found, const EffectSetting& hidden, const EffectInfo& info,
                     Tally& tally) {
  if (found.setting.variant != hidden.variant) return;
  const auto& parameters = info.parameters_of(0);
  for (std::size_t i = 0; i < parameters.size() && i < found.intervals.size(); ++i) {
    if (is_of_a_wheel_angle(parameters[i])) continue;
    const auto& interval = found.intervals[i];
    const bool covers = interval.lower <= hidden.parameters[i] && hidden.parameters[i] <= interval.upper;
    tally.covered.add(covers);
    tally.covered_of[info.name + "." + parameters[i].name].add(covers);
    std::cerr << (covers ? "  " : "! ") << parameters[i].name << ": true " << hidden.parameters[i]
              << ", found " << found.setting.parameters[i] << " [" << interval.lower << ", " << interval.upper
              << "]\n";
  }
}

void try_robot(const EffectInfo* info, std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const DriveProgram program;
  std::vector<DriveLog> commands;
  for (std::size_t r = 0; r < runs_of_a_robot; ++r)
    commands.push_back(random_commands(program, "run" + std::to_string(r + 1), random));
  RobotModel robot = linear_robot(program, commands.front().wheel_base_m, random);
  EffectSetting hidden;
  if (info != nullptr) {
    hidden = random_setting(*info, robot, commands.front(), random);
    robot.effects.push_back({hidden, {}, {}, {}, {}, {}});
  }
  std::vector<DriveLog> drives;
  drives.reserve(commands.size());
  for (const DriveLog& drive : commands) {
    const WheelPair before_m = drives.empty() ? WheelPair{} : rolled_m(drives.back());
    drives.push_back(measured_drive(robot, drive, {}, before_m, random));
  }
  const auto analysis = gap::analyse_gap(drives, {}, {}, gap::serial_for, [](const std::string&, double) {});
  if (!analysis) throw std::runtime_error(analysis.error().reason);
  if (info == nullptr) {
    tally.false_names.add(!analysis->found.empty());
    tally.failed_checks.add(!analysis->check.passed);
    return;
  }
  const bool any = !analysis->found.empty();
  const bool right = any && analysis->found.front().setting.name == info->name;
  tally.named.add(right);
  tally.other_first.add(any && !right);
  if (any) {
    const int tenths = std::min(9, static_cast<int>(10.0 * analysis->found.front().posterior));
    tally.right_by_posterior[tenths].add(right);
  }
  std::cerr << info->name << " seed " << seed << ": " << gap::verdict_name(analysis->verdict);
  for (const auto& found : analysis->found)
    std::cerr << " " << found.setting.name << "/" << found.setting.variant;
  std::cerr << "\n";
  if (right) count_intervals(analysis->found.front(), hidden, *info, tally);
}

void print(const Tally& tally) {
  std::cout << "names on robots without an effect   " << in_percent(tally.false_names) << "\n"
            << "checks that fail on them            " << in_percent(tally.failed_checks) << "\n"
            << "right name first                    " << in_percent(tally.named) << "\n"
            << "another name first                  " << in_percent(tally.other_first) << "\n"
            << "95 % intervals that hold the truth  " << in_percent(tally.covered) << "\n\n"
            << "of names with a probability of      right\n";
  for (const auto& [tenths, count] : tally.right_by_posterior)
    std::cout << "  0." << tenths << " to " << std::setprecision(1) << std::fixed << 0.1 * (tenths + 1)
              << "                        " << in_percent(count) << "\n";
  std::cout << "\nintervals of each parameter\n";
  for (const auto& [name, count] : tally.covered_of)
    std::cout << "  " << std::left << std::setw(34) << name << in_percent(count) << "\n";
}

}  // namespace
}  // namespace wheelwright::calibration

int main(int argc, char** argv) {
  using namespace wheelwright;
  using namespace wheelwright::calibration;
  CLI::App app{"Counts how often the gap workflow is right on drives of the library's own models"};
  std::uint64_t seed = 1;
  int clean = 20;
  int each = 4;
  std::vector<std::string> only;
  std::optional<std::uint64_t> robot;
  app.add_option("--seed", seed, "Of the first robot")->capture_default_str();
  app.add_option("--clean", clean, "Robots without an effect")->capture_default_str();
  app.add_option("--each", each, "Robots with each effect")->capture_default_str();
  app.add_option("--effects", only, "These alone");
  app.add_option("--robot", robot, "One robot of each effect, with the seed that an earlier call printed");
  CLI11_PARSE(app, argc, argv);
  if (robot) clean = 0;
  Tally tally;
  std::seed_seq sequence{seed};
  std::vector<std::uint32_t> seeds(static_cast<std::size_t>(clean) + 64 * static_cast<std::size_t>(each));
  sequence.generate(seeds.begin(), seeds.end());
  auto next = seeds.begin();
  for (int i = 0; i < clean; ++i) try_robot(nullptr, *next++, tally);
  for (const EffectInfo& info : effect_library()) {
    if (info.variants.front().stage == EffectStage::counts) continue;  // no simulation shows it
    const bool is_asked_for = only.empty() || std::ranges::find(only, info.name) != only.end();
    for (int i = 0; i < (robot ? 1 : each); ++i, ++next) {
      if (is_asked_for) try_robot(&info, robot.value_or(*next), tally);
    }
  }
  print(tally);
  return 0;
}
