#include "tests/benchmark/plants/exam.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "tests/benchmark/plants/comparison.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants {

namespace {

struct Options {
  std::filesystem::path output = ".";
  std::uint64_t seed = 1;
  std::string matching = ".*";
  bool compare = false;
};

// As gap_score knows them.
std::string expected(CaseKind kind) {
  switch (kind) {
    case CaseKind::clean:
      return "nothing_missing";
    case CaseKind::cannot_tell:
      return "not_named";
    case CaseKind::outside:
      return "unnamed";
    case CaseKind::effects:
      break;
  }
  return "named";
}

// As the first plant calls its cases: by what is hidden.
std::string hidden_in(const ExamCase& item) {
  if (item.kind == CaseKind::clean) return "clean";
  std::string names;
  for (const HiddenEffect& effect : item.hidden) names += (names.empty() ? "" : "+") + effect.name;
  return names;
}

// As gap_score reads it.
nlohmann::json answer_of(const ExamCase& item) {
  const bool can_be_distinguished = item.kind != CaseKind::cannot_tell;
  nlohmann::json hidden = nlohmann::json::array();
  for (const HiddenEffect& effect : item.hidden) {
    hidden.push_back({{"effect", effect.name},
                      {"can_be_told", can_be_distinguished},
                      {"confusable", effect.confusable},
                      {"how", effect.how}});
  }
  return {{"case", hidden_in(item)},
          {"severity", item.size.empty() ? "none" : item.size},
          {"channels", label(item.sensing)},
          {"program", can_be_distinguished ? item.programme : "cannot_tell"},
          {"seed", item.seed},
          {"expected", expected(item.kind)},
          {"hidden", hidden}};
}

void write_case(const Options& options, const ExamCase& item, const std::filesystem::path& folder) {
  const std::vector<Run> runs = item.drive();
  std::filesystem::create_directories(folder);
  for (std::size_t index = 0; index < runs.size(); ++index)
    write_drive_log(folder / ("run" + std::to_string(index + 1) + ".csv"), runs[index].log, item.sensors);
  if (!options.compare) return;
  const Comparison difference = compare(runs, item.drive_innocent(runs), item.sensors);
  std::fputs(comparison_line(item.name, difference).c_str(), stderr);
}

void write_all(const Options& options, const std::vector<ExamCase>& cases) {
  nlohmann::json sealed = nlohmann::json::array();
  std::filesystem::create_directories(options.output);
  if (options.compare) std::fputs(comparison_header().c_str(), stderr);
  const std::regex matching(options.matching);
  for (std::size_t index = 0; index < cases.size(); ++index) {
    if (!std::regex_search(cases[index].name, matching)) continue;
    const std::string folder = "case_" + three_digits(index + 1);
    write_case(options, cases[index], options.output / folder);
    sealed.push_back(answer_of(cases[index]));
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

std::string case_name(std::uint64_t seed, std::size_t index, const std::string& subject,
                      const std::string& size, Sensing sensing) {
  std::string name = "s" + std::to_string(seed) + "." + three_digits(index) + "." + subject;
  if (!size.empty()) name += "." + size;
  return name + "." + label(sensing);
}

int run_exam(const Exam& exam, int argc, char** argv) {
  Options options;
  CLI::App app{exam.description, exam.program};
  app.add_option("--seed", options.seed, "Robots, drives and noise")->capture_default_str();
  app.add_option("--matching", options.matching, "Cases whose name matches, as coulomb.*ticks");
  app.add_flag(
      "--compare", options.compare,
      "Also say, for each case, how far it is from the same robot without what is hidden: raw, what a "
      "linear model of the last second of commands cannot take up, and the sensors' noise");
  app.add_option("-o,--output", options.output, "Folder for the folders of the cases")->capture_default_str();
  try {
    app.parse(argc, argv);
    write_all(options, exam.make_cases(options.seed));
    return 0;
  } catch (const CLI::Success& wanted) {
    return app.exit(wanted);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", exam.program, error.what());
    return 2;
  }
}

}  // namespace plants
