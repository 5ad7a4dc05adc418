// What a program reads of a command: --json is one JSON value on standard output, and nothing else.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/logged_run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/wheelwright_command.hpp"
#include "tools/wheelwright/circle/circle_report.hpp"

using namespace wheelwright;
using tools::ExitStatus;

namespace {

namespace fs = std::filesystem;

struct Answer {
  ExitStatus status;
  nlohmann::json json;
  std::string err;
};

Answer answer(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const auto outcome = test::wheelwright_command(arguments);
  INFO(outcome.out << outcome.err);
  return {outcome.status, nlohmann::json::parse(outcome.out.empty() ? "null" : outcome.out), outcome.err};
}

fs::path empty_folder(const std::string& name) {
  const auto folder = test::temporary_folder() / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

// A drive of two seconds, straight ahead at 0.1 m/s, and a model that does as it is told.
fs::path straight_drive() {
  const auto folder = empty_folder("wheelwright_json_straight");
  std::ofstream log(folder / "drive_log.csv");
  log << "# wheelwright_drive_log: 1\n# wheel_base_m: 0.258\n# period_s: 0.018\nt,cmd_left,cmd_right\n"
         "0,0.1,0.1\n2,0.1,0.1\n";
  std::ofstream(folder / "model.yaml") << "wheelwright_model: 1\nwheel_base_m: 0.258\nperiod_s: 0.018\n"
                                          "core:\n  type: fir\n"
                                          "  left: {from_left: [1], from_right: [0]}\n"
                                          "  right: {from_left: [0], from_right: [1]}\n";
  return folder;
}

// The folder of a run that calibrated and drove, as the daemon leaves it.
const fs::path& driven_run() {
  static const fs::path folder = [] {
    const auto made = empty_folder("wheelwright_json_run");
    const auto config = test::short_configuration();
    test::write_logs(test::run_of(config, 1), config, made);
    return made;
  }();
  return folder;
}

}  // namespace

TEST_CASE("Simulate tells a program how long the drive was and where it ends") {
  const auto folder = straight_drive();
  const auto output = (folder / "predicted.csv").string();
  const Answer told = answer(
      {"simulate", (folder / "model.yaml").string(), (folder / "drive_log.csv").string(), "-o", output});
  INFO(told.err);
  REQUIRE(told.status == ExitStatus::done);
  CHECK(told.json.at("rows") == 2);
  CHECK(told.json.at("duration_s") == 2.0);
  CHECK_THAT(told.json.at("end").at("x_m").get<double>(), WithinAbs(0.2, 0.002));
  CHECK(told.json.at("end").at("theta_rad") == 0.0);
  CHECK(told.json.at("output") == output);
  CHECK(fs::exists(output));
}

TEST_CASE("Import tells a program what was joined and what was left out") {
  const auto folder = empty_folder("wheelwright_json_import");
  std::ofstream(folder / "odometry.dat") << "10.0 0.1 0\n11.0 0.1 0\n12.0 0 0\n";
  std::ofstream(folder / "truth.dat") << "9.0 0 0 0\n10.5 1 2 3\n13.0 1 2 3\n14.0 1 2 3\n";
  const Answer told = answer({"import", "mrclam", (folder / "odometry.dat").string(),
                              (folder / "truth.dat").string(), "-o", (folder / "log.csv").string()});
  REQUIRE(told.status == ExitStatus::done);
  CHECK(told.json.at("commands") == 3);
  CHECK(told.json.at("duration_s") == 2.0);
  CHECK(told.json.at("reference_poses") == 1);
  CHECK(told.json.at("left_out").at("poses_before_first_command") == 1);
  CHECK(told.json.at("left_out").at("poses_after_last_command") == 2);
}

TEST_CASE("Export and report tell a program which files they wrote") {
  const auto folder = straight_drive();
  const auto csv = (folder / "plain.csv").string();
  const Answer exported = answer({"export", folder.string(), "--csv", csv});
  REQUIRE(exported.status == ExitStatus::done);
  REQUIRE(exported.json.at("wrote").size() == 1);
  CHECK(exported.json["wrote"][0] ==
        nlohmann::json{{"format", "csv"}, {"file", csv}, {"bytes", fs::file_size(csv)}});

  const Answer reported = answer({"report", folder.string()});
  REQUIRE(reported.status == ExitStatus::done);
  const std::string page = reported.json.at("wrote");
  CHECK(page == (folder / "report.html").string());
  CHECK(reported.json.at("bytes") == fs::file_size(page));
}

TEST_CASE("Replay takes the folder of a run, and tells a program that nothing differs") {
  const Answer told = answer({"replay", driven_run().string()});
  INFO(told.err);
  REQUIRE(told.status == ExitStatus::done);
  CHECK(told.json.at("ticks").get<std::size_t>() > 1000);
  CHECK(told.json.at("first_different_command_tick").is_null());
  CHECK(told.json.at("same_pose_log") == true);
  CHECK(told.json == answer({"replay", (driven_run() / "drive_log.csv").string()}).json);
}

TEST_CASE("Replay tells a program of a pose log that differs, and ends with status 1") {
  const auto folder = empty_folder("wheelwright_json_altered");
  fs::copy(driven_run(), folder);
  std::ofstream(folder / "pose_log.csv", std::ios::app) << "0,0,0\n";
  const Answer told = answer({"replay", folder.string()});
  CHECK(told.status == ExitStatus::answer_is_no);
  CHECK(told.json.at("same_pose_log") == false);
  CHECK(told.json.at("first_different_command_tick").is_null());
  CHECK_THAT(told.err, ContainsSubstring("differs from the replay"));
}

TEST_CASE("Replay refuses a folder without a drive log, and to write over what it compares with") {
  const Answer none = answer({"replay", empty_folder("wheelwright_json_none").string()});
  CHECK(none.status == ExitStatus::bad_input);
  CHECK_THAT(none.err, ContainsSubstring("holds no drive_log.csv; name the folder of a run"));
  const auto pose_log = (driven_run() / "pose_log.csv").string();
  const Answer over = answer({"replay", driven_run().string(), "-o", pose_log});
  CHECK(over.status == ExitStatus::bad_input);
  CHECK_THAT(over.err, ContainsSubstring("would replace an input"));
}

TEST_CASE("The circle tells a program what was hidden, what was named, and both offsets") {
  tools::CircleReport report;
  report.sealed_file = "out/sealed/robot.yaml";
  report.hidden = {{"play", {"backlash"}}, {"friction", {"coulomb_friction", "stiction"}}};
  report.verdict = "named";
  report.named = {"stiction", "saturation"};
  report.before.offsets_m = {0.2, 0.4};
  report.after.failure = "stopped: bump";
  const nlohmann::json json = nlohmann::json::parse(tools::circle_json(report).dump());
  CHECK_THAT(json.at("before").at("mean_offset_m").get<double>(), WithinAbs(0.3, 1e-12));
  CHECK(json.at("before").at("failure").is_null());
  CHECK(json.at("after").at("mean_offset_m").is_null());
  CHECK(json.at("after").at("offsets_m").empty());
  CHECK(json.at("after").at("failure") == "stopped: bump");
  CHECK(json.at("named") == nlohmann::json{"stiction", "saturation"});
  CHECK(json.at("hidden").at(1).at("effects").size() == 2);
  CHECK(json.at("named_rightly") == 1);
  CHECK(json.at("named_falsely") == 1);
}
