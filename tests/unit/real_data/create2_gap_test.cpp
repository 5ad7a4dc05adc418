// The gap workflow on logs of a real Create 2, where they are.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "config/load/drive_log_file.hpp"
#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/create2_logs.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

GapAnalysis gap_between(const std::filesystem::path& folder, const std::vector<std::string>& train,
                        const std::vector<std::string>& test) {
  const auto loaded = [&](const std::vector<std::string>& names) {
    std::vector<DriveLog> logs;
    for (const auto& name : names) logs.push_back(config::load_drive_log(folder / name));
    return logs;
  };
  const auto quietly = [](const std::string&, double) {};
  auto analysis = analyse_gap(loaded(train), loaded(test), {}, serial_for, quietly);
  REQUIRE(analysis);
  return *std::move(analysis);
}

}  // namespace

TEST_CASE("Between two runs of one program on a real Create 2 nothing is missing") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  CHECK(gap_between(*folder, {"run1.csv"}, {"run2.csv"}).verdict == Verdict::nothing_missing);
  CHECK(gap_between(*folder, {"run2.csv"}, {"run1.csv"}).verdict == Verdict::nothing_missing);
}

TEST_CASE("That later runs of a real Create 2 are faster is seen, and no cause is named") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const auto analysis = gap_between(*folder, {"run1.csv", "run2.csv"}, {"run3.csv", "run4.csv"});
  CHECK(analysis.verdict == Verdict::unnamed);
  CHECK(analysis.found.empty());
  CHECK_THAT(analysis.summary, ContainsSubstring("gain changed"));
}

TEST_CASE("Between two later runs of a real Create 2, one wheel is slower and one is faster") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const auto forth = gap_between(*folder, {"run3.csv"}, {"run4.csv"});
  CHECK(forth.verdict == Verdict::unnamed);
  CHECK_THAT(forth.summary, ContainsSubstring("left and"));
  const auto back = gap_between(*folder, {"run4.csv"}, {"run3.csv"});
  CHECK(back.verdict == Verdict::unnamed);
  CHECK_THAT(back.summary, ContainsSubstring("left and"));
}

TEST_CASE("The garbage in a real log is a fault of the data, with its row") {
  const auto folder = test::create2_folder();
  if (!folder) return;
  const auto analysis = gap_between(*folder, {"counter_clockwise.csv"}, {});
  CHECK(analysis.verdict == Verdict::bad_data);
  REQUIRE_FALSE(analysis.data_faults.empty());
  CHECK(analysis.data_faults.front().row == 8);
}
