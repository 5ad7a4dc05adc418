#include "drivers/simulation/light_bumper.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/simulation/host.hpp"

using namespace wheelwright::simulation;
using wheelwright::Pose;

namespace {

// The centre-left sensor's signal for a wall ahead at this distance from the bumper's window.
std::int32_t signal_at(double distance_m) {
  RoomConfig config;
  const double window_m = 0.165 * std::cos(0.25);
  config.walls = {{window_m + distance_m, -2.0, window_m + distance_m, 2.0}};
  Noise noise(1);
  const Chassis body({}, Pose{});
  return LightBumper({}).look(body, Room(config), noise)[2];
}

// The largest and smallest value of each sensor during one turn in place.
std::pair<std::int32_t, std::int32_t> span_in_one_turn(const std::string& room) {
  auto config = shipped_robot("default.yaml");
  config.room = shipped_room(room);
  Host host(config);
  host.start();
  host.drive(-150, 150);
  std::int32_t least = 4095;
  std::int32_t most = 0;
  while (host.robot.truth().pose.theta_rad < 7.0 && host.robot.now() < 20s) {
    const std::int32_t signal = host.packet(48);
    least = std::min(least, signal);
    most = std::max(most, signal);
  }
  CHECK_FALSE(host.robot.truth().touches_wall);
  return {least, most};
}

}  // namespace

TEST_CASE("The light bumper's signal falls with distance and ends at its range") {
  CHECK(signal_at(0.02) > signal_at(0.05));
  CHECK(signal_at(0.05) > signal_at(0.15));
  CHECK(signal_at(0.15) > 50);
  CHECK(signal_at(0.31) == 0);
}

TEST_CASE("The light bumper sees less of a wall that it meets at a slant") {
  Noise noise(1);
  RoomConfig straight;
  straight.obstacles = {{.shape = Region::Shape::rectangle, .x_m = 0.5, .size_x_m = 0.5, .size_y_m = 3.0}};
  const Chassis facing({}, Pose{0.0, 0.0, 0.25});  // the centre-right sensor looks along x
  const Chassis slanted({}, Pose{0.0, 0.0, 0.75});
  const auto head_on = LightBumper({}).look(facing, Room(straight), noise);
  const auto aslant = LightBumper({}).look(slanted, Room(straight), noise);
  CHECK(head_on[3] > aslant[3]);
}

TEST_CASE("Turning in place in each furnished room the light bumper sees something come and go") {
  for (const std::string room :
       {"box.yaml", "furniture.yaml", "corner.yaml", "carpet.yaml", "box_without_slip.yaml"}) {
    CAPTURE(room);
    const auto [least, most] = span_in_one_turn(room);
    CHECK(least < 60);
    CHECK(most > 150);
  }
}

TEST_CASE("In the empty room the light bumper sees nothing but noise") {
  const auto [least, most] = span_in_one_turn("empty.yaml");
  CHECK(least == 0);
  CHECK(most < 40);
}

TEST_CASE("Rays meet round obstacles and the edges of turned boxes where geometry says") {
  RoomConfig config;
  config.obstacles = {{.shape = Region::Shape::circle, .x_m = 1.0, .size_x_m = 0.4},
                      {.shape = Region::Shape::rectangle,
                       .x_m = 0.0,
                       .y_m = 1.0,
                       .size_x_m = std::sqrt(2.0) * 0.2,
                       .size_y_m = std::sqrt(2.0) * 0.2,
                       .angle_rad = 0.25 * 3.14159265358979}};
  const Room room(config);
  CHECK_THAT(room.cast({0.0, 0.0}, {1.0, 0.0}).distance_m, WithinAbs(0.8, 1e-9));
  CHECK_THAT(room.cast({0.01, 0.0}, {0.0, 1.0}).distance_m, WithinAbs(0.81, 1e-6));
  CHECK(std::isinf(room.cast({0.0, 0.0}, {-1.0, 0.0}).distance_m));
  CHECK_THAT(room.nearest({0.0, 0.0}).distance_m, WithinAbs(0.8, 1e-6));
}
