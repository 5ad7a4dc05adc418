// Judges what the gap workflow answered to the cases of a folder, and prints the tables of the gap benchmark.
//
//   gap_score CASES ANSWERS REPORT.json
//
// CASES holds sealed_answers.json; ANSWERS holds, for each case, CASE/gap.json as the workflow wrote it,
// CASE/status (exit status and seconds), and CASE/errors (what it said). A case without a folder there was
// not run and is left out.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "config/load/atomic_file.hpp"
#include "tests/benchmark/gap/outcome_tables.hpp"

using namespace wheelwright;

namespace {

nlohmann::json json_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return nlohmann::json::parse(stream, nullptr, false);
}

std::string last_line(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

test::CaseOutcome outcome_of(const nlohmann::json& answer, const std::filesystem::path& folder) {
  int status = 2;
  double seconds = 0.0;
  std::ifstream(folder / "status") >> status >> seconds;
  constexpr int bad_input = 2;
  nlohmann::json gap;
  if (status < bad_input) gap = json_of(folder / "gap.json");
  auto outcome = test::judge_case(answer, gap);
  outcome.folder = folder.filename().string();
  outcome.seconds = seconds;
  if (status >= bad_input) {
    outcome.trouble = "exit status " + std::to_string(status) + ": " + last_line(folder / "errors");
  }
  return outcome;
}

int run(const std::filesystem::path& cases, const std::filesystem::path& answers, const std::string& report) {
  const auto sealed = json_of(cases / "sealed_answers.json");
  if (!sealed.is_array())
    throw std::runtime_error((cases / "sealed_answers.json").string() + ": holds no answers");
  std::vector<test::CaseOutcome> outcomes;
  for (const auto& answer : sealed) {
    const auto folder = answers / answer.at("folder").get<std::string>();
    if (std::filesystem::exists(folder / "status")) outcomes.push_back(outcome_of(answer, folder));
  }
  std::fputs(test::outcome_tables(outcomes).c_str(), stdout);
  if (const auto error = config::write_file_atomically(report, test::outcome_json(outcomes).dump(1) + "\n")) {
    throw std::runtime_error(*error);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int expected_arguments = 4;
  if (argc != expected_arguments) {
    std::fprintf(stderr, "gap_score: takes CASES ANSWERS REPORT.json\n");
    return 2;
  }
  try {
    return run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gap_score: %s\n", error.what());
    return 2;
  }
}
