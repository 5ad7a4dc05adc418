// Prints how well the hybrid filter finds and names faults, keeps them out of the pose, and notices another
// floor: over simulated faults of varied size and kind, and over hours of clean driving.
//
//   fault_study [FAULTS_PER_KIND=30] [CLEAN_HOURS=12] [FIRST_SEED=9000]
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "tests/support/fault_scenario.hpp"

using namespace wheelwright;

namespace {

struct Home {
  std::string robot;
  std::string room;
  std::uint64_t seed;
};

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

void study_faults(int per_kind, std::uint64_t first_seed) {
  std::printf(
      "Faults on the default robot. 'seen of > 2 cm': found, of those that move odometry's (stall and lift: "
      "the\n"
      "robot's) final pose by more. 'delay': to the first alarm, median and 95 %%. 'named': rightly, of the "
      "found.\nFinal position errors in m after 42 s: against the truth (mean, median; hybrid and odometry), "
      "and what the\nfault alone did to both (mean).\n\n");
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
    for (int i = 0; i < per_kind; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(100 * kind + i);
      const RobotModel model = test::calibrated_model("default", "box", seed);
      const auto plan = test::random_fault(what, seed);
      const auto outcome =
          test::run_fault(model, test::robot_on_endless_floor("default", seed), plan, seed + 5000);
      add(tally, outcome);
      add(all, outcome);
      if (what != test::Injection::lift && what != test::Injection::stall) add(encoder_faults, outcome);
      false_alarms += outcome.false_alarms;
      false_recalibrations += outcome.false_recalibrations;
      sound_m += outcome.sound_error_m;
      if ((!outcome.found && outcome.harm_m > 0.02) || std::getenv("FAULT_STUDY_VERBOSE")) {
        std::printf(
            "  %s seed %llu: %s, harm %.3f m, share %.4f, counts %d, %.2f s to %.2f s, named %s, "
            "hybrid %.3f odometry %.3f sound %.3f\n",
            outcome.found ? "found" : "MISSED", static_cast<unsigned long long>(seed), test::name_of(what),
            outcome.harm_m, plan.share, plan.counts, 0.018 * plan.onset, 0.018 * plan.end,
            std::string(name_of(outcome.named)).c_str(), outcome.hybrid_error_m, outcome.odometry_error_m,
            outcome.sound_error_m);
      }
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

void study_clean(double hours, std::uint64_t first_seed) {
  const std::vector<Home> homes{{"default", "box", 0},       {"default", "furniture", 1},
                                {"default", "corner", 2},    {"default", "box_without_slip", 3},
                                {"perfect", "box", 4},       {"create2", "box", 5},
                                {"default", "furniture", 6}, {"default", "box", 7}};
  std::printf("\nclean driving: alarms, calls for recalibration, discarded readings\n");
  const double each_s = 3600.0 * hours / static_cast<double>(homes.size());
  int total = 0;
  double total_h = 0.0;
  for (const Home& home : homes) {
    const std::uint64_t seed = first_seed + 2000 + home.seed;
    int alarms = 0;
    int recalibrations = 0;
    int discarded = 0;
    double driven_h = 0.0;
    for (double done_s = 0.0; done_s < each_s; done_s += 900.0) {
      const auto part = seed + 100 * static_cast<std::uint64_t>(done_s / 900.0);
      const RobotModel model = test::calibrated_model(home.robot, home.room, part);
      const auto drive = test::record_drive(test::robot_on_endless_floor(home.robot, part), part + 7,
                                            std::min(900.0, each_s));
      HybridFilter filter(model);
      for (const SensorFrame& frame : drive.frames) {
        const HybridOutput out = filter.step(frame);
        recalibrations += out.raised_recalibration ? 1 : 0;
        discarded += (out.left.discarded ? 1 : 0) + (out.right.discarded ? 1 : 0);
        driven_h += frame.armed ? 0.018 / 3600.0 : 0.0;
        for (const FaultEvent& event : out.events) {
          if (event.stage == FaultEvent::Stage::began) ++alarms;
          if (event.stage != FaultEvent::Stage::ended) {
            std::printf("  alarm: %s %s seed %llu tick %lld: %s, size %.4f\n", home.robot.c_str(),
                        home.room.c_str(), static_cast<unsigned long long>(part),
                        static_cast<long long>(event.tick), std::string(name_of(event.kind)).c_str(),
                        event.size);
          }
        }
      }
    }
    std::printf("  %-10s calibrated in %-17s %5.2f h: %d alarms, %d recalibrations, %d readings discarded\n",
                home.robot.c_str(), home.room.c_str(), driven_h, alarms, recalibrations, discarded);
    total += alarms;
    total_h += driven_h;
  }
  std::printf("  %.2f h: %d false alarms, %.2f in 10 hours\n", total_h, total, 10.0 * total / total_h);
}

struct Floor {
  const char* name;
  simulation::Surface surface;
};

void study_floors(int runs, std::uint64_t first_seed) {
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
    for (int i = 0; i < runs; ++i) {
      const std::uint64_t seed = first_seed + 4000 + static_cast<std::uint64_t>(i);
      const RobotModel model = test::calibrated_model("default", "box", seed);
      constexpr int change = 2500;
      const auto hook = [&](simulation::SimulatedRobot& robot, int tick) {
        if (tick != change) return;
        robot.inject({.kind = simulation::Fault::Kind::change_floor, .surface = floor.surface});
      };
      const auto drive = test::record_drive(test::robot_on_endless_floor("default", seed), seed, 70.0, hook);
      HybridFilter filter(model);
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
                runs, in_time + late, runs, quantile(delay_s, 0.5), early, alarms);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int per_kind = argc > 1 ? std::atoi(argv[1]) : 30;
  const double clean_hours = argc > 2 ? std::atof(argv[2]) : 12.0;
  const auto first_seed = static_cast<std::uint64_t>(argc > 3 ? std::atoll(argv[3]) : 9000);
  study_faults(per_kind, first_seed);
  study_floors(per_kind, first_seed);
  if (clean_hours > 0.0) study_clean(clean_hours, first_seed);
  return 0;
}
