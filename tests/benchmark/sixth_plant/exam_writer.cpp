#include "tests/benchmark/sixth_plant/exam_writer.hpp"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <stdexcept>

#include "tests/benchmark/plants/shuffle.hpp"
#include "tests/benchmark/plants/text.hpp"
#include "tests/benchmark/sixth_plant/case_builder.hpp"
#include "tests/benchmark/sixth_plant/dice.hpp"

namespace plants::sixth {

namespace {

// As gap_score reads it.
nlohmann::json answer_of(const BuiltCase& built) {
  const PlannedCase& plan = built.plan;
  nlohmann::json hidden = nlohmann::json::array();
  for (const SizedEffect& sized : built.hidden) {
    const EffectEntry& entry = entry_of(sized.effect);
    hidden.push_back({{"effect", is_named(sized.effect) ? entry.name : "outside"},
                      {"can_be_told", plan.expected != Expected::not_named},
                      {"confusable", entry.confusable},
                      {"how", sized.how}});
  }
  return {{"case", plan.name},
          {"severity", name_of(plan.size)},
          {"channels", name_of(*plan.channels)},
          {"program", name_of(*plan.programme)},
          {"seed", plan.seed},
          {"expected", name_of(plan.expected)},
          {"hidden", hidden}};
}

void keep_a_pose_each_second(DriveLog& log) {
  constexpr double nearly_a_second_s = 1 - 1e-3;
  double last_s = -9;
  for (LogRow& row : log.rows) {
    if (row.time_s - last_s >= nearly_a_second_s)
      last_s = row.time_s;
    else
      row.reference.reset();
  }
}

void write_runs(const std::filesystem::path& folder, BuiltCase& built) {
  SensorSet sensors;
  sensors.ticks = has_ticks(*built.plan.channels);
  sensors.poses = has_poses(*built.plan.channels);
  sensors.battery = built.battery;
  std::filesystem::create_directories(folder);
  for (std::size_t index = 0; index < built.runs.size(); ++index) {
    DriveLog& log = built.runs[index].log;
    if (built.plan.channels == Channels::ticks_and_poses_each_second) keep_a_pose_each_second(log);
    write_drive_log(folder / ("run" + std::to_string(index + 1) + ".csv"), log, sensors);
  }
}

void report_sizes(const BuiltCase& built) {
  for (const SizedEffect& sized : built.hidden)
    std::fprintf(stderr, "%s.%s %s %s: size %.4g, visibility %.2f, %s\n", built.plan.name.c_str(),
                 name_of(built.plan.size).c_str(), name_of(*built.plan.programme).c_str(),
                 name_of(*built.plan.channels).c_str(), sized.size, sized.visibility, sized.how.c_str());
}

// Folder n holds the case whose index is at place n; the order is that of the seed, whatever is matched.
std::vector<std::size_t> order_of_folders(std::size_t count, std::uint64_t seed) {
  constexpr std::uint64_t order_stream = 7;
  std::vector<std::size_t> folders(count);
  std::iota(folders.begin(), folders.end(), 0U);
  shuffle(folders, warmed_up(mixed_seed(seed, order_stream)));
  std::vector<std::size_t> order(count);
  for (std::size_t index = 0; index < count; ++index) order[folders[index]] = index;
  return order;
}

}  // namespace

void write_exam(const ExamOptions& options) {
  const std::vector<PlannedCase> cases = planned_cases(options.seed);
  const std::vector<std::size_t> order = order_of_folders(cases.size(), options.seed);
  const std::regex matching(options.matching);
  nlohmann::json sealed = nlohmann::json::array();
  for (std::size_t place = 0; place < order.size(); ++place) {
    const PlannedCase& plan = cases[order[place]];
    if (!std::regex_search(plan.name, matching)) continue;
    const std::string folder = "case_" + three_digits(place + 1);
    BuiltCase built = build_case(plan);
    write_runs(options.output / folder, built);
    if (options.verbose) report_sizes(built);
    sealed.push_back(answer_of(built));
    sealed.back()["folder"] = folder;
    std::printf("%s\n", folder.c_str());
    std::fflush(stdout);
  }
  if (sealed.empty()) {
    throw std::invalid_argument("--matching '" + options.matching + "' matches no case, as in '" +
                                cases.front().name + "'");
  }
  std::ofstream stream(options.output / "sealed_answers.json");
  if (!(stream << sealed.dump(2) << "\n")) throw std::runtime_error("cannot write the answers");
}

}  // namespace plants::sixth
