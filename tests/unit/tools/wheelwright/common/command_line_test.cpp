#include "tools/wheelwright/common/command_line.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "config/load/drive_log_file.hpp"
#include "config/load/model_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/plant_log.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/wheelwright_command.hpp"
#include "tests/unit/tools/wheelwright/import/import_text.hpp"

using namespace wheelwright;
using test::is_one_line;
using test::Outcome;
using test::plant_run;
using test::wheelwright_command;
using tools::ExitStatus;

namespace {

// A folder that is gone after the test.
class Folder {
 public:
  Folder() : path_(test::temporary_folder() / ("wheelwright_cli_" + std::to_string(std::random_device{}()))) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("A model is fitted from a log, simulated and scored on another") {
  const Folder folder;
  config::save_drive_log(plant_run(1), folder / "train.csv");
  const DriveLog fresh = plant_run(2);
  config::save_drive_log(fresh, folder / "test.csv");

  const Outcome fitted = wheelwright_command({"fit", folder / "train.csv", "-o", folder / "model.yaml"});
  CHECK(fitted.err.empty());
  REQUIRE(fitted.status == ExitStatus::done);
  CHECK_THAT(fitted.out, ContainsSubstring("mm RMS"));
  const RobotModel model = config::load_model(folder / "model.yaml");
  CHECK(model.robot == "plant");
  CHECK(model.source == std::vector<std::string>{folder / "train.csv"});

  REQUIRE(
      wheelwright_command({"simulate", folder / "model.yaml", folder / "test.csv", "-o", folder / "out.csv"})
          .status == ExitStatus::done);
  std::ifstream csv(folder / "out.csv");
  std::string line;
  std::getline(csv, line);
  CHECK(line == "t,speed_left,speed_right,v,w,x,y,theta");
  std::size_t rows = 0;
  while (std::getline(csv, line)) ++rows;
  CHECK(rows == fresh.samples.size());

  const Outcome scored = wheelwright_command({"score", folder / "model.yaml", folder / "test.csv", "--json"});
  REQUIRE(scored.status == ExitStatus::done);
  const auto json = nlohmann::json::parse(scored.out);
  CHECK(json.size() == 2);
  CHECK(json.at("wheel_speed_rms_m_s").get<double>() < 0.02);
  CHECK(json.at("distance_rms_m").get<double>() < 0.003);
  CHECK_THAT(wheelwright_command({"score", folder / "model.yaml", folder / "test.csv"}).out,
             ContainsSubstring("test.csv"));
}

TEST_CASE("An ARMA model is fitted with the table of its orders, and scored") {
  const Folder folder;
  config::save_drive_log(plant_run(1), folder / "train.csv");
  config::save_drive_log(plant_run(2), folder / "test.csv");
  const Outcome fitted = wheelwright_command(
      {"fit", folder / "train.csv", "-o", folder / "model.yaml", "--type", "arma", "--order", "auto"});
  INFO(fitted.err);
  REQUIRE(fitted.status == ExitStatus::done);
  CHECK_THAT(fitted.out, ContainsSubstring("held out [mm]"));
  CHECK_THAT(fitted.out, ContainsSubstring("chosen"));
  const RobotModel model = config::load_model(folder / "model.yaml");
  CHECK(model.linear_part.type == ModelType::arma);
  CHECK(wheelwright_command({"score", folder / "model.yaml", folder / "test.csv"}).status ==
        ExitStatus::done);

  REQUIRE(wheelwright_command({"fit", folder / "train.csv", "-o", folder / "model.yaml", "--type", "arma",
                               "--order", "4", "--delay", "2", "--method", "equation-error"})
              .status == ExitStatus::done);
  const WheelResponse left = config::load_model(folder / "model.yaml").linear_part.left;
  CHECK(left.from_own_past.size() == 4);
  CHECK(left.from_left[1] == 0.0);
  CHECK(left.from_left[2] != 0.0);
}

TEST_CASE("The order of a fit is the number of taps") {
  const Folder folder;
  config::save_drive_log(plant_run(1), folder / "train.csv");
  REQUIRE(wheelwright_command({"fit", folder / "train.csv", "-o", folder / "model.yaml", "--order", "17"})
              .status == ExitStatus::done);
  CHECK(config::load_model(folder / "model.yaml").linear_part.left.from_left.size() == 17);
}

TEST_CASE("Help and version go to standard output with status 0") {
  for (const std::string command : {"fit", "simulate", "score"}) {
    const Outcome help = wheelwright_command({command, "--help"});
    CHECK(help.status == ExitStatus::done);
    CHECK_THAT(help.out, ContainsSubstring("Example: wheelwright " + command));
    CHECK_THAT(wheelwright_command({"--help"}).out, ContainsSubstring(command));
  }
  CHECK_THAT(wheelwright_command({"--version"}).out, ContainsSubstring("wheelwright "));
}

TEST_CASE("Wrong usage is one line on standard error and status 2") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{}, "no command given; use one of: fit"},
      {{"smulate"}, "unknown command 'smulate'; did you mean 'simulate'?"},
      {{"fit"}, "LOG is required"},
      {{"fit", "a.csv"}, "--output is required"},
      {{"fit", "a.csv", "-o", "b", "--odrer", "3"}, "did you mean '--order'?"},
      {{"fit", "a.csv", "-o", "b", "--delay", "2"}, "belong to --type arma"},
      {{"fit", "a.csv", "-o", "b", "--type", "arma", "--order", "3", "--delay", "4"}, "at most the order, 3"},
      {{"fit", "a.csv", "-o", "b", "--type", "arma", "--method", "svd"}, "free-run or equation-error"},
      {{"fit", "a.csv", "-o", "b", "--type", "ar"}, "must be fir or arma"},
      {{"fit", "a.csv", "-o", "b", "--order", "0"}, "a whole number from 1 to 200"},
      {{"fit", "a.csv", "-o", "b", "--order", "-3"}, "--order"},
      {{"fit", "no_such.csv", "-o", "b"}, "no_such.csv: cannot be read"},
      {{"score", "no_such.yaml", "a.csv"}, "no_such.yaml: cannot be read"},
      {{"--fast"}, "'--fast' is not expected here"},
      {{"evaluate", "--calibrate", "twice"}, "--calibrate: is 'twice', but must be each, once or both"},
      {{"export", "a.csv", "--pose", "1"}, "but must be best, model, odometry, hybrid or reference"},
      {{"import", "mrclam", "a", "b", "-o", "c", "--period", "nan"}, "a number from 0.001 to 10 s"},
      {{"gap", "--train", "a", "-o", "b", "--free-radius", "nan"}, "a number from 0.3 to 50 m"},
      {{"status", "/"}, "/: is a folder, but must be a file"},
  };
  for (const auto& [arguments, expected] : wrong) {
    INFO(expected);
    const Outcome outcome = wheelwright_command(arguments);
    CHECK(outcome.status == ExitStatus::bad_input);
    CHECK(outcome.out.empty());
    CHECK(is_one_line(outcome.err));
    CHECK_THAT(outcome.err, ContainsSubstring(expected));
  }
}

TEST_CASE("Data that cannot show the responses give status 1 and no model file") {
  const Folder folder;
  DriveLog log = plant_run(1);
  for (auto& sample : log.samples) sample.command_m_s.right = sample.command_m_s.left;
  config::save_drive_log(log, folder / "straight.csv");
  const Outcome outcome = wheelwright_command({"fit", folder / "straight.csv", "-o", folder / "model.yaml"});
  CHECK(outcome.status == ExitStatus::answer_is_no);
  CHECK(is_one_line(outcome.err));
  CHECK_THAT(outcome.err, ContainsSubstring("add a run that turns"));
  CHECK_FALSE(std::filesystem::exists(folder / "model.yaml"));
}

TEST_CASE("A command that the robot cannot have been given is refused with its line") {
  const Folder folder;
  DriveLog log = plant_run(1);
  log.samples[3].command_m_s.left = 8.224;
  config::save_drive_log(log, folder / "garbage.csv");
  const Outcome outcome = wheelwright_command({"fit", folder / "garbage.csv", "-o", folder / "model.yaml"});
  CHECK(outcome.status == ExitStatus::bad_input);
  CHECK_THAT(outcome.err, ContainsSubstring("garbage.csv:11: a command of 8.224 m/s"));
  CHECK(
      wheelwright_command({"fit", folder / "garbage.csv", "-o", folder / "model.yaml", "--max-command", "9"})
          .status == ExitStatus::done);
  CHECK_THAT(wheelwright_command({"score", folder / "model.yaml", folder / "garbage.csv", "--json"}).err,
             ContainsSubstring("warning"));
}

TEST_CASE("One --set takes several keys, and what follows them is a file again") {
  const Folder folder;
  std::ofstream(folder / "foreign.csv") << test::foreign_text(
      test::foreign_drive(), "time,cmdL,cmdR,encL,encR", [](const test::ForeignRow& row) {
        return test::number(row.t_s) + "," + test::number(row.command_left) + "," +
               test::number(row.command_right) + "," + test::counts(row);
      });
  const Outcome outcome =
      wheelwright_command({"import", "--set", "robot.wheel_base_m=0.3", "wheels.metres_per_count=0.0005",
                           folder / "foreign.csv", "-o", folder / "drive.csv"});
  REQUIRE(outcome.status == ExitStatus::done);
  const DriveLog log = config::load_drive_logs(folder / "drive.csv").front();
  CHECK(log.wheel_base_m == 0.3);
  CHECK(log.metres_per_tick->right == 0.0005);
}

TEST_CASE("No command replaces its own input") {
  const Folder folder;
  config::save_drive_log(plant_run(1), folder / "run.csv");
  const auto size = std::filesystem::file_size(folder / "run.csv");
  CHECK_THAT(wheelwright_command({"fit", folder / "run.csv", "-o", folder / "run.csv"}).err,
             ContainsSubstring("would replace an input"));
  CHECK(std::filesystem::file_size(folder / "run.csv") == size);
}

TEST_CASE("All runs of a file are fitted and scored, but simulate wants one and names the line") {
  const Folder folder;
  config::save_drive_log(plant_run(1), folder / "two.csv");
  std::ifstream second(folder / "two.csv");
  std::string text((std::istreambuf_iterator<char>(second)), std::istreambuf_iterator<char>());
  const std::string rows = text.substr(text.find("\n0.000000,") + 1);
  std::ofstream(folder / "two.csv") << text << rows;
  const Outcome fitted = wheelwright_command({"fit", folder / "two.csv", "-o", folder / "model.yaml"});
  CHECK_THAT(fitted.out, ContainsSubstring("from 2 runs"));
  CHECK_THAT(wheelwright_command({"score", folder / "model.yaml", folder / "two.csv"}).out,
             ContainsSubstring("two.csv:1008"));
  const Outcome refused =
      wheelwright_command({"simulate", folder / "model.yaml", folder / "two.csv", "-o", folder / "o"});
  CHECK(refused.status == ExitStatus::bad_input);
  CHECK_THAT(refused.err, ContainsSubstring("line 1008"));
}

TEST_CASE("A fit as JSON says what the table says, in m/s and m") {
  const Folder folder;
  config::save_drive_log(plant_run(1), folder / "train.csv");
  const std::vector<std::string> fit{"fit", folder / "train.csv", "-o", folder / "model.yaml", "--json"};
  const Outcome fitted = wheelwright_command(fit);
  REQUIRE(fitted.status == ExitStatus::done);
  const auto json = nlohmann::json::parse(fitted.out);
  const RobotModel model = config::load_model(folder / "model.yaml");
  CHECK(json.at("model") == folder / "model.yaml");
  CHECK(json.at("type") == "fir");
  CHECK(json.at("order") == model.linear_part.left.from_left.size());
  CHECK(json.at("left").at("gain_from_left").at("value").get<double>() ==
        Approx(model.left_fit->gain.from_left).margin(1e-4));
  CHECK(json.at("free_run").at("distance_rms_m").get<double>() < 0.003);
  CHECK(json.at("holes").empty());
  CHECK_FALSE(json.at("steady_state_map").contains("steps"));

  auto arma = fit;
  arma.insert(arma.end(), {"--type", "arma"});
  const auto swept = nlohmann::json::parse(wheelwright_command(arma).out);
  CHECK(swept.at("type") == "arma");
  CHECK(swept.at("orders").size() == 15);
  CHECK(swept.at("left").at("largest_pole").get<double>() < 1.0);
}

TEST_CASE("A fit states the steps and the bend of a robot's speeds, and is silent of a linear robot") {
  const Folder folder;
  const auto fit_of = [&](const DriveLog& log) {
    config::save_drive_log(log, folder / "held.csv");
    const Outcome outcome = wheelwright_command({"fit", folder / "held.csv", "-o", folder / "model.yaml"});
    REQUIRE(outcome.status == ExitStatus::done);
    return outcome.out;
  };
  const auto stepped = [](double command) {
    return 0.03 * std::round(command * (1.0 - std::abs(command)) / 0.03);
  };
  const std::string told = fit_of(plant_run(1, 3000, stepped, 30));
  CHECK_THAT(told, ContainsSubstring("the curve from command to speed is concave: gain 0."));
  const std::string linear = fit_of(plant_run(1, 3000, nullptr, 30));
  CHECK_THAT(linear, !ContainsSubstring("curve") && !ContainsSubstring("steps of"));
  const auto in_steps = [](double command) { return 0.03 * std::round(command / 0.03); };
  CHECK_THAT(fit_of(plant_run(1, 3000, in_steps, 30)), ContainsSubstring("speeds go in steps of 30."));
}
