// The room around the robot: walls, obstacles, missing floor, and what the floor is like where.
//
// All in the room's frame, in metres.
#pragma once

#include <limits>
#include <vector>

#include "drivers/simulation/simulation_config.hpp"

namespace wheelwright::simulation {

struct Point {
  double x_m = 0.0;
  double y_m = 0.0;
};

// The nearest point of anything that stands in the room.
struct Nearest {
  double distance_m = std::numeric_limits<double>::infinity();
  Point towards;  // unit vector from the asking point to it
};

// Where a ray met something.
struct RayHit {
  double distance_m = std::numeric_limits<double>::infinity();
  double cos_incidence = 0.0;  // 1: straight on
};

class Room {
 public:
  explicit Room(const RoomConfig& config);

  Nearest nearest(const Point& from) const;
  // `direction` is a unit vector.
  RayHit cast(const Point& from, const Point& direction) const;
  bool is_cliff(const Point& at) const;
  bool has_cliffs() const { return !config_.cliffs.empty(); }
  const Surface& surface(const Point& at) const;
  double reflectance() const { return config_.wall_reflectance; }

  // From now on the floor is this everywhere, patches included.
  void replace_floor(const Surface& surface);

 private:
  struct Circle {
    Point centre;
    double radius_m;
  };
  void add_obstacle(const Region& region);

  RoomConfig config_;
  std::vector<WallSegment> segments_;
  std::vector<Circle> circles_;
};

bool contains(const Region& region, const Point& point);

}  // namespace wheelwright::simulation
