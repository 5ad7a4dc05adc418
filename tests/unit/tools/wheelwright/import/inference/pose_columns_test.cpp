// Poses in columns without names: their order, and the sides that they show.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

using Fields = std::function<std::string(const ForeignRow&)>;

std::string motion(const ForeignRow& row) {
  return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
         counts(row) + ",";
}

ImportOutcome import_rows(const ForeignDrive& drive, const Fields& fields) {
  return import_text(foreign_text(drive, "", fields), {"robot.wheel_base_m=0.3"});
}

void check_reference(const ImportOutcome& outcome, const ForeignDrive& drive) {
  check_same(outcome, drive);
  const DriveLog& log = outcome.conversion->runs.front();
  double worst_m = 0.0;
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    REQUIRE(log.samples[k].reference_x_m);
    REQUIRE(log.samples[k].reference_theta_rad);
    worst_m = std::max(worst_m, std::abs(*log.samples[k].reference_x_m - drive.rows[k].x));
    worst_m = std::max(worst_m, std::abs(*log.samples[k].reference_y_m - drive.rows[k].y));
    worst_rad = std::max(
        worst_rad,
        std::abs(std::remainder(*log.samples[k].reference_theta_rad - drive.rows[k].theta, 6.283185307)));
  }
  CHECK(worst_m < 1e-3);
  CHECK(worst_rad < 1e-3);
}

}  // namespace

TEST_CASE("Columns of x, y and a heading that goes on or stays within one turn are the reference") {
  const ForeignDrive drive = foreign_drive();
  check_reference(import_rows(drive,
                              [](const ForeignRow& row) {
                                return motion(row) + number(row.x) + "," + number(row.y) + "," +
                                       number(row.theta);
                              }),
                  drive);
  const auto within_a_turn = import_rows(drive, [](const ForeignRow& row) {
    const double degrees = 57.295779513 * std::remainder(row.theta, 6.283185307);
    return motion(row) + number(row.x) + "," + number(row.y) + "," + number(degrees);
  });
  check_reference(within_a_turn, drive);
}

TEST_CASE("Four columns that are a quaternion give the heading, whether the real part is last or first") {
  const ForeignDrive drive = foreign_drive();
  const bool real_first = GENERATE(true, false);
  const auto outcome = import_rows(drive, [real_first](const ForeignRow& row) {
    const std::string real = number(std::cos(0.5 * row.theta));
    const std::string turn = "0,0," + number(std::sin(0.5 * row.theta));
    return motion(row) + number(row.x) + "," + number(row.y) + "," +
           (real_first ? real + "," + turn : turn + "," + real);
  });
  check_reference(outcome, drive);
  CHECK(outcome.found(real_first ? "the quaternion of columns 9, 10, 11 and 8 (x, y, z, w)"
                                 : "the quaternion of columns 8, 9, 10 and 11 (x, y, z, w)"));
}

TEST_CASE("Where y stands before x, the robot would turn against its heading, and they are exchanged") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_rows(drive, [](const ForeignRow& row) {
    return motion(row) + number(row.y) + "," + number(row.x) + "," + number(row.theta);
  });
  check_reference(outcome, drive);
  CHECK(outcome.found("y stands before x"));
}

TEST_CASE(
    "Where the right wheel stands before the left one, a reference shows it, and both options are said") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_rows(drive, [](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.command_right) + "," + number(row.command_left) + "," +
           std::to_string(row.counts_right) + "," + std::to_string(row.counts_left) + "," + number(row.x) +
           "," + number(row.y) + "," + number(row.theta);
  });
  check_reference(outcome, drive);
  CHECK(outcome.found("the right wheel stands first"));
  CHECK(outcome.found("or they are of a frame whose y points right"));
}

TEST_CASE("Files that are read together keep the reference, though each begins elsewhere") {
  const ForeignDrive drive = foreign_drive();
  const auto turned = [](const ForeignRow& row) {
    const double x = 2.0 - 0.6 * row.x - 0.8 * row.y;
    const double y = 1.0 + 0.8 * row.x - 0.6 * row.y;
    return motion(row) + number(x) + "," + number(y) + "," + number(row.theta + 2.214297436);
  };
  const auto as_it_is = [](const ForeignRow& row) {
    return motion(row) + number(row.x) + "," + number(row.y) + "," + number(row.theta);
  };
  const auto one = file_of("one.txt", foreign_text(drive, "", as_it_is));
  const auto other = file_of("other.txt", foreign_text(drive, "", turned));
  const auto understood = import::understand({{one, other}, std::nullopt, import::GivenMapping("", {})});
  REQUIRE(understood);
  REQUIRE(understood->mapping.reference);
  CHECK(understood->mapping.reference->x->channel == "6");
  CHECK(understood->mapping.reference->theta->channel == "8");
}

TEST_CASE("A wheel that counts backwards hides no reference") {
  const ForeignDrive drive = foreign_drive();
  const auto outcome = import_rows(drive, [](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
           std::to_string(row.counts_left) + "," + std::to_string(-row.counts_right) + "," + number(row.x) +
           "," + number(row.y) + "," + number(row.theta);
  });
  REQUIRE(outcome.understood.mapping.reference);
  CHECK(outcome.understood.mapping.wheels->left.channel == "4");
  CHECK(outcome.doubts("--set wheels.reversed=right"));
  CHECK_THAT(*outcome.understood.mapping.wheels->metres_per_count,
             WithinRel(ForeignDrive::metres_per_count, 0.001));
}

TEST_CASE("A number of the row is no time beside a column that rises as a clock does") {
  const ForeignDrive drive = foreign_drive();
  const auto indexed = [](bool first) {
    return [first, k = 0](const ForeignRow& row) mutable {
      const std::string index = std::to_string(k++);
      return (first ? index + "," : "") + motion(row) + number(row.x) + "," + number(row.y) + "," +
             number(row.theta) + (first ? "" : "," + index);
    };
  };
  check_reference(import_rows(drive, indexed(true)), drive);
  check_reference(import_rows(drive, indexed(false)), drive);
}

TEST_CASE("Forward and turning speed without names are told from two wheels by how large they are") {
  const ForeignDrive drive = foreign_drive();
  double left_before = 0.0, right_before = 0.0;
  const auto outcome = import_rows(drive, [&](const ForeignRow& row) {
    const double metres = ForeignDrive::metres_per_count / drive.period_s;
    const double left = metres * (static_cast<double>(row.counts_left) - left_before);
    const double right = metres * (static_cast<double>(row.counts_right) - right_before);
    left_before = static_cast<double>(row.counts_left);
    right_before = static_cast<double>(row.counts_right);
    const double jitter = 1e-4 * std::sin(row.t_s * 1000.0);  // none of the numbers has a step
    return number(row.t_s) + "," + number(row.linear()) + "," + number(row.angular(ForeignDrive::base_m)) +
           "," + number(0.5 * (left + right) + jitter) + "," +
           number((right - left) / ForeignDrive::base_m + jitter);
  });
  REQUIRE(outcome.understood.mapping.command);
  CHECK(outcome.understood.mapping.command->kind == import::CommandKind::twist);
  CHECK(outcome.understood.mapping.wheels->body_motion);
}
