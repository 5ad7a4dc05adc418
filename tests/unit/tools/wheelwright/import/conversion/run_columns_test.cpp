// Columns whose value tells runs apart.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> run_settings{"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"};

// Three parts of a drive whose clock and counters go on, each with a label before its rows.
std::string labelled(const std::string& name, const std::vector<std::string>& labels) {
  const ForeignDrive drive = foreign_drive();
  std::string text = name + ",t,cmd_left,cmd_right,enc_left,enc_right\n";
  for (std::size_t k = 0; k < drive.rows.size(); ++k) {
    const ForeignRow& row = drive.rows[k];
    text += labels[labels.size() * k / drive.rows.size()] + "," + number(row.t_s) + "," +
            number(row.command_left) + "," + number(row.command_right) + "," + counts(row) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("A column of a run, session or trial tells runs apart, by numbers and by texts") {
  for (const auto& [name, labels] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"run", {"1", "2", "3"}}, {"trial", {"a", "b", "c"}}, {"SessionId", {"9", "7", "8"}}}) {
    INFO(name);
    const auto outcome = import_text(labelled(name, labels), run_settings);
    REQUIRE(outcome.conversion);
    REQUIRE(outcome.conversion->runs.size() == 3);
    CHECK(outcome.conversion->runs[2].samples.size() == 400);
    CHECK(outcome.conversion->runs[2].samples.front().t_s == 0.0);
    CHECK(outcome.remarks("column '" + name + "' tells 3 runs apart"));
  }
}

TEST_CASE("A value that comes back and a flag that is set once tell no runs apart") {
  for (const auto& [name, labels] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"run", {"1", "2", "1"}}, {"run", {"0", "1"}}, {"mode", {"1", "2", "3"}}}) {
    INFO(name);
    const auto outcome = import_text(labelled(name, labels), run_settings);
    REQUIRE(outcome.conversion);
    CHECK(outcome.conversion->runs.size() == 1);
  }
}
