// From the text of a foreign log to runs.
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/tools/wheelwright/import/import_text.hpp"
#include "tools/wheelwright/import/inference/named_reference.hpp"

using namespace wheelwright;
using namespace wheelwright::import;
using namespace wheelwright::test;

namespace {

const std::string base = "robot.wheel_base_m=0.3";

}  // namespace

TEST_CASE("Commands in millimetres, centimetres and metres per second are told apart by the motion") {
  const auto drive = foreign_drive();
  for (const auto& [unit, factor] : {std::pair{"mm/s", 1000.0}, {"cm/s", 100.0}, {"m/s", 1.0}}) {
    INFO(unit);
    const auto text =
        foreign_text(drive, "time,cmdL,cmdR,encL,encR", [&, factor = factor](const ForeignRow& row) {
          return number(row.t_s) + "," + number(factor * row.command_left) + "," +
                 number(factor * row.command_right) + "," + counts(row);
        });
    const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
    check_same(outcome, drive);
    CHECK(outcome.understood.mapping.command->unit == unit);
  }
}

TEST_CASE("A pulse width gets the speed that it leads to, and says so") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "t,pwmL,pwmR,encL,encR", [&](const ForeignRow& row) {
    return number(row.t_s) + "," + std::to_string(std::lround(row.command_left * 600.0)) + "," +
           std::to_string(std::lround(row.command_right * 600.0)) + "," + counts(row);
  });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive, 0.006);
  CHECK(outcome.found("duty of 255"));
}

TEST_CASE("Forward and turning speed become speeds of the wheels") {
  const auto drive = foreign_drive();
  const auto text =
      foreign_text(drive, "t;v_cmd;omega_cmd;ticks_left;ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + ";" + number(row.linear()) + ";" +
               number(row.angular(ForeignDrive::base_m)) + ";" + std::to_string(row.counts_left) + ";" +
               std::to_string(row.counts_right);
      });
  check_same(import_text(text, {base, "wheels.metres_per_count=0.0005"}), drive);
}

TEST_CASE("The distance of a count is found where commands are speeds, and the turns suggest a wheel base") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "t,v_cmd,omega_cmd,encL,encR", [&](const ForeignRow& row) {
    return number(row.t_s) + "," + number(row.linear()) + "," + number(row.angular(ForeignDrive::base_m)) +
           "," + counts(row);
  });
  const auto without = import_text(text);
  REQUIRE_FALSE(without.conversion);
  CHECK_THAT(without.conversion.error(), ContainsSubstring("--set robot.wheel_base_m="));
  CHECK(without.found("wheel base of about 0.3"));
  check_same(import_text(text, {base}), drive, 1e-3, 0.03);
}

TEST_CASE("Time in any unit is seconds since the start") {
  const auto drive = foreign_drive();
  const std::vector<std::pair<const char*, std::function<std::string(double)>>> forms{
      {"milliseconds", [](double t) { return std::to_string(std::lround(1e3 * t)); }},
      {"microseconds", [](double t) { return std::to_string(std::lround(1e6 * t)); }},
      {"seconds since 1970", [](double t) { return std::to_string(1.7e9 + t); }},
      {"nanoseconds since 1970",
       [](double t) { return std::to_string(1'700'000'000'000'000'000LL + std::llround(1e9 * t)); }},
      {"milliseconds since 1970",
       [](double t) { return std::to_string(1'700'000'000'000LL + std::llround(1e3 * t)); }},
  };
  for (const auto& [name, form] : forms) {
    INFO(name);
    const auto text = foreign_text(drive, "stamp,cmd_left,cmd_right,ticks_left,ticks_right",
                                   [&, form = form](const ForeignRow& row) {
                                     return form(row.t_s) + "," + number(row.command_left) + "," +
                                            number(row.command_right) + "," + counts(row);
                                   });
    check_same(import_text(text, {base, "wheels.metres_per_count=0.0005"}), drive);
  }
}

TEST_CASE("Columns without names are found by what explains the motion") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(drive, "", [&](const ForeignRow& row) {
    return std::to_string(row.counts_left) + "," + std::to_string(row.counts_right) + "," +
           number(row.command_left) + "," + number(row.command_right) + "," + number(row.t_s) + "," +
           number(row.x) + "," + number(row.y) + "," + number(row.theta);
  });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive);
  CHECK(outcome.understood.mapping.time.column->channel == "5");
  REQUIRE(outcome.understood.mapping.reference);
  CHECK(outcome.understood.mapping.reference->x->channel == "6");
  CHECK(outcome.understood.mapping.reference->theta->channel == "8");
}

TEST_CASE("Wheel angles and wheel speeds stand for counts") {
  const auto drive = foreign_drive();
  const auto angles =
      foreign_text(drive, "t,cmd_left,cmd_right,angle_left,angle_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               number(static_cast<double>(row.counts_left) * 0.0005 / 0.04) + "," +
               number(static_cast<double>(row.counts_right) * 0.0005 / 0.04);
      });
  check_same(import_text(angles, {base, "wheels.wheel_radius_m=0.04"}), drive);
  check_same(import_text(angles, {base}), drive, 1e-3, 0.03);
  const auto& rows = drive.rows;
  std::size_t k = 0;
  const auto speeds =
      foreign_text(drive, "t,cmd_left,cmd_right,vel_left,vel_right", [&](const ForeignRow& row) {
        const auto& before = rows[k == 0 ? 0 : k - 1];
        ++k;
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               number(static_cast<double>(row.counts_left - before.counts_left) * 0.0005 / 0.05) + "," +
               number(static_cast<double>(row.counts_right - before.counts_right) * 0.0005 / 0.05);
      });
  check_same(import_text(speeds, {base}), drive);
}

TEST_CASE("A reference in degrees and millimetres is converted, and its unit is said") {
  const auto drive = foreign_drive();
  const auto text =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right,mocap_x,mocap_y,mocap_yaw",
                   [&](const ForeignRow& row) {
                     return number(row.t_s) + "," + number(row.command_left) + "," +
                            number(row.command_right) + "," + counts(row) + "," + number(1e3 * row.x) + "," +
                            number(1e3 * row.y) + "," + number(row.theta * 180.0 / 3.14159265358979);
                   });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive);
  CHECK(outcome.understood.mapping.reference->unit == "mm");
  CHECK(outcome.understood.mapping.reference->angle_unit == "deg");
  const auto& sample = outcome.conversion->runs.front().samples[700];
  CHECK_THAT(*sample.reference_x_m, WithinAbs(drive.rows[700].x, 1e-3));
  CHECK_THAT(*sample.reference_theta_rad, WithinAbs(drive.rows[700].theta, 1e-3));
}

TEST_CASE("A wheel that counts backwards and sides that are swapped are said, and not changed in silence") {
  const auto drive = foreign_drive();
  const auto reversed =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               std::to_string(row.counts_left) + "," + std::to_string(-row.counts_right);
      });
  const std::vector<std::string> known{base, "wheels.metres_per_count=0.0005"};
  auto outcome = import_text(reversed, known);
  REQUIRE(outcome.understood.inference.doubts.size() == 1);
  CHECK_THAT(outcome.understood.inference.doubts.front(), ContainsSubstring("right wheel counts backwards"));
  outcome = import_text(reversed, {base, "wheels.metres_per_count=0.0005", "wheels.reversed=right"});
  CHECK(outcome.understood.inference.doubts.empty());
  check_same(outcome, drive);
  const auto swapped =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               std::to_string(row.counts_right) + "," + std::to_string(row.counts_left);
      });
  outcome = import_text(swapped, known);
  REQUIRE(outcome.understood.inference.doubts.size() == 1);
  CHECK_THAT(outcome.understood.inference.doubts.front(), ContainsSubstring("sides are swapped"));
}

TEST_CASE("A clock that is set in mid-drive leaves a hole, and the rest is used") {
  auto drive = foreign_drive();
  for (std::size_t k = 600; k < drive.rows.size(); ++k) drive.rows[k].t_s += 1.7e9;
  const auto text =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005", "time.unit=s"});
  REQUIRE(outcome.conversion);
  REQUIRE(outcome.conversion->runs.size() == 1);
  const auto& samples = outcome.conversion->runs.front().samples;
  REQUIRE(samples.size() == 1200);
  CHECK_THAT(samples[600].t_s - samples[599].t_s, WithinAbs(10.0, 1e-5));
  CHECK_THAT(samples.back().t_s - samples[600].t_s, WithinAbs(599 * 0.05, 1e-5));
}

TEST_CASE("A file without commands says what is missing, with the option") {
  const auto text = foreign_text(foreign_drive(), "t,ticks_left,ticks_right",
                                 [&](const ForeignRow& row) { return number(row.t_s) + "," + counts(row); });
  const auto outcome = import_text(text, {base});
  REQUIRE_FALSE(outcome.conversion);
  CHECK_THAT(outcome.conversion.error(),
             ContainsSubstring(
                 "no commands were found; how far a wheel rolls for a count is not known; give --set"));
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("--set command.left="));
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("are command.linear and command.angular"));
}

TEST_CASE("Commands too fast for metres per second are asked for their unit, which gives the counts theirs") {
  const auto drive = foreign_drive();
  const auto text =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + std::to_string(std::lround(1000.0 * row.command_left)) + "," +
               std::to_string(std::lround(1000.0 * row.command_right)) + "," + counts(row);
      });
  const auto refused = import_text(text, {base});
  REQUIRE_FALSE(refused.conversion);
  CHECK_THAT(refused.conversion.error(), ContainsSubstring("--set wheels.metres_per_count="));
  CHECK_THAT(refused.conversion.error(), ContainsSubstring("--set command.unit=mm/s"));
  check_same(import_text(text, {base, "command.unit=mm/s"}), drive, 0.01);
}

TEST_CASE("Commands too fast for metres per second are asked for their unit beside wheel angles, too") {
  constexpr double radius_m = 0.036;
  const auto angle = [](std::int64_t ticks) {
    return number(static_cast<double>(ticks) * ForeignDrive::metres_per_count / radius_m);
  };
  const auto text = foreign_text(
      foreign_drive(), "t,cmd_left,cmd_right,left_angle_rad,right_angle_rad", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + std::to_string(std::lround(1000.0 * row.command_left)) + "," +
               std::to_string(std::lround(1000.0 * row.command_right)) + "," + angle(row.counts_left) + "," +
               angle(row.counts_right);
      });
  const auto refused = import_text(text, {base});
  REQUIRE_FALSE(refused.conversion);
  CHECK_THAT(refused.conversion.error(), ContainsSubstring("--set command.unit=mm/s"));
  const auto outcome = import_text(text, {base, "command.unit=mm/s"});
  REQUIRE(outcome.conversion);
  CHECK_THAT(*outcome.understood.mapping.wheels->wheel_radius_m, WithinRel(radius_m, 0.02));
}

TEST_CASE("Two files at different rates make one run with the rows of the wheels") {
  const auto drive = foreign_drive();
  std::string commands = "t,cmd_left,cmd_right\n";
  for (std::size_t k = 0; k < drive.rows.size(); k += 37) {
    const auto& row = drive.rows[k];
    commands += number(row.t_s - (k == 0 ? 0.0 : 0.004)) + "," + number(row.command_left) + "," +
                number(row.command_right) + "\n";
  }
  const auto wheels = foreign_text(drive, "t,ticks_left,ticks_right", [&](const ForeignRow& row) {
    return number(row.t_s) + "," + counts(row);
  });
  const auto understood = understand({{file_of("commands.csv", commands), file_of("wheels.csv", wheels)},
                                      std::nullopt,
                                      GivenMapping("", {base, "wheels.metres_per_count=0.0005"})});
  REQUIRE(understood);
  check_same({*understood, to_runs(*understood)}, drive);
}

TEST_CASE("The clock of a reference that was recorded elsewhere is found from the motion") {
  const auto drive = foreign_drive();
  const auto log =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  std::string tum;
  for (const auto& row : drive.rows) {
    tum += std::to_string(1.7e9 + 12.3 + row.t_s) + " " + number(row.x) + " " + number(row.y) + " 0 0 0 " +
           number(std::sin(0.5 * row.theta)) + " " + number(std::cos(0.5 * row.theta)) + "\n";
  }
  const auto understood = understand({{file_of("drive.csv", log)},
                                      file_of("mocap.txt", tum),
                                      GivenMapping("", {base, "wheels.metres_per_count=0.0005"})});
  REQUIRE(understood);
  REQUIRE(understood->mapping.reference);
  CHECK_THAT(*understood->mapping.reference->shift_s, WithinAbs(-1.7e9 - 12.3, 0.06));
  const auto conversion = to_runs(*understood);
  REQUIRE(conversion);
  const auto& sample = conversion->runs.front().samples[700];
  REQUIRE(sample.reference_pose());
  CHECK_THAT(sample.reference_pose()->x_m, WithinAbs(drive.rows[700].x, 0.02));
}

TEST_CASE("Units are found in a long table whose robot stands for most of it") {
  auto drive = foreign_drive();
  const auto standing = drive.rows.front();
  std::vector<ForeignRow> rows(110'000, standing);
  rows.insert(rows.end(), drive.rows.begin(), drive.rows.end());
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].t_s = 0.05 * static_cast<double>(k);
  drive.rows = std::move(rows);
  const auto text = foreign_text(drive, "time,cmdL,cmdR,encL,encR", [&](const ForeignRow& row) {
    return number(row.t_s) + "," + number(1e3 * row.command_left) + "," + number(1e3 * row.command_right) +
           "," + counts(row);
  });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive);
  CHECK(outcome.understood.mapping.command->unit == "mm/s");
}

TEST_CASE("The pose that a run of the daemon computed is no measurement of it") {
  const auto drive = foreign_drive();
  const auto with_pose = [&](const std::string& more_names, const std::string& more) {
    return import_text(
        foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right,x,y,theta" + more_names,
                     [&](const ForeignRow& row) {
                       return number(row.t_s) + "," + number(row.command_left) + "," +
                              number(row.command_right) + "," + counts(row) + "," + number(row.x) + "," +
                              number(row.y) + "," + number(row.theta) + more;
                     }),
        {"robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005"});
  };
  CHECK(with_pose("", "").understood.mapping.reference);
  const auto of_a_run = with_pose(",model_version", ",3");
  CHECK_FALSE(of_a_run.understood.mapping.reference);
  CHECK(of_a_run.found("is the run's own pose"));
}

TEST_CASE("Of the poses in a recording of the daemon the measured one is the reference, and no other") {
  const auto stream = [](const std::string& name, const std::string& place) {
    const std::vector<double> moving{0.0, 0.5, 1.0};
    return Stream{name, "", 3, {}, {{place + ".x", "", moving}, {place + ".y", "", moving}}, {}, {}, ""};
  };
  Recording recording{"run.mcap", "MCAP", {}, {}, {}};
  for (const char* name : {"/pose/model", "/pose/odometry", "/pose/hybrid"})
    recording.streams.push_back(stream(name, "pose.position"));
  recording.streams.push_back(stream("/tf", "translation"));
  const auto reference = [&] {
    std::vector<std::string> findings;
    const std::span all(&recording, 1);
    return find_named_reference(all, NamedChannels(all, {}), false, findings);
  };
  CHECK_FALSE(reference());
  recording.streams.push_back(stream("/pose/reference", "pose.position"));
  REQUIRE(reference());
  CHECK(reference()->x->stream == "/pose/reference");
}

TEST_CASE("Commands and places in feet and inches are read by their names") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(
      drive, "t,cmd_left [ft/s],cmd_right [ft/s],encL,encR,x [in],y [in],theta", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left / 0.3048) + "," +
               number(row.command_right / 0.3048) + "," + counts(row) + "," + number(row.x / 0.0254) + "," +
               number(row.y / 0.0254) + "," + number(row.theta);
      });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  check_same(outcome, drive);
  const auto& run = outcome.conversion->runs.front();
  CHECK_THAT(*run.samples.back().reference_x_m, WithinAbs(drive.rows.back().x, 1e-3));
}

TEST_CASE("Places without a unit that go 3.28 times as far as the wheels are feet") {
  const auto drive = foreign_drive();
  const auto text = foreign_text(
      drive, "t,cmd_left,cmd_right,ticks_left,ticks_right,x,y,theta", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row) + "," + number(row.x / 0.3048) + "," + number(row.y / 0.3048) + "," +
               number(row.theta);
      });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  REQUIRE(outcome.conversion);
  CHECK(outcome.found("places are in ft"));
  CHECK_THAT(*outcome.conversion->runs.front().samples.back().reference_x_m,
             WithinAbs(drive.rows.back().x, 1e-3));
}

TEST_CASE("Rows that are not in the order of time are refused, and what to do is said") {
  auto drive = foreign_drive();
  std::mt19937 random(1);
  std::shuffle(drive.rows.begin(), drive.rows.end(), random);
  const auto text =
      foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right", [&](const ForeignRow& row) {
        return number(row.t_s) + "," + number(row.command_left) + "," + number(row.command_right) + "," +
               counts(row);
      });
  const auto outcome = import_text(text, {base, "wheels.metres_per_count=0.0005"});
  REQUIRE_FALSE(outcome.conversion);
  CHECK_THAT(outcome.conversion.error(), ContainsSubstring("not in the order of time; sort the rows"));
}

TEST_CASE("A period that is not that of the rows, and numbers in smaller units than stated, are doubted") {
  const auto drive = foreign_drive();
  const auto with_metadata = [&](const std::string& metadata, const std::vector<std::string>& settings) {
    return import_text(metadata + foreign_text(drive, "t,cmd_left,cmd_right,ticks_left,ticks_right",
                                               [&](const ForeignRow& row) {
                                                 return number(row.t_s) + "," + number(row.command_left) +
                                                        "," + number(row.command_right) + "," + counts(row);
                                               }),
                       settings);
  };
  const std::vector<std::string> known{base, "wheels.metres_per_count=0.0005"};
  CHECK(with_metadata("# period_s: 0.4\n", known).remarks("--set time.period_s=0.0"));
  CHECK(with_metadata("# wheel_base_m: 300\n", {}).doubts("is it in mm?"));
  CHECK(with_metadata("# period_s: 50\n", known).doubts("is it in ms?"));
  CHECK(with_metadata("# metres_per_tick_left: wide\n", {base}).doubts("wide is not from"));
  CHECK_FALSE(with_metadata("# period_s: 0.02\n", known).remarks("though the period"));
}
