// Logs of one step of one motor, without names.
#include <cmath>
#include <sstream>

#include "tests/unit/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::vector<std::string> known{"wheels.unit=deg/s", "wheels.wheel_radius_m=0.03"};

struct StepLog {
  std::string command = "40";
  bool has_travel = true;
  double settling = 0.1;  // s
};

// 800 deg/s are reached.
std::string step_text(const StepLog& log) {
  std::ostringstream text;
  double angle = 0.0;
  for (int k = 0; k < 150; ++k) {
    const double t = 0.0067 * k;
    const double speed = 800.0 * (1.0 - std::exp(-t / log.settling));
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

TEST_CASE("A step that does not settle gives its wheel, and asks for the full scale") {
  const auto outcome = import_text(step_text({.settling = 0.6}), known);
  REQUIRE_FALSE(outcome.conversion);
  CHECK(outcome.understood.mapping.wheels);
  CHECK_THAT(outcome.conversion.error(), Catch::Matchers::EndsWith("give --set command.full_scale_m_s=0.5"));
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
