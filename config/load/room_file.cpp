// Rooms: walls, obstacles, cliffs, floors.
#include "config/load/simulation_config.hpp"
#include "config/load/yaml_reader.hpp"

namespace wheelwright::config {
namespace {

using simulation::Region;
using simulation::RoomConfig;
using simulation::Surface;

constexpr Range anywhere{-1000, 1000, "m"};

Surface read_surface(YamlReader& from, Surface surface) {
  surface.grip = from.number("grip", {0, 5}, surface.grip);
  surface.creep_per_n = from.number("creep_per_n", {0, 1, "1/N"}, surface.creep_per_n);
  surface.rolling_drag = from.number("rolling_drag", {0, 1}, surface.rolling_drag);
  surface.scrub_factor = from.number("scrub_factor", {0, 100}, surface.scrub_factor);
  surface.slope_x = from.number("slope_x", {-0.5, 0.5, "m/m"}, surface.slope_x);
  surface.slope_y = from.number("slope_y", {-0.5, 0.5, "m/m"}, surface.slope_y);
  return surface;
}

Region read_region(YamlReader& from) {
  Region region;
  region.shape = from.choice<Region::Shape>(
      "shape", {{"rectangle", Region::Shape::rectangle}, {"circle", Region::Shape::circle}}, region.shape);
  region.x_m = from.number("x_m", anywhere);
  region.y_m = from.number("y_m", anywhere);
  if (region.shape == Region::Shape::circle) {
    region.size_x_m = region.size_y_m = from.number("diameter_m", {0.001, 1000, "m"});
    return region;
  }
  region.size_x_m = from.number("size_x_m", {0.001, 1000, "m"});
  region.size_y_m = from.number("size_y_m", {0.001, 1000, "m"});
  region.angle_rad = from.number("angle_rad", {-7, 7, "rad"}, 0.0);
  return region;
}

std::vector<Region> read_regions(YamlReader& from, std::string_view key) {
  std::vector<Region> regions;
  for (YamlReader& entry : from.sections(key)) {
    regions.push_back(read_region(entry));
    entry.finish();
  }
  return regions;
}

}  // namespace

RoomConfig load_room(const std::filesystem::path& path) {
  YamlReader file = YamlReader::load(path);
  RoomConfig room;
  room.wall_reflectance = file.number("wall_reflectance", {0, 1}, room.wall_reflectance);
  if (auto floor = file.section("floor")) {
    room.floor = read_surface(*floor, room.floor);
    floor->finish();
  }
  for (YamlReader& entry : file.sections("patches")) {
    room.patches.push_back({read_region(entry), read_surface(entry, room.floor)});
    entry.finish();
  }
  if (file.has("walls_m")) {
    for (const auto& row : file.rows("walls_m", 4, anywhere)) {
      room.walls.push_back({row[0], row[1], row[2], row[3]});
    }
  }
  room.obstacles = read_regions(file, "obstacles");
  room.cliffs = read_regions(file, "cliffs");
  file.finish();
  return room;
}

}  // namespace wheelwright::config
