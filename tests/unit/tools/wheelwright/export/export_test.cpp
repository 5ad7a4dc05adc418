#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/common/command_line.hpp"

using namespace wheelwright;
using tools::ExitStatus;

namespace {

struct Outcome {
  ExitStatus status;
  std::string err;
};

Outcome command(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const ExitStatus status = tools::run_command_line(arguments, {out, err});
  return {status, err.str()};
}

std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// The folder of a run with three ticks, one of them in the drive log alone.
std::string run_folder() {
  const auto folder = test::temporary_folder() / "wheelwright_export_test";
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "drive_log.csv") << "# wheelwright_drive_log: 1\n"
                                             "t,cmd_left,cmd_right,ref_x,ref_y,ref_theta,activity\n"
                                             "0,0.1,0.1,1,2,0,encoder_turn\n"
                                             "0.018,0.1,0.1,,,,route\n"
                                             "0.036,0.1,0.1,3,4,3.14159265358979,route\n";
  std::ofstream(folder / "pose_log.csv") << "# wheelwright_pose_log: 1\n"
                                            "# pose_source: odometry\n"
                                            "t,x,y,theta,odometry_x,odometry_y,odometry_theta,activity\n"
                                            "0.018,,,,5,6,0,route\n"
                                            "0.036,7,8,0,7.5,8,0,route\n";
  return folder.string();
}

std::string tum(const std::string& log, const std::vector<std::string>& options) {
  const std::string file = (test::temporary_folder() / "wheelwright_export_test.tum").string();
  std::vector<std::string> arguments{"export", log, "--tum", file};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = command(arguments);
  return outcome.status == ExitStatus::done ? contents(file) : outcome.err;
}

}  // namespace

TEST_CASE("A trajectory has evo's eight columns, and the reference poses where there are any") {
  CHECK(tum(run_folder(), {}) ==
        "0.000000 1.000000 2.000000 0 0 0 0.000000000 1.000000000\n"
        "0.036000 3.000000 4.000000 0 0 0 1.000000000 0.000000000\n");
}

TEST_CASE("A trajectory of a pose log is that of the pose that steers, or of another one by name") {
  const std::string log = run_folder() + "/pose_log.csv";
  CHECK(tum(log, {}).starts_with("0.018000 5.000000 6.000000"));
  CHECK(tum(log, {"--pose", "model"}) == "0.036000 7.000000 8.000000 0 0 0 0.000000000 1.000000000\n");
}

TEST_CASE("A trajectory may be of one activity only") {
  CHECK(tum(run_folder(), {"--during", "route"}).starts_with("0.036000 3.000000"));
  CHECK(tum(run_folder(), {"--during", "rout"}).find("nothing of activity 'rout'") != std::string::npos);
}

TEST_CASE("A pose that the run does not hold is refused by name") {
  CHECK(tum(run_folder(), {"--pose", "hybrid"}).find("holds no hybrid pose") != std::string::npos);
}

TEST_CASE("The plain CSV has its header first and the columns of both logs once") {
  const std::string file = (test::temporary_folder() / "wheelwright_export_test.csv").string();
  CHECK(command({"export", run_folder(), "--csv", file}).status == ExitStatus::done);
  CHECK(contents(file) ==
        "t,cmd_left,cmd_right,ref_x,ref_y,ref_theta,activity,x,y,theta,odometry_x,odometry_y,odometry_theta\n"
        "0,0.1,0.1,1,2,0,encoder_turn,,,,,,\n"
        "0.018,0.1,0.1,,,,route,,,,5,6,0\n"
        "0.036,0.1,0.1,3,4,3.14159265358979,route,7,8,0,7.5,8,0\n");
}

TEST_CASE("Numbers that are none, or beyond any robot, are refused by row") {
  for (const char* garbage : {"nan", "inf", "1e300", "0x10"}) {
    const std::string log = run_folder() + "/garbage.csv";
    std::ofstream(log) << "t,x,y,theta\n0,1,2,3\n1," << garbage << ",2,3\n";
    const Outcome outcome = command({"export", log, "--mcap", log + ".mcap"});
    CHECK(outcome.status == ExitStatus::bad_input);
    CHECK(outcome.err.find("garbage.csv:3: 'x' is '" + std::string(garbage)) != std::string::npos);
  }
}

TEST_CASE("An export says what is wrong with its input") {
  CHECK(command({"export", run_folder()}).err.find("nothing to write; add --mcap") != std::string::npos);
  const std::string log = run_folder() + "/drive_log.csv";
  CHECK(command({"export", log, "--csv", log}).err.find("would replace an input") != std::string::npos);
  std::ofstream(run_folder() + "/bad.csv") << "t,x,y,theta\n0,1,2,3\n1,1,oops,3\n";
  const Outcome bad = command({"export", run_folder() + "/bad.csv", "--mcap", log + ".mcap"});
  CHECK(bad.status == ExitStatus::bad_input);
  CHECK(bad.err.find("bad.csv:3: 'y' is 'oops', but must be a number") != std::string::npos);
}
