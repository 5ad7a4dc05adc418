#include "drivers/simulation/room.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelwright::simulation {
namespace {

Point turned(const Point& point, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * point.x_m - s * point.y_m, s * point.x_m + c * point.y_m};
}

Nearest nearest_to_point(const Point& from, const Point& target) {
  const double dx = target.x_m - from.x_m;
  const double dy = target.y_m - from.y_m;
  const double distance = std::sqrt(dx * dx + dy * dy);
  if (distance == 0.0) return {0.0, {1.0, 0.0}};
  return {distance, {dx / distance, dy / distance}};
}

Nearest nearest_on_segment(const Point& from, const WallSegment& wall) {
  const double ex = wall.x2_m - wall.x1_m;
  const double ey = wall.y2_m - wall.y1_m;
  const double length2 = ex * ex + ey * ey;
  const double along =
      length2 == 0.0 ? 0.0 : ((from.x_m - wall.x1_m) * ex + (from.y_m - wall.y1_m) * ey) / length2;
  const double t = std::clamp(along, 0.0, 1.0);
  return nearest_to_point(from, {wall.x1_m + t * ex, wall.y1_m + t * ey});
}

RayHit hit_segment(const Point& from, const Point& direction, const WallSegment& wall) {
  const double ex = wall.x2_m - wall.x1_m;
  const double ey = wall.y2_m - wall.y1_m;
  const double cross = direction.x_m * ey - direction.y_m * ex;
  if (std::abs(cross) < 1e-12) return {};
  const double qx = wall.x1_m - from.x_m;
  const double qy = wall.y1_m - from.y_m;
  const double distance = (qx * ey - qy * ex) / cross;
  const double along = (qx * direction.y_m - qy * direction.x_m) / cross;
  if (distance < 0.0 || along < 0.0 || along > 1.0) return {};
  return {distance, std::abs(cross) / std::sqrt(ex * ex + ey * ey)};
}

}  // namespace

bool contains(const Region& region, const Point& point) {
  const Point offset{point.x_m - region.x_m, point.y_m - region.y_m};
  if (region.shape == Region::Shape::circle) {
    return std::hypot(offset.x_m, offset.y_m) <= 0.5 * region.size_x_m;
  }
  const Point local = region.angle_rad == 0.0 ? offset : turned(offset, -region.angle_rad);
  return std::abs(local.x_m) <= 0.5 * region.size_x_m && std::abs(local.y_m) <= 0.5 * region.size_y_m;
}

Room::Room(const RoomConfig& config) : config_(config), segments_(config.walls) {
  for (const Region& obstacle : config.obstacles) add_obstacle(obstacle);
}

void Room::add_obstacle(const Region& region) {
  if (region.shape == Region::Shape::circle) {
    circles_.push_back({{region.x_m, region.y_m}, 0.5 * region.size_x_m});
    return;
  }
  const double hx = 0.5 * region.size_x_m;
  const double hy = 0.5 * region.size_y_m;
  std::array<Point, 4> corners{{{hx, hy}, {-hx, hy}, {-hx, -hy}, {hx, -hy}}};
  for (Point& corner : corners) {
    corner = turned(corner, region.angle_rad);
    corner.x_m += region.x_m;
    corner.y_m += region.y_m;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    segments_.push_back({a.x_m, a.y_m, b.x_m, b.y_m});
  }
}

Nearest Room::nearest(const Point& from) const {
  Nearest best;
  for (const WallSegment& wall : segments_) {
    const Nearest found = nearest_on_segment(from, wall);
    if (found.distance_m < best.distance_m) best = found;
  }
  for (const Circle& circle : circles_) {
    Nearest found = nearest_to_point(from, circle.centre);
    found.distance_m = std::max(0.0, found.distance_m - circle.radius_m);
    if (found.distance_m < best.distance_m) best = found;
  }
  return best;
}

RayHit Room::cast(const Point& from, const Point& direction) const {
  RayHit best;
  for (const WallSegment& wall : segments_) {
    const RayHit found = hit_segment(from, direction, wall);
    if (found.distance_m < best.distance_m) best = found;
  }
  for (const Circle& circle : circles_) {
    const double cx = circle.centre.x_m - from.x_m;
    const double cy = circle.centre.y_m - from.y_m;
    const double along = cx * direction.x_m + cy * direction.y_m;
    const double aside = cx * direction.y_m - cy * direction.x_m;
    const double half_chord2 = circle.radius_m * circle.radius_m - aside * aside;
    if (along < 0.0 || half_chord2 < 0.0) continue;
    const double half_chord = std::sqrt(half_chord2);
    const double distance = std::max(0.0, along - half_chord);
    if (distance < best.distance_m) best = {distance, half_chord / circle.radius_m};
  }
  return best;
}

bool Room::is_cliff(const Point& at) const {
  return std::any_of(config_.cliffs.begin(), config_.cliffs.end(),
                     [&](const Region& cliff) { return contains(cliff, at); });
}

const Surface& Room::surface(const Point& at) const {
  for (auto patch = config_.patches.rbegin(); patch != config_.patches.rend(); ++patch) {
    if (contains(patch->region, at)) return patch->surface;
  }
  return config_.floor;
}

void Room::replace_floor(const Surface& surface) {
  config_.floor = surface;
  config_.patches.clear();
}

}  // namespace wheelwright::simulation
