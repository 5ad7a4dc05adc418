#include "daemon/telemetry/messages.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "daemon/telemetry/scene.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::daemon;
using namespace wheelwright::daemon::telemetry;
using Json = nlohmann::json;

namespace {

constexpr std::uint64_t noon_ns = 1'700'000'000'123'456'789U;

Route there_and_back() {
  return {"there and back", 0.2, 0.02, {{1.0, 0.0}, {0.0, 0.0}}};
}

// The robot on its route at x, by model and odometry.
LogEntry at_x(double x_m, Activity activity = Activity::route) {
  LogEntry entry;
  entry.frame.valid = entry.record.valid = true;
  entry.frame.command.activity = activity;
  entry.record.has_prediction = true;
  entry.record.predicted = {x_m, 0.0, 0.0};
  entry.record.odometry = {0.9 * x_m, 0.0, 0.0};
  return entry;
}

// What a client holds after updates, as the protocol says: deletions first, entities replace by id.
class Viewer {
 public:
  void take(const std::string& update) {
    const Json json = Json::parse(update);
    for (const Json& deletion : json.at("deletions")) {
      if (deletion.at("type") == 1) entities.clear();
      entities.erase(deletion.at("id").get<std::string>());
    }
    for (const Json& entity : json.at("entities")) entities[entity.at("id")] = entity;
  }
  // The x of all points of a way, in order.
  std::vector<double> way(const std::string& name) const {
    std::map<int, Json> pieces;
    for (const auto& [id, entity] : entities) {
      if (id.starts_with(name + "/")) pieces[std::stoi(id.substr(name.size() + 1))] = entity;
    }
    std::vector<double> x;
    for (const auto& [number, piece] : pieces) {
      for (const Json& point : piece.at("lines")[0].at("points")) x.push_back(point.at("x"));
    }
    return x;
  }
  std::map<std::string, Json> entities;
};

}  // namespace

TEST_CASE("A pose is told in Foxglove's form: time in seconds and nanoseconds, heading as a quaternion") {
  const Json json = Json::parse(pose_message(noon_ns, {1.5, -0.25, M_PI / 2.0}));
  CHECK(json.at("timestamp").at("sec") == 1'700'000'000);
  CHECK(json.at("timestamp").at("nsec") == 123'456'789);
  CHECK(json.at("frame_id") == "route");
  CHECK(json.at("pose").at("position").at("x") == 1.5);
  CHECK(json.at("pose").at("position").at("y") == -0.25);
  CHECK_THAT(json.at("pose").at("orientation").at("z").get<double>(), WithinAbs(std::sqrt(0.5), 1e-6));
  CHECK_THAT(json.at("pose").at("orientation").at("w").get<double>(), WithinAbs(std::sqrt(0.5), 1e-6));
}

TEST_CASE("What no number can say is null, and every message stays JSON") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(Json::parse(pose_message(0, {infinite, std::nan(""), 0.0}))
            .at("pose")
            .at("position")
            .at("x")
            .is_null());
  LogEntry not_received;
  const Json wheels = Json::parse(wheels_message(noon_ns, not_received));
  CHECK(wheels.at("left").at("command_m_s") == 0.0);
  CHECK(wheels.at("left").at("predicted_m_s").is_null());
  CHECK(wheels.at("right").at("measured_m_s").is_null());
  config::DaemonConfig config;
  config.robot_name = "a \"robot\"\n\xff";
  CHECK_FALSE(Json::parse(state_message(noon_ns, not_received, config, {})).contains("battery_v"));
  CHECK(Json::parse(log_message(noon_ns, LogLevel::error, "the robot prints: \x01\x80\"")).at("level") == 4);
}

TEST_CASE("The pose is that which the robot steers by") {
  LogEntry entry = at_x(1.0);
  CHECK(steering_pose(entry.record, PoseSource::fir).x_m == 1.0);
  CHECK(steering_pose(entry.record, PoseSource::odometry).x_m == 0.9);
  CHECK(steering_pose(entry.record, PoseSource::hybrid).x_m == 0.9);
  entry.record.hybrid.emplace().pose.x_m = 0.95;
  CHECK(steering_pose(entry.record, PoseSource::hybrid).x_m == 0.95);
  entry.record.has_prediction = false;
  CHECK(steering_pose(entry.record, PoseSource::arma).x_m == 0.9);
}

TEST_CASE("Who watches from the start and who comes late see the same floor") {
  Scene scene(there_and_back());
  Viewer early;
  early.take(scene.everything(noon_ns));
  for (int i = 0; i <= 500; ++i) {
    scene.take(at_x(0.004 * i));
    if (i % 7 != 0) continue;
    if (const auto changes = scene.changes(noon_ns)) early.take(*changes);
  }
  if (const auto changes = scene.changes(noon_ns)) early.take(*changes);
  Viewer late;
  late.take(scene.everything(noon_ns));
  for (const std::string way : {"predicted", "odometry"}) {
    CHECK(early.way(way) == late.way(way));
    const auto points = late.way(way);
    CHECK(std::is_sorted(points.begin(), points.end()));
  }
  CHECK(late.way("predicted").size() > 150);
  CHECK_THAT(late.way("predicted").back(), WithinAbs(2.0, 0.011));
  CHECK(late.entities.at("checkpoints").at("spheres").size() == 2);
  CHECK_FALSE(scene.changes(noon_ns));
}

TEST_CASE("What is sent again while the robot drives is the newest piece of its way, not all of it") {
  Scene scene(there_and_back());
  std::size_t largest = 0;
  for (int i = 0; i < 20000; ++i) {
    scene.take(at_x(0.003 * i));
    if (i % 10 != 0) continue;
    if (const auto changes = scene.changes(noon_ns); changes && i > 0)
      largest = std::max(largest, changes->size());
  }
  CHECK(largest < 16000);
  CHECK(scene.everything(noon_ns).size() < 1024 * 1024);  // a client's queue holds it
}

TEST_CASE("Where the route starts, the way of the calibration is gone") {
  Scene scene(there_and_back());
  for (int i = 0; i < 100; ++i) scene.take(at_x(0.01 * i, Activity::encoder_turn));
  Viewer viewer;
  viewer.take(*scene.changes(noon_ns));
  CHECK(viewer.way("odometry").size() > 40);
  scene.take(at_x(0.0));
  viewer.take(*scene.changes(noon_ns));
  CHECK(viewer.way("odometry").size() == 1);
}

TEST_CASE("The ellipse of an isotropic covariance is the circle that holds 95 % of it") {
  Scene scene(std::nullopt);
  LogEntry entry = at_x(1.0);
  HybridOutput& hybrid = entry.record.hybrid.emplace();
  hybrid.pose = {1.0, 2.0, 0.0};
  hybrid.covariance.diagonal() << 0.01, 0.01, 0.1;
  scene.take(entry);
  Viewer viewer;
  viewer.take(scene.everything(noon_ns));
  for (const Json& point : viewer.entities.at("covariance").at("lines")[0].at("points")) {
    const double radius = std::hypot(point.at("x").get<double>() - 1.0, point.at("y").get<double>() - 2.0);
    CHECK_THAT(radius, WithinAbs(0.1 * std::sqrt(5.991), 2e-4));
  }
}
