#include "config/load/daemon_config.hpp"

#include <filesystem>
#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using config::load_daemon_config;

namespace {

std::filesystem::path written(const std::string& text) {
  auto path = test::temporary_folder() / "wheelwright_daemon_config_test.yaml";
  std::ofstream(path) << text;
  return path;
}

std::string error_of(const std::string& text) {
  const auto path = written(text);
  try {
    load_daemon_config(path);
  } catch (const config::ConfigError& error) {
    return std::string(error.what()).substr(path.parent_path().string().size() + 1);
  }
  return "no error";
}

}  // namespace

TEST_CASE("The shipped configuration holds every key at its default") {
  const auto shipped = load_daemon_config(std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/wheelwright.yaml");
  const auto empty = load_daemon_config(written("{}\n"));
  CHECK(shipped.link.period_s == empty.link.period_s);
  CHECK(shipped.link.blind_limit_s == empty.link.blind_limit_s);
  CHECK(shipped.device == empty.device);
  CHECK(shipped.limits.wheel_base_m == empty.limits.wheel_base_m);
  CHECK(shipped.limits.slowest_wheel_speed_m_s == empty.limits.slowest_wheel_speed_m_s);
  CHECK(shipped.limits.acceleration_m_s2 == empty.limits.acceleration_m_s2);
  CHECK(shipped.response.on_s == empty.response.on_s);
  CHECK(shipped.response.repetitions == empty.response.repetitions);
  CHECK(shipped.encoder_turn.turns_each_way == empty.encoder_turn.turns_each_way);
  CHECK(shipped.encoder_turn.options.largest_standard_error ==
        empty.encoder_turn.options.largest_standard_error);
  CHECK(shipped.real_time.priority == empty.real_time.priority);
  CHECK(shipped.calibration_type == empty.calibration_type);
  CHECK(shipped.adapt == empty.adapt);
  CHECK(shipped.mcap_log == empty.mcap_log);
  CHECK(shipped.random_drive.duration_s == empty.random_drive.duration_s);
  CHECK(shipped.random_drive.spread_m_s == empty.random_drive.spread_m_s);
  CHECK(shipped.random_drive.shortest_hold_s == empty.random_drive.shortest_hold_s);
  CHECK(shipped.random_drive.longest_hold_s == empty.random_drive.longest_hold_s);
  CHECK(shipped.random_drive.largest_change_m_s == empty.random_drive.largest_change_m_s);
  CHECK(shipped.random_drive.radius_m == empty.random_drive.radius_m);
  CHECK(shipped.random_drive.ahead_m == empty.random_drive.ahead_m);
  CHECK(shipped.random_drive.tour_share == empty.random_drive.tour_share);
  CHECK(shipped.random_drive.seed == empty.random_drive.seed);
  CHECK(shipped.random_drive.order == empty.random_drive.order);
  REQUIRE(shipped.route);
  CHECK(is_closed(*shipped.route));
}

TEST_CASE("A key that is misspelt, of the wrong type, unit or range is refused with its place") {
  CHECK(error_of("link:\n  device: /dev/x\n  perod_s: 0.018\n") ==
        "wheelwright_daemon_config_test.yaml:3:3: unknown key 'perod_s'; did you mean 'period_s'?");
  CHECK_THAT(error_of("link:\n  period_s: 18\n"), ContainsSubstring("0.005 to 0.2 s"));
  CHECK_THAT(error_of("link:\n  mode: fast\n"), ContainsSubstring("one of: safe, full"));
  CHECK_THAT(error_of("real_time:\n  priority: 50.5\n"), ContainsSubstring("whole number"));
  CHECK_THAT(error_of("run:\n  route: nowhere.yaml\n"), ContainsSubstring("which is no file"));
  CHECK_THAT(error_of("limit:\n  largest_speed_m_s: 0.3\n"), ContainsSubstring("did you mean 'limits'?"));
}

TEST_CASE("An order of the model is a number or auto, and only type arma can do without response actions") {
  CHECK_THAT(error_of("calibration: {random_drive: {order: 16}}\n"),
             ContainsSubstring("auto or a whole number"));
  CHECK_THAT(error_of("calibration: {response: {repetitions: 0}}\n"), ContainsSubstring("type 'arma'"));
  CHECK_THAT(error_of("calibration: {random_drive: {shortest_hold_s: 2}}\n"),
             ContainsSubstring("longest_hold_s"));
}

TEST_CASE("Values that contradict each other are refused") {
  CHECK_THAT(error_of("link:\n  blind_limit_s: 2\n  lost_after_s: 1\n"), ContainsSubstring("blind_limit_s"));
  CHECK_THAT(error_of("limits:\n  largest_speed_m_s: 0.05\n"), ContainsSubstring("calibration speed"));
  CHECK_THAT(error_of("limits:\n  largest_speed_m_s: 0.1\n  slowest_speed_m_s: 0.2\n"),
             ContainsSubstring("not below its largest"));
}

TEST_CASE("What a run keeps of its configuration reads back the same, route included") {
  auto config = load_daemon_config(written(
      "robot: {name: 'a \"quoted\" robot', wheel_base_m: 0.258}\n"
      "link: {transport: stream, drive: pwm, period_s: 0.015625, encoder_order: right_is_43, mode: full}\n"
      "calibration: {when: never, adapt: false, type: arma, response: {repetitions: 0, alternate_direction: "
      "false},\n"
      "  random_drive: {duration_s: 40, radius_m: 0.4, ahead_m: -0.2, tour_share: 0.25, seed: 77, order: "
      "auto}}\n"
      "run:\n  pose_source: odometry\n  largest_uncertainty_m: 0.25\n  at_end: stay\n"
      "  route: {name: there, speed: 0.1, checkpoints: [[0.5, 0.25], [0, 0]]}\n"
      "real_time: {policy: off}\n"));
  const std::string text = config::daemon_config_to_yaml(config);
  const auto back = load_daemon_config(written(text));
  CHECK(config::daemon_config_to_yaml(back) == text);
  CHECK(back.robot_name == "a \"quoted\" robot");
  CHECK(back.link.encoder_order == roomba::EncoderOrder::right_is_43);
  CHECK(back.largest_uncertainty_m == 0.25);
  CHECK(back.limits.command_step_m_s == config.limits.command_step_m_s);
  CHECK_FALSE(back.adapt);
  CHECK(back.random_drive.seed == 77);
  CHECK(back.random_drive.ahead_m == -0.2);
  CHECK(back.random_drive.tour_share == 0.25);
  CHECK_FALSE(back.random_drive.order);
  REQUIRE(back.route);
  CHECK(back.route->checkpoints[0].y_m == 0.25);
}

TEST_CASE("Commands are read from a drive log beside the configuration, and kept in what a run keeps") {
  std::ofstream(test::temporary_folder() / "forth_and_back.csv")
      << "# wheelwright_drive_log: 1\n# wheel_base_m: 0.235\n# period_s: 0.1\nt,cmd_left,cmd_right\n"
         "0,0.2,0.1\n0.1,0.2,0.1\n0.2,-0.2,-0.1\n";
  const auto config = load_daemon_config(written("run: {commands: forth_and_back.csv}\n"));
  REQUIRE(config.commanded_drive);
  CHECK(config.commanded_drive->name == "forth_and_back.csv");
  CHECK(config.commanded_drive->rows.size() == 2);

  const std::string text = config::daemon_config_to_yaml(config);
  const auto back = load_daemon_config(written(text));
  CHECK(config::daemon_config_to_yaml(back) == text);
  REQUIRE(back.commanded_drive);
  CHECK(back.commanded_drive->rows[1].command_m_s.left == -0.2);
  CHECK_THAT(back.commanded_drive->duration_s, WithinAbs(0.3, 1e-9));

  CHECK_THAT(error_of("limits: {largest_speed_m_s: 0.15}\nrun: {commands: forth_and_back.csv}\n"),
             ContainsSubstring("forth_and_back.csv:5: commands 0.2 m/s, more than limits.largest_speed_m_s"));
  CHECK_THAT(error_of("run:\n  commands: forth_and_back.csv\n"
                      "  route: {name: there, checkpoints: [[0.5, 0.25]]}\n"),
             ContainsSubstring("'commands' is given together with a route"));
}

TEST_CASE("Commands in the configuration itself that are no drive are refused") {
  const auto commands = [](const std::string& keys) {
    return error_of("run: {commands: {name: x, duration_s: 1, " + keys + "}}\n");
  };
  CHECK(commands("t_s: [0, 0.5], left_m_s: [0.1, 0], right_m_s: [0.1, 0]") == "no error");
  CHECK_THAT(commands("t_s: [0, 0.5], left_m_s: [0.1], right_m_s: [0.1, 0]"),
             ContainsSubstring("one time for each number"));
  CHECK_THAT(commands("t_s: [0.5, 0], left_m_s: [0.1, 0], right_m_s: [0.1, 0]"),
             ContainsSubstring("must begin at 0 and rise"));
  CHECK_THAT(commands("t_s: [0], left_m_s: [0.4], right_m_s: [0.1]"), ContainsSubstring("left_m_s"));
}

TEST_CASE("The live view listens on this machine alone unless it is given a token") {
  const auto shipped = load_daemon_config(std::string(WHEELWRIGHT_SOURCE_DIR) + "/config/wheelwright.yaml");
  CHECK(shipped.live_view.address == "127.0.0.1");
  CHECK(shipped.live_view.port == config::LiveViewConfig{}.port);
  CHECK(shipped.live_view.token.empty());
  CHECK_THAT(error_of("live_view: {address: 0.0.0.0}\n"),
             ContainsSubstring("needs a token beside it, or 127.0.0.1"));
  CHECK_THAT(error_of("live_view: {address: '::'}\n"), ContainsSubstring("needs a token beside it"));
  CHECK(error_of("live_view: {address: 0.0.0.0, token: 0123456789abcdef}\n") == "no error");
  CHECK(error_of("live_view: {address: '::1'}\n") == "no error");
  CHECK(error_of("live_view: {port: 0, address: 0.0.0.0}\n") == "no error");
}

TEST_CASE("A live view that cannot be is refused with what would be right") {
  CHECK_THAT(error_of("live_view: {address: robot.local}\n"), ContainsSubstring("must be an address"));
  CHECK_THAT(error_of("live_view: {address: 127.evil}\n"), ContainsSubstring("must be an address"));
  CHECK_THAT(error_of("live_view: {token: short}\n"), ContainsSubstring("16 or more letters"));
  CHECK_THAT(error_of("live_view: {token: 'sixteen letters & more'}\n"),
             ContainsSubstring("16 or more letters"));
  CHECK_THAT(error_of("live_view: {port: 70000}\n"), ContainsSubstring("port"));
}

TEST_CASE("What a run keeps of its configuration does not hold the token") {
  const auto config = load_daemon_config(written("live_view: {token: 0123456789abcdef}\n"));
  CHECK(config::daemon_config_to_yaml(config).find("0123456789abcdef") == std::string::npos);
}
