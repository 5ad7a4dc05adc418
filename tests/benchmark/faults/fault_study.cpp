// Prints how well the hybrid filter finds and names faults, keeps them out of the pose, and notices another
// floor: over simulated faults of varied size and kind, and over hours of clean driving.
//
// With `--circle`, robots and models are those of folders that `wheelwright circle` has filled: what the
// filter makes of a model with effects, or of a robot whose effects were not found.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "config/load/model_file.hpp"
#include "config/load/simulation_config.hpp"
#include "tests/support/fault_scenario.hpp"

using namespace wheelwright;

namespace {

struct StudyOptions {
  int faults_per_kind = 30;
  double clean_hours = 12.0;
  std::uint64_t first_seed = 9000;
  std::vector<std::string> circles;
  bool verbose = false;
};

struct Subject {
  std::string robot;
  std::string room;
  RobotModel model;
  simulation::SimulationConfig on_endless_floor;
};

// One of those that ship, which calibrates itself in a room.
Subject calibrated(const std::string& robot, const std::string& room, std::uint64_t seed) {
  return {robot, room, test::calibrated_model(robot, room, seed), test::robot_on_endless_floor(robot, seed)};
}

// The sealed robot of a circle, with the model that drove it at last.
Subject of_circle(const std::filesystem::path& folder, std::uint64_t seed) {
  auto robot = config::load_simulation_config(folder / "sealed" / "robot.yaml");
  robot.room.walls.clear();
  robot.room.obstacles.clear();
  robot.seed = seed;
  return {folder.filename(), "its room", config::load_model(folder / "driven.yaml"), robot};
}

double mean_of(const std::vector<double>& values) {
  return values.empty()
             ? 0.0
             : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

struct Tally {
  int count = 0;
  int harmful = 0;
  int harmful_found = 0;
  int found = 0;
  int right = 0;
  std::vector<double> delay_s;
  std::vector<double> hybrid_m;
  std::vector<double> odometry_m;
  std::vector<double> left_m;  // of the harm
  std::vector<double> harm_m;
  std::map<FaultKind, int> names;
};

void add(Tally& tally, const test::FaultOutcome& outcome) {
  const bool harmful = outcome.harm_m > 0.02;
  ++tally.count;
  tally.found += outcome.found ? 1 : 0;
  tally.harmful += harmful ? 1 : 0;
  tally.harmful_found += harmful && outcome.found ? 1 : 0;
  tally.right += outcome.found && outcome.named == test::right_name(outcome.plan.what) ? 1 : 0;
  if (outcome.found) {
    tally.delay_s.push_back(outcome.delay_s);
    ++tally.names[outcome.named];
  }
  tally.hybrid_m.push_back(outcome.hybrid_error_m);
  tally.left_m.push_back(outcome.hybrid_left_m);
  tally.harm_m.push_back(outcome.harm_m);
  tally.odometry_m.push_back(outcome.odometry_error_m);
}

void print(const char* name, const Tally& tally) {
  std::printf("%-19s %4d %4d %6d/%-4d %6.2f %6.2f %5d/%-4d %7.3f %7.3f %6.3f %6.3f %7.3f %7.3f  ", name,
              tally.count, tally.found, tally.harmful_found, tally.harmful, quantile(tally.delay_s, 0.5),
              quantile(tally.delay_s, 0.95), tally.right, tally.found, mean_of(tally.hybrid_m),
              mean_of(tally.odometry_m), quantile(tally.hybrid_m, 0.5), quantile(tally.odometry_m, 0.5),
              mean_of(tally.left_m), mean_of(tally.harm_m));
  for (const auto& [kind, count] : tally.names) {
    std::printf(" %s:%d", std::string(name_of(kind)).c_str(), count);
  }
  std::printf("\n");
}

Subject subject_for(const StudyOptions& options, int number, std::uint64_t seed) {
  if (options.circles.empty()) return calibrated("default", "box", seed);
  return of_circle(options.circles[static_cast<std::size_t>(number) % options.circles.size()], seed);
}

void print_fault(const test::FaultOutcome& outcome, std::uint64_t seed) {
  const auto& plan = outcome.plan;
  std::printf(
      "  %s seed %llu: %s, harm %.3f m, share %.4f, counts %d, %.2f s to %.2f s, named %s, "
      "hybrid %.3f odometry %.3f sound %.3f\n",
      outcome.found ? "found" : "MISSED", static_cast<unsigned long long>(seed), test::name_of(plan.what),
      outcome.harm_m, plan.share, plan.counts, 0.018 * plan.onset, 0.018 * plan.end,
      std::string(name_of(outcome.named)).c_str(), outcome.hybrid_error_m, outcome.odometry_error_m,
      outcome.sound_error_m);
}

void study_faults(const StudyOptions& options) {
  std::printf(
      "'seen of > 2 cm': found, of those that move odometry's (stall and lift: the robot's) final pose by "
      "more.\n'delay': to the first alarm, median and 95 %%. 'named': rightly, of the found. Final position "
      "errors in m\nafter 42 s: against the truth (mean, median; hybrid and odometry), and what the fault "
      "alone did to both (mean).\n\n");
  std::printf("%-19s %4s %4s %11s %13s %10s %15s %13s %15s   named as\n", "fault", "n", "seen", "of > 2 cm",
              "delay s", "named", "mean hyb, odo", "median", "by the fault");
  Tally all;
  Tally encoder_faults;
  int false_alarms = 0;
  int false_recalibrations = 0;
  double sound_m = 0.0;
  for (int kind = 0; kind < test::injection_count; ++kind) {
    const auto what = static_cast<test::Injection>(kind);
    Tally tally;
    for (int i = 0; i < options.faults_per_kind; ++i) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(100 * kind + i);
      const Subject subject = subject_for(options, i, seed);
      const auto plan = test::random_fault(what, seed);
      const auto outcome = test::run_fault(subject.model, subject.on_endless_floor, plan, seed + 5000);
      add(tally, outcome);
      add(all, outcome);
      if (what != test::Injection::lift && what != test::Injection::stall) add(encoder_faults, outcome);
      false_alarms += outcome.false_alarms;
      false_recalibrations += outcome.false_recalibrations;
      sound_m += outcome.sound_error_m;
      if ((!outcome.found && outcome.harm_m > 0.02) || options.verbose) print_fault(outcome, seed);
    }
    print(test::name_of(what), tally);
  }
  print("encoder faults", encoder_faults);
  print("all", all);
  std::printf(
      "odometry without faults (stream faults only): %.3f m; false alarms before the faults: %d; "
      "recalibrations called for: %d\n",
      sound_m / all.count, false_alarms, false_recalibrations);
}

struct CleanTally {
  int alarms = 0;
  int recalibrations = 0;
  int discarded = 0;
  double driven_h = 0.0;
};

void drive_clean(const Subject& subject, std::uint64_t seed, double duration_s, CleanTally& tally) {
  const auto drive = test::record_drive(subject.on_endless_floor, seed + 7, duration_s);
  HybridFilter filter(subject.model);
  for (const SensorFrame& frame : drive.frames) {
    const HybridOutput out = filter.step(frame);
    tally.recalibrations += out.raised_recalibration ? 1 : 0;
    tally.discarded += (out.left.discarded ? 1 : 0) + (out.right.discarded ? 1 : 0);
    tally.driven_h += frame.armed ? 0.018 / 3600.0 : 0.0;
    for (const FaultEvent& event : out.events) {
      if (event.stage == FaultEvent::Stage::began) ++tally.alarms;
      if (event.stage == FaultEvent::Stage::ended) continue;
      std::printf("  alarm: %s %s seed %llu tick %lld: %s, size %.4f\n", subject.robot.c_str(),
                  subject.room.c_str(), static_cast<unsigned long long>(seed),
                  static_cast<long long>(event.tick), std::string(name_of(event.kind)).c_str(), event.size);
    }
  }
}

using MakeSubject = std::function<Subject(std::uint64_t seed)>;

std::vector<MakeSubject> clean_subjects(const StudyOptions& options) {
  std::vector<MakeSubject> all;
  for (const auto& folder : options.circles)
    all.emplace_back([folder](std::uint64_t seed) { return of_circle(folder, seed); });
  if (!all.empty()) return all;
  const std::vector<std::pair<std::string, std::string>> homes{
      {"default", "box"}, {"default", "furniture"}, {"default", "corner"},    {"default", "box_without_slip"},
      {"perfect", "box"}, {"create2", "box"},       {"default", "furniture"}, {"default", "box"}};
  for (const auto& [robot, room] : homes)
    all.emplace_back([=](std::uint64_t seed) { return calibrated(robot, room, seed); });
  return all;
}

void study_clean(const StudyOptions& options) {
  std::printf("\nclean driving: alarms, calls for recalibration, discarded readings\n");
  const std::vector<MakeSubject> subjects = clean_subjects(options);
  const double each_s = 3600.0 * options.clean_hours / static_cast<double>(subjects.size());
  int alarms = 0;
  double driven_h = 0.0;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    CleanTally tally;
    std::string name;
    for (double done_s = 0.0; done_s < each_s; done_s += 900.0) {
      const auto seed = options.first_seed + 2000 + i + 100 * static_cast<std::uint64_t>(done_s / 900.0);
      const Subject subject = subjects[i](seed);
      name = subject.robot + ", calibrated in " + subject.room;
      drive_clean(subject, seed, std::min(900.0, each_s), tally);
    }
    std::printf("  %-40s %5.2f h: %d alarms, %d recalibrations, %d readings discarded\n", name.c_str(),
                tally.driven_h, tally.alarms, tally.recalibrations, tally.discarded);
    alarms += tally.alarms;
    driven_h += tally.driven_h;
  }
  std::printf("  %.2f h: %d false alarms, %.2f in 10 hours\n", driven_h, alarms, 10.0 * alarms / driven_h);
}

struct Floor {
  const char* name;
  simulation::Surface surface;
};

void study_floors(const StudyOptions& options) {
  const std::vector<Floor> floors{
      {"same floor", {.grip = 0.7, .creep_per_n = 0.001}},
      {"thin carpet", {.grip = 0.6, .creep_per_n = 0.003, .rolling_drag = 0.015, .scrub_factor = 3.0}},
      {"deep carpet", {.grip = 0.55, .creep_per_n = 0.006, .rolling_drag = 0.03, .scrub_factor = 8.0}},
      {"heavy drag", {.grip = 0.7, .creep_per_n = 0.001, .rolling_drag = 0.06}},
      {"polished", {.grip = 0.2, .creep_per_n = 0.001}}};
  std::printf(
      "\nanother floor after 45 s: called for within 5 s, within 20 s, median delay; alarms of faults\n");
  for (const Floor& floor : floors) {
    int in_time = 0;
    int late = 0;
    int early = 0;
    int alarms = 0;
    std::vector<double> delay_s;
    for (int i = 0; i < options.faults_per_kind; ++i) {
      const std::uint64_t seed = options.first_seed + 4000 + static_cast<std::uint64_t>(i);
      const Subject subject = subject_for(options, i, seed);
      constexpr int change = 2500;
      const auto hook = [&](simulation::SimulatedRobot& robot, int tick) {
        if (tick != change) return;
        robot.inject({.kind = simulation::Fault::Kind::change_floor, .surface = floor.surface});
      };
      const auto drive = test::record_drive(subject.on_endless_floor, seed, 70.0, hook);
      HybridFilter filter(subject.model);
      double driven_s = 0.0;
      for (std::size_t k = 0; k < drive.frames.size(); ++k) {
        const HybridOutput out = filter.step(drive.frames[k]);
        for (const FaultEvent& event : out.events) {
          alarms += event.stage == FaultEvent::Stage::began ? 1 : 0;
        }
        if (k >= change && std::abs(out.left.speed_m_s) + std::abs(out.right.speed_m_s) > 0.04) {
          driven_s += 0.018;
        }
        if (!out.raised_recalibration) continue;
        early += k < change ? 1 : 0;
        if (k >= change) {
          in_time += driven_s <= 5.0 ? 1 : 0;
          late += driven_s > 5.0 && driven_s <= 20.0 ? 1 : 0;
          delay_s.push_back(driven_s);
        }
      }
    }
    std::printf("  %-12s %d/%d, %d/%d, %.1f s; before the change %d; fault alarms %d\n", floor.name, in_time,
                options.faults_per_kind, in_time + late, options.faults_per_kind, quantile(delay_s, 0.5),
                early, alarms);
  }
}

}  // namespace

int main(int argc, char** argv) {
  StudyOptions options;
  CLI::App app{"How well the hybrid filter finds and names faults, and leaves sound readings alone"};
  app.add_option("--faults", options.faults_per_kind, "Of each kind; as many drives for each floor")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--clean-hours", options.clean_hours, "Of driving without a fault")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", options.first_seed, "First of those used")->capture_default_str();
  app.add_option("--circle", options.circles,
                 "Folders of wheelwright circle: their robots, and the models that drove them")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--verbose", options.verbose, "Prints each fault, not only the missed ones");
  CLI11_PARSE(app, argc, argv);
  if (options.faults_per_kind > 0) {
    study_faults(options);
    study_floors(options);
  }
  if (options.clean_hours > 0.0) study_clean(options);
  return 0;
}
