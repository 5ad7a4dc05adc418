// Writes the cases of the second plant, in folders that do not tell, with the answers sealed as gap_cases
// does.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "tests/benchmark/second_plant/case_list.hpp"
#include "tests/benchmark/second_plant/comparison.hpp"
#include "tests/benchmark/second_plant/run.hpp"

namespace {

using second_plant::Case;
using second_plant::Random;
using second_plant::Run;

constexpr int runs_of_a_case = 5;

struct Options {
  std::filesystem::path output = ".";
  std::uint64_t seed = 1;
  std::string matching = ".*";
  bool compare = false;
};

std::vector<Run> drive(const Case& item, const second_plant::RobotSpec& robot) {
  const Random random(item.seed);
  const second_plant::ProgrammeLimits limits{robot.period_s, item.duration_s, robot.fastest_m_s,
                                             robot.body.nominal_track_m, 1.2};
  std::vector<Run> runs;
  for (int index = 0; index < runs_of_a_case; ++index) {
    const Random stream = random.child(static_cast<std::uint64_t>(index));
    const auto programme = second_plant::random_programme(item.style, limits, stream.child(0));
    runs.push_back(second_plant::drive_run(robot, item.sensors, programme, index, item.keep_heading, stream));
  }
  return runs;
}

std::string expected(const Case& item) {
  if (item.kind == "clean") return "nothing_missing";
  if (item.kind == "outside") return "unnamed";
  return item.kind == "cannot_tell" ? "not_named" : "named";
}

// As the first plant calls its cases: by what is hidden.
std::string hidden_in(const Case& item) {
  if (item.kind == "clean") return item.kind;
  if (item.kind == "outside") {
    const std::size_t from = item.name.find(item.kind);
    const std::size_t to = item.name.find('.', from + item.kind.size() + 1);
    std::string name = item.name.substr(from, to - from);
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
  }
  std::string names;
  for (const std::string& effect : item.hidden) names += (names.empty() ? "" : "+") + effect;
  return names;
}

// As gap_score reads it.
nlohmann::json answer_of(const Case& item) {
  nlohmann::json hidden = nlohmann::json::array();
  for (const std::string& effect : item.hidden) {
    hidden.push_back({{"effect", effect},
                      {"can_be_told", item.kind != "cannot_tell"},
                      {"confusable", ""},
                      {"how", item.note}});
  }
  if (item.kind == "outside") {
    hidden.push_back(
        {{"effect", hidden_in(item)}, {"can_be_told", true}, {"confusable", ""}, {"how", item.note}});
  }
  return {{"case", hidden_in(item)},
          {"severity", item.size.empty() ? "none" : item.size},
          {"channels", item.sensor_label},
          {"program", item.kind == "cannot_tell" ? item.kind : "mixed"},
          {"seed", item.seed},
          {"expected", expected(item)},
          {"hidden", hidden}};
}

void write_case(const Options& options, const Case& item, const std::filesystem::path& folder) {
  const std::vector<Run> runs = drive(item, item.robot);
  std::filesystem::create_directories(folder);
  for (std::size_t index = 0; index < runs.size(); ++index)
    write_drive_log(folder / ("run" + std::to_string(index + 1) + ".csv"), runs[index].log, item.sensors);
  if (!options.compare) return;
  const auto difference = compare(runs, drive(item, item.innocent), item.sensors);
  std::fputs(comparison_line(item.name, difference).c_str(), stderr);
}

void write_all(const Options& options) {
  nlohmann::json sealed = nlohmann::json::array();
  std::filesystem::create_directories(options.output);
  if (options.compare) std::fputs(second_plant::comparison_header().c_str(), stderr);
  const std::regex matching(options.matching);
  const auto cases = second_plant::make_cases(options.seed);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!std::regex_search(cases[i].name, matching)) continue;
    std::string number = std::to_string(i + 1);
    number.insert(0, 3 - std::min<std::size_t>(3, number.size()), '0');
    const std::string folder = "case_" + number;
    write_case(options, cases[i], options.output / folder);
    sealed.push_back(answer_of(cases[i]));
    sealed.back()["folder"] = folder;
    std::printf("%s\n", folder.c_str());
  }
  if (sealed.empty()) {
    throw std::invalid_argument("--matching '" + options.matching + "' matches no case, as in '" +
                                cases.front().name + "'");
  }
  std::ofstream(options.output / "sealed_answers.json") << sealed.dump(2) << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Writes drive logs of a second robot in which effects are hidden.", "second_plant"};
  app.add_option("--seed", options.seed, "Robots, drives and noise")->capture_default_str();
  app.add_option("--matching", options.matching, "Cases whose name matches, as coulomb.*ticks");
  app.add_flag(
      "--compare", options.compare,
      "Also say, for each case, how far it is from the same robot without what is hidden: raw, what a "
      "linear model of the last second of commands cannot take up, and the sensors' noise");
  app.add_option("-o,--output", options.output, "Folder for the folders of the cases")->capture_default_str();
  try {
    app.parse(argc, argv);
    write_all(options);
    return 0;
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "second_plant: %s\n", error.what());
    return 2;
  }
}
