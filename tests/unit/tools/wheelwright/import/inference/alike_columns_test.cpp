// Columns that look like what they are not, and several of which one is right.
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const std::string alike_base = "robot.wheel_base_m=0.3";
const std::string alike_scale = "wheels.metres_per_count=0.0005";

std::string both_commands(const ForeignRow& row) {
  return number(row.command_left) + "," + number(row.command_right);
}

// What a planner asked for: half as much, and too soon.
std::string planned(const ForeignDrive& drive, const ForeignRow& row) {
  const auto k = static_cast<std::size_t>(&row - drive.rows.data());
  const ForeignRow& later = drive.rows[std::min(k + 25, drive.rows.size() - 1)];
  return number(0.5 * later.command_left) + "," + number(0.5 * later.command_right);
}

}  // namespace

TEST_CASE("Of two pairs of commands in a table that one is taken which explains the wheels") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome =
      import_text(foreign_text(drive, "t,cmd_left,cmd_right,ramped_left,ramped_right,enc_left,enc_right",
                               [&](const ForeignRow& row) {
                                 return number(row.t_s) + "," + planned(drive, row) + "," +
                                        both_commands(row) + "," + counts(row);
                               }),
                  {alike_base, alike_scale});
  check_same(outcome, drive);
  CHECK(outcome.found("the commands are ramped_left"));
}

TEST_CASE("A speed and a curvature are a command") {
  constexpr double left_commands[] = {0.0, 0.2, 0.1, 0.15, 0.25, 0.05, 0.18, 0.1, 0.22, 0.12};
  constexpr double right_commands[] = {0.0, 0.2, 0.25, 0.1, 0.12, 0.2, 0.18, 0.15, 0.08, 0.12};
  const ForeignDrive drive = drive_by([&](std::size_t k) { return left_commands[k / 37 % 10]; },
                                      [&](std::size_t k) { return right_commands[k / 37 % 10]; });
  const ImportOutcome outcome =
      import_text(foreign_text(drive, "t,speed,curvature,enc_left,enc_right",
                               [](const ForeignRow& row) {
                                 const double turn = row.angular(ForeignDrive::base_m);
                                 const double speed = row.linear() == 0.0 ? 1e-9 : row.linear();
                                 return number(row.t_s) + "," + std::to_string(row.linear()) + "," +
                                        std::to_string(turn / speed) + "," + counts(row);
                               }),
                  {alike_base, alike_scale});
  REQUIRE(outcome.understood.mapping.command);
  CHECK(outcome.understood.mapping.command->by_curvature);
  check_same(outcome, drive, 2e-3);
}

TEST_CASE("Of four wheels one of each side is taken") {
  const ForeignDrive drive = foreign_drive();
  for (const std::string names : {"t,cmd_l,cmd_r,enc_fl,enc_rl,enc_fr,enc_rr",
                                  "t,cmd_left,cmd_right,front_left_ticks,rear_left_ticks,front_right_ticks,"
                                  "rear_right_ticks"}) {
    CAPTURE(names);
    const auto twice = [](std::int64_t count) {
      return std::to_string(count) + "," + std::to_string(count + 3);
    };
    const ImportOutcome outcome =
        import_text(foreign_text(drive, names,
                                 [&](const ForeignRow& row) {
                                   return number(row.t_s) + "," + both_commands(row) + "," +
                                          twice(row.counts_left) + "," + twice(row.counts_right);
                                 }),
                    {alike_base, alike_scale});
    check_same(outcome, drive);
  }
}

TEST_CASE("Lines of a key and a clock are joined by what their keys say") {
  const ForeignDrive drive = foreign_drive();
  std::string text;
  for (const ForeignRow& row : drive.rows) {
    text += "CMD," + number(row.t_s - 0.004) + "," + both_commands(row) + "\n";
    text += "ENC," + number(row.t_s) + "," + counts(row) + "\n";
    text += "POSE," + number(row.t_s) + "," + number(row.x) + "," + number(row.y) + "," + number(row.theta) +
            "\n";
  }
  const ImportOutcome outcome = import_text(text, {alike_base, alike_scale});
  check_same(outcome, drive);
}

TEST_CASE("Sides alone mean what the names of their files say") {
  const ForeignDrive drive = foreign_drive();
  const auto commanded = foreign_text(drive, "time,left,right", [](const ForeignRow& row) {
    return number(row.t_s) + "," + both_commands(row);
  });
  const auto counted = foreign_text(
      drive, "time,left,right", [](const ForeignRow& row) { return number(row.t_s) + "," + counts(row); });
  const auto understood =
      import::understand({{file_of("commands.csv", commanded), file_of("encoders.csv", counted)},
                          std::nullopt,
                          import::GivenMapping("", {alike_base, alike_scale})});
  if (!understood) FAIL(understood.error());
  check_same({*understood, import::to_runs(*understood)}, drive);
}

TEST_CASE("A file that is given twice is refused") {
  const auto file =
      file_of("once.csv", "t,cmd_left,cmd_right,ticks_left,ticks_right\n0,0,0,0,0\n1,0,0,0,0\n");
  const auto understood =
      import::understand({{file, file}, std::nullopt, import::GivenMapping("", {alike_base})});
  REQUIRE_FALSE(understood);
  CHECK_THAT(understood.error(), ContainsSubstring("is given twice"));
}

TEST_CASE("Increments by name are summed, whatever the clock does") {
  const ForeignDrive drive = foreign_drive();
  for (const std::string names :
       {"t,cmd_left,cmd_right,delta_left,delta_right", "t,cmd_left,cmd_right,dL,dR"}) {
    CAPTURE(names);
    ForeignRow last = drive.rows.front();
    const ImportOutcome outcome = import_text(
        foreign_text(drive, names,
                     [&last](const ForeignRow& row) {
                       const std::string text = number(row.t_s) + "," + both_commands(row) + "," +
                                                std::to_string(row.counts_left - last.counts_left) + "," +
                                                std::to_string(row.counts_right - last.counts_right);
                       last = row;
                       return text;
                     }),
        {alike_base, alike_scale});
    check_same(outcome, drive);
  }
}

TEST_CASE("A number of the loop is no time, and its rate is asked for") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome = import_text(foreign_text(drive, "iter,cmd_left,cmd_right,enc_left,enc_right",
                                                         [&](const ForeignRow& row) {
                                                           return std::to_string(&row - drive.rows.data()) +
                                                                  "," + both_commands(row) + "," +
                                                                  counts(row);
                                                         }),
                                            {alike_base, alike_scale});
  REQUIRE_FALSE(outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("time.rate_hz"));
}

TEST_CASE("A simulator's robot moves by the simulator's time, in minutes too") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome simulated =
      import_text(foreign_text(drive, "wall_time,sim_time,cmd_left,cmd_right,enc_left,enc_right",
                               [](const ForeignRow& row) {
                                 return number(1000.0 + 3.0 * row.t_s) + "," + number(row.t_s) + "," +
                                        both_commands(row) + "," + counts(row);
                               }),
                  {alike_base, alike_scale});
  check_same(simulated, drive);
  const ImportOutcome in_minutes = import_text(
      foreign_text(drive, "Elapsed (min),cmd_left,cmd_right,enc_left,enc_right",
                   [](const ForeignRow& row) {
                     return std::to_string(row.t_s / 60.0) + "," + both_commands(row) + "," + counts(row);
                   }),
      {alike_base, alike_scale});
  check_same(in_minutes, drive);
}

TEST_CASE("Percent and raw numbers are no voltage") {
  const ForeignDrive drive = foreign_drive();
  const auto with_battery = [&](const std::string& battery) {
    return import_text(foreign_text(drive, "t,cmd_left,cmd_right,enc_left,enc_right,battery",
                                    [&](const ForeignRow& row) {
                                      return number(row.t_s) + "," + both_commands(row) + "," + counts(row) +
                                             "," + battery;
                                    }),
                       {alike_base, alike_scale});
  };
  CHECK_FALSE(with_battery("95").understood.mapping.battery);
  CHECK_FALSE(with_battery("782").understood.mapping.battery);
  const ImportOutcome millivolts = with_battery("14250");
  REQUIRE(millivolts.conversion);
  CHECK_THAT(*millivolts.conversion->runs.front().samples.front().battery_v, WithinRel(14.25, 1e-9));
  const ImportOutcome volts = with_battery("12.4");
  CHECK_THAT(*volts.conversion->runs.front().samples.front().battery_v, WithinRel(12.4, 1e-9));
}

TEST_CASE("A unit that is stated is used, and one that is not known is a doubt") {
  const ForeignDrive drive = foreign_drive();
  const auto in_unit = [&](const std::string& unit, double per_m_s) {
    return import_text(
        foreign_text(drive, "t,cmd_left (" + unit + "),cmd_right (" + unit + "),enc_left,enc_right",
                     [&](const ForeignRow& row) {
                       return number(row.t_s) + "," + number(per_m_s * row.command_left) + "," +
                              number(per_m_s * row.command_right) + "," + counts(row);
                     }),
        {alike_base, alike_scale});
  };
  check_same(in_unit("mph", 2.2369363), drive);
  check_same(in_unit("cm/sec", 100.0), drive);
  CHECK(in_unit("km/s", 1.0).doubts("'km/s', which is not known here"));
  CHECK_FALSE(in_unit("m/s", 1.0).doubts("not known here"));
  const ImportOutcome inches = import_text(
      foreign_text(drive, "t,cmd_left,cmd_right,left_position (in),right_position (in)",
                   [](const ForeignRow& row) {
                     constexpr double inches_per_count = ForeignDrive::metres_per_count / 0.0254;
                     return number(row.t_s) + "," + both_commands(row) + "," +
                            number(inches_per_count * static_cast<double>(row.counts_left)) + "," +
                            number(inches_per_count * static_cast<double>(row.counts_right));
                   }),
      {alike_base});
  check_same(inches, drive);
  CHECK_FALSE(inches.doubts("not known here"));
}

TEST_CASE("Commands behind a limiter are taken also where the wheels are found by their motion") {
  const ForeignDrive drive = foreign_drive();
  double left = 0.0, right = 0.0;
  ForeignRow last = drive.rows.front();
  const ImportOutcome outcome = import_text(
      foreign_text(drive, "t,desired_left,desired_right,command_left,command_right,actual_left,actual_right",
                   [&](const ForeignRow& row) {
                     left = static_cast<double>(row.counts_left - last.counts_left) * 0.01;
                     right = static_cast<double>(row.counts_right - last.counts_right) * 0.01;
                     last = row;
                     return number(row.t_s) + "," + planned(drive, row) + "," + both_commands(row) + "," +
                            number(left) + "," + number(right);
                   }),
      {alike_base});
  REQUIRE(outcome.understood.mapping.command);
  CHECK(outcome.understood.mapping.command->first.channel == "command_left");
  CHECK(outcome.understood.mapping.wheels->left.channel == "actual_left");
}

TEST_CASE("A wheel without a counter is left out with its command, and that is said") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome = import_text(foreign_text(drive, "t,cmd_left,cmd_right,ticks_left",
                                                         [](const ForeignRow& row) {
                                                           return number(row.t_s) + "," + both_commands(row) +
                                                                  "," + std::to_string(row.counts_left);
                                                         }),
                                            {alike_base, alike_scale});
  CHECK(outcome.remarks("the right wheel has no counter, and is left out with its command"));
}

TEST_CASE("A count that no counter can hold is none, and the rest of the drive stays") {
  const ForeignDrive drive = foreign_drive();
  const ImportOutcome outcome = import_text(foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right",
                                                         [&](const ForeignRow& row) {
                                                           const bool is_garbage = &row == &drive.rows[600];
                                                           return number(row.t_s) + "," + both_commands(row) +
                                                                  "," +
                                                                  (is_garbage ? "1e25,1e25" : counts(row));
                                                         }),
                                            {alike_base, alike_scale});
  if (!outcome.conversion) FAIL(outcome.conversion.error());
  const DriveLog& log = outcome.conversion->runs.front();
  REQUIRE(log.samples.size() == drive.rows.size());
  CHECK_FALSE(log.samples[600].ticks);
  CHECK(log.samples[601].ticks->left - log.samples[599].ticks->left ==
        drive.rows[601].counts_left - drive.rows[599].counts_left);
}
