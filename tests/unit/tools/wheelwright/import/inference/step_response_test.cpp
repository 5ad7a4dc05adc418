// Logs of one step of one motor, without names.
#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tools/wheelwright/import/import_text.hpp"
#include "tools/wheelwright/logs/log_input.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> known{"wheels.unit=deg/s", "wheels.wheel_radius_m=0.03"};

struct StepLog {
  std::string command = "40";
  bool has_travel = true;
  double settling = 0.1;   // s
  double reached = 800.0;  // deg/s
};

std::string step_text(const StepLog& log) {
  std::ostringstream text;
  double angle = 0.0;
  for (int k = 0; k < 150; ++k) {
    const double t = 0.0067 * k;
    const double speed = log.reached * (1.0 - std::exp(-t / log.settling));
    text << log.command << ';' << number(t + 3.0) << ';' << std::lround(speed);
    if (log.has_travel) text << ';' << std::lround(angle - 500.0);
    text << '\n';
    angle += 0.0067 * speed;
  }
  return text.str();
}

}  // namespace

TEST_CASE("One step of a motor gives its speed and, in proportion, the full scale of its duty") {
  for (const bool has_travel : {true, false}) {
    const auto outcome = import_text(step_text({.has_travel = has_travel}), known);
    if (!outcome.conversion) FAIL(outcome.conversion.error());
    CHECK(outcome.understood.mapping.wheels->left.channel == "3");
    CHECK(outcome.understood.mapping.command->first.channel == "1");
    CHECK(outcome.found("is the rate of column 4") == has_travel);
    CHECK(outcome.found("one level shows no dead zone"));
    const double settled_m_s = 800.0 * 3.14159265 / 180.0 * 0.03;
    CHECK_THAT(*outcome.understood.mapping.command->full_scale_m_s,
               WithinRel(settled_m_s * 100.0 / 40.0, 0.02));
    const DriveLog& run = outcome.conversion->runs.front();
    CHECK_THAT(run.samples.back().command_m_s.left, WithinRel(settled_m_s, 0.02));
    CHECK(run.samples.back().ticks->left > 300'000);  // micrometres in a second
  }
}

TEST_CASE("Steps of one motor in a file each have one full scale, so that its dead zone shows") {
  tools::LogInput input;
  input.import.settings = known;
  const auto& folder = test::temporary_folder();
  for (const int duty : {20, 40, 60, 80, 100}) {
    input.paths.push_back((folder / (std::to_string(duty) + ".csv")).string());
    const double reached = 20.0 * (duty - 15);  // nothing up to 15 of 100
    std::ofstream(input.paths.back()) << step_text({.command = std::to_string(duty), .reached = reached});
  }
  std::ostringstream said;
  const std::vector<DriveLog> runs = tools::load_all_runs(input, said);
  REQUIRE(runs.size() == input.paths.size());
  const auto command = [&](std::size_t run) { return runs[run].samples.back().command_m_s.left; };
  const auto travel = [&](std::size_t run) {
    const auto& counts = runs[run].samples.back().ticks;
    return static_cast<double>(counts->left) * runs[run].metres_per_tick->left;
  };
  CHECK_THAT(command(0) / command(4), WithinRel(0.2, 1e-6));
  CHECK_THAT(travel(0) / travel(4), WithinRel(5.0 / 85.0, 0.02));
  CHECK(runs[2].name == input.paths[2]);
}

TEST_CASE("A step that does not settle gives its wheel, and asks for the full scale") {
  const auto outcome = import_text(step_text({.settling = 0.6}), known);
  REQUIRE_FALSE(outcome.conversion);
  CHECK(outcome.understood.mapping.wheels);
  CHECK_THAT(outcome.conversion.error(), Catch::Matchers::EndsWith("give --set command.full_scale_m_s=0.5"));
}

TEST_CASE("What number stands for all of a duty does not depend on whether its speed is given") {
  std::vector<std::string> given = known;
  given.emplace_back("command.full_scale_m_s=0.5");
  for (const double settling : {0.6, 0.1}) {
    const auto outcome = import_text(step_text({.settling = settling}), given);
    if (!outcome.conversion) FAIL(outcome.conversion.error());
    CHECK(outcome.understood.mapping.command->full_scale == 100.0);
    CHECK_THAT(outcome.conversion->runs.front().samples.back().command_m_s.left, WithinRel(0.5 * 0.4, 1e-6));
  }
}

TEST_CASE("A step whose file holds no command, or units, says all that is missing in one line") {
  const auto without = import_text(step_text({.command = "0"}), known);
  REQUIRE_FALSE(without.conversion);
  CHECK(without.understood.mapping.wheels);
  CHECK_THAT(without.conversion.error(),
             Catch::Matchers::EndsWith("no commands were found; give --set command.left=COLUMN"));
  const auto without_units = import_text(step_text({}));
  REQUIRE_FALSE(without_units.conversion);
  CHECK_THAT(without_units.conversion.error(),
             Catch::Matchers::EndsWith(
                 "the unit of the wheel speeds, and the speed that the largest duty leads to are not known; "
                 "give --set wheels.unit=mm/s --set command.full_scale_m_s=0.5"));
}

TEST_CASE("Columns of which none starts at rest are not taken for a step") {
  std::ostringstream text;
  for (int k = 0; k < 150; ++k) text << "40;" << 0.0067 * k << ';' << 700 + (k * 7919) % 13 << '\n';
  const auto outcome = import_text(text.str(), known);
  CHECK_FALSE(outcome.understood.mapping.wheels);
  CHECK_FALSE(outcome.conversion);
}
