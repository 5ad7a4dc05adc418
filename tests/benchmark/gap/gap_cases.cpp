// Writes cases of the gap benchmark: CASE/run1.csv ... and CASE/answer.json; or a whole suite of them, in
// folders that do not tell, with the answers sealed.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "config/load/atomic_file.hpp"
#include "config/load/drive_log_file.hpp"
#include "tests/benchmark/gap/gap_suite.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;

namespace {

struct Options {
  std::vector<std::string> cases;
  std::string severity = "medium";
  std::string channels = "ticks+ref";
  std::string program = "mixed";
  test::GapCaseSpec spec;
  bool no_battery = false;
  std::string output = ".";
  bool list = false;
  std::string suite;
  std::string matching = ".*";
};

nlohmann::json answer_of(const test::GapCase& made) {
  nlohmann::json hidden = nlohmann::json::array();
  for (const auto& one : made.hidden) {
    nlohmann::json entry{
        {"effect", one.effect->name},           {"size", one.size}, {"unit", one.effect->unit},
        {"size_means", one.effect->size_means}, {"how", one.how},   {"can_be_told", !one.why_not},
        {"confusable", one.effect->confusable}};
    if (one.why_not) entry["why_not"] = *one.why_not;
    hidden.push_back(std::move(entry));
  }
  const auto& spec = made.spec;
  return {{"case", spec.name},
          {"severity", spec.name == "clean" ? "none" : name_of(spec.severity)},
          {"channels", name_of(spec.channels)},
          {"program", name_of(spec.program)},
          {"seed", spec.seed},
          {"runs", spec.runs},
          {"seconds", spec.seconds},
          {"period_s", spec.period_s},
          {"battery", spec.battery},
          {"gyro", spec.gyro},
          {"expected", name_of(made.expected)},
          {"hidden", hidden}};
}

nlohmann::json write_runs(const test::GapCaseSpec& spec, const std::filesystem::path& folder) {
  const auto made = test::make_gap_case(spec);
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < made.runs.size(); ++i) {
    config::save_drive_log(made.runs[i], folder / ("run" + std::to_string(i + 1) + ".csv"));
  }
  return answer_of(made);
}

void write_json(const nlohmann::json& json, const std::filesystem::path& path) {
  if (const auto error = config::write_file_atomically(path, json.dump(2) + "\n"))
    throw std::runtime_error(*error);
}

void write_case(const test::GapCaseSpec& spec, const std::filesystem::path& output) {
  const auto folder = output / spec.folder_name();
  const auto answer = write_runs(spec, folder);
  write_json(answer, folder / "answer.json");
  std::printf("%s\n", folder.c_str());
}

// Folders are numbered by place in the whole suite, so that a case keeps its number whatever is left out.
void write_suite(const Options& options) {
  const auto suite = test::gap_suite(options.suite == "quick", options.spec.seed);
  const std::regex matching(options.matching);
  nlohmann::json sealed = nlohmann::json::array();
  for (std::size_t i = 0; i < suite.size(); ++i) {
    if (!std::regex_search(suite[i].folder_name(), matching)) continue;
    std::string number = std::to_string(i + 1);
    number.insert(0, 3 - std::min<std::size_t>(3, number.size()), '0');
    const std::string folder = "case_" + number;
    auto answer = write_runs(suite[i], std::filesystem::path(options.output) / folder);
    answer["folder"] = folder;
    sealed.push_back(std::move(answer));
    std::printf("%s\n", folder.c_str());
  }
  if (sealed.empty()) {
    throw std::invalid_argument("--matching '" + options.matching + "' matches no case, as in '" +
                                suite.front().folder_name() + "'");
  }
  write_json(sealed, std::filesystem::path(options.output) / "sealed_answers.json");
}

void list_cases() {
  std::printf("%-22s %8s %8s %8s  %-13s %s\n", "case", "small", "medium", "large", "unit", "size");
  std::printf("clean\n");
  for (const auto& effect : test::hidden_effects()) {
    std::printf("%-22s %8g %8g %8g  %-13s %s\n", std::string(effect.name).c_str(), effect.sizes[0],
                effect.sizes[1], effect.sizes[2], std::string(effect.unit).c_str(),
                std::string(effect.size_means).c_str());
  }
  std::printf("Several at once: joined by +, as in dead_zone+backlash.\n");
}

template <typename Value>
Value named(std::optional<Value> value, const char* option, const std::string& given, const char* right) {
  if (!value) throw std::invalid_argument(std::string(option) + " is '" + given + "', but must be " + right);
  return *value;
}

int run(Options& options) {
  if (options.list) {
    list_cases();
    return 0;
  }
  auto& spec = options.spec;
  spec.severity =
      named(test::severity_named(options.severity), "--severity", options.severity, "small, medium or large");
  spec.channels = named(test::channels_named(options.channels), "--channels", options.channels,
                        "ticks, ticks+ref, ticks+sparse, ends, ref or sparse");
  spec.program = named(test::program_named(options.program), "--program", options.program,
                       "mixed, forward_only, straight_only or one_speed");
  spec.battery = !options.no_battery;
  if (!options.suite.empty()) {
    write_suite(options);
    return 0;
  }
  for (const auto& name : options.cases) {
    if (!test::effects_of_case(name))
      throw std::invalid_argument("--case '" + name + "' is not known; see --list");
  }
  for (const auto& name : options.cases) {
    spec.name = name;
    write_case(spec, options.output);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Writes logs of a robot with a hidden effect: OUTPUT/CASE/run1.csv ... and answer.json.",
               "gap_cases"};
  app.add_option("--case", options.cases, "clean, an effect, or several joined by +; may be given often");
  app.add_option("--severity", options.severity, "small, medium or large")->capture_default_str();
  app.add_option("--channels", options.channels, "ticks, ticks+ref, ticks+sparse, ends, ref or sparse")
      ->capture_default_str();
  app.add_option("--program", options.program, "mixed, forward_only, straight_only or one_speed")
      ->capture_default_str();
  app.add_option("--seed", options.spec.seed, "Robot, circumstances, commands and noise")
      ->capture_default_str();
  app.add_option("--runs", options.spec.runs)->check(CLI::Range(1, 100))->capture_default_str();
  app.add_option("--seconds", options.spec.seconds, "Length of a run")
      ->check(CLI::Range(2.0, 3600.0))
      ->capture_default_str();
  app.add_option("--period", options.spec.period_s, "In s")
      ->check(CLI::Range(0.005, 0.2))
      ->capture_default_str();
  app.add_flag("--no-battery", options.no_battery, "Leave the battery voltage out");
  app.add_flag("--gyro", options.spec.gyro, "Log a gyro");
  app.add_option("-o,--output", options.output, "Folder for the folders of the cases")->capture_default_str();
  app.add_option("--suite", options.suite, "Write a whole suite, blind, with OUTPUT/sealed_answers.json")
      ->check(CLI::IsMember({"quick", "full"}));
  app.add_option("--matching", options.matching, "Of a suite: cases whose name matches, as coulomb.*ticks");
  app.add_flag("--list", options.list, "Names and sizes, and out");
  try {
    app.parse(argc, argv);
    if (!options.list && options.suite.empty() && options.cases.empty())
      throw std::invalid_argument("no --case or --suite given; see --list");
    return run(options);
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gap_cases: %s\n", error.what());
    return 2;
  }
}
