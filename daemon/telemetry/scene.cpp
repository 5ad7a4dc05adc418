#include "daemon/telemetry/scene.hpp"

#include <cmath>
#include <numbers>

#include "daemon/telemetry/json_text.hpp"
#include "daemon/telemetry/messages.hpp"
#include "model/uncertainty/pose_uncertainty.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

constexpr double point_every_m = 0.01;
constexpr std::size_t points_in_piece = 64;
constexpr std::size_t max_pieces = 128;  // 80 m of way; what is older is forgotten

struct Look {
  std::string_view id;
  std::string_view color;
  double thickness_px;
};
constexpr std::array<Look, 4> looks{{{"predicted", R"({"r":0.10,"g":0.55,"b":0.50,"a":1})", 3.0},
                                     {"odometry", R"({"r":0.55,"g":0.60,"b":0.66,"a":1})", 2.0},
                                     {"filtered", R"({"r":0.85,"g":0.55,"b":0.20,"a":1})", 2.0},
                                     {"truth", R"({"r":0.75,"g":0.25,"b":0.20,"a":1})", 2.0}}};
constexpr std::string_view route_color = R"({"r":0.55,"g":0.60,"b":0.66,"a":0.6})";
constexpr std::string_view ahead_color = R"({"r":0.55,"g":0.60,"b":0.66,"a":1})";
constexpr std::string_view visited_color = R"({"r":0.10,"g":0.55,"b":0.50,"a":1})";

std::string joined(const std::vector<std::string>& items) {
  std::string text = "[";
  for (const std::string& item : items) {
    if (text.size() > 1) text += ',';
    text += item;
  }
  return text + "]";
}

std::string line_strip(const std::vector<std::string>& points, std::string_view color, double thickness_px) {
  return R"("lines":[{"type":0,"pose":)" + pose_text({}) + R"(,"thickness":)" + number(thickness_px, 1) +
         R"(,"scale_invariant":true,"points":)" + joined(points) + R"(,"color":)" + std::string(color) +
         R"(,"colors":[],"indices":[]}])";
}

std::string id_of(std::size_t way, std::uint64_t piece) {
  return std::string(looks.at(way).id) + "/" + std::to_string(piece);
}

std::string update_of(const std::vector<std::string>& deletions, const std::vector<std::string>& entities) {
  return R"({"deletions":)" + joined(deletions) + R"(,"entities":)" + joined(entities) + "}";
}

}  // namespace

void Scene::Way::add(const Pose& pose) {
  if (!pieces.empty()) {
    const Point& last = pieces.back().points.back();
    if (std::hypot(pose.x_m - last.x_m, pose.y_m - last.y_m) < point_every_m) return;
  }
  if (pieces.empty() || pieces.back().points.size() >= points_in_piece) {
    // It begins where the one before it ends, without a gap.
    std::vector<Point> points;
    if (!pieces.empty()) points.push_back(pieces.back().points.back());
    pieces.push_back({next_number++, std::move(points)});
  }
  if (!changed) first_changed = pieces.back().number;
  changed = true;
  pieces.back().points.push_back({pose.x_m, pose.y_m});
  if (pieces.size() > max_pieces) {
    forgotten.push_back(pieces.front().number);
    pieces.pop_front();
  }
}

void Scene::Way::clear() {
  for (const Piece& piece : pieces) forgotten.push_back(piece.number);
  pieces.clear();
  changed = true;
  first_changed = next_number;
}

void Scene::restart() {
  for (Way& way : ways_) way.clear();
  ellipses_.fill(std::nullopt);
  visited_ = 0;
  route_changed_ = true;
}

bool Scene::take(const LogEntry& entry) {
  const PoseRecord& record = entry.record;
  const Activity activity = entry.frame.command.activity;
  // Where the route starts, all poses are zero again; so are they where another run begins.
  const bool drives = activity == Activity::route || activity == Activity::commanded_drive;
  const bool begins = activity != activity_ &&
                      (drives || activity_ == Activity::idle ||
                       (activity == Activity::wait_until_still && activity_ != Activity::commanded_drive));
  activity_ = activity;
  if (begins) restart();
  if (activity == Activity::idle) return begins;
  if (record.has_prediction) {
    ways_[0].add(record.predicted);
    ellipses_[1] = Ellipse{record.predicted, record.predicted_covariance};
    ellipses_changed_ = true;
  }
  if (record.valid) ways_[1].add(record.odometry);
  if (record.hybrid) {
    ways_[2].add(record.hybrid->pose);
    ellipses_[0] = Ellipse{record.hybrid->pose, record.hybrid->covariance};
    ellipses_changed_ = true;
  }
  if (record.visited != visited_) {
    visited_ = record.visited;
    route_changed_ = true;
  }
  return begins;
}

void Scene::take_truth(const Pose& pose) {
  ways_[3].add(pose);
}

std::string Scene::entity(std::uint64_t time_ns, std::string_view frame, const std::string& id,
                          const std::string& shapes) const {
  std::string text = R"({"timestamp":)" + time_text(time_ns) + R"(,"frame_id":)" + json_quoted(frame) +
                     R"(,"id":)" + json_quoted(id) +
                     R"(,"lifetime":{"sec":0,"nsec":0},"frame_locked":true,"metadata":[])";
  for (const std::string_view kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"}) {
    const std::string key = "\"" + std::string(kind) + "\":";
    if (!shapes.starts_with(key)) text += "," + key + "[]";
  }
  return text + "," + shapes + "}";
}

std::vector<std::string> Scene::route_entities(std::uint64_t time_ns) const {
  const double body_m = 0.34;
  std::vector<std::string> entities;
  entities.push_back(entity(
      time_ns, robot_frame, "robot",
      R"("cylinders":[{"pose":)" + pose_text({}, 0.045) + R"(,"size":)" + point_text(body_m, body_m, 0.09) +
          R"(,"bottom_scale":1,"top_scale":0.9,"color":)" + std::string(visited_color) + "}]"));
  if (!route_) return entities;
  std::vector<std::string> corners{point_text(0.0, 0.0)};
  std::vector<std::string> spheres;
  const double size_m = 2.0 * route_->tolerance_m;
  for (const Checkpoint& point : route_->checkpoints) {
    corners.push_back(point_text(point.x_m, point.y_m));
    const bool visited = spheres.size() < visited_;
    spheres.push_back(R"({"pose":)" + pose_text({point.x_m, point.y_m, 0.0}) + R"(,"size":)" +
                      point_text(size_m, size_m, size_m) + R"(,"color":)" +
                      std::string(visited ? visited_color : ahead_color) + "}");
  }
  entities.push_back(entity(time_ns, route_frame, "route", line_strip(corners, route_color, 1.0)));
  entities.push_back(entity(time_ns, route_frame, "checkpoints", R"("spheres":)" + joined(spheres)));
  return entities;
}

std::vector<std::string> Scene::way_entities(std::uint64_t time_ns, std::size_t way,
                                             std::uint64_t from_piece) const {
  std::vector<std::string> entities;
  for (const Piece& piece : ways_.at(way).pieces) {
    if (piece.number < from_piece) continue;
    std::vector<std::string> points;
    for (const Point& point : piece.points) points.push_back(point_text(point.x_m, point.y_m));
    entities.push_back(entity(time_ns, route_frame, id_of(way, piece.number),
                              line_strip(points, looks.at(way).color, looks.at(way).thickness_px)));
  }
  return entities;
}

std::vector<std::string> Scene::ellipse_entities(std::uint64_t time_ns) const {
  constexpr std::array<std::string_view, 2> ids{"covariance", "predicted_covariance"};
  const std::array colors{looks[2].color, looks[0].color};
  std::vector<std::string> entities;
  for (std::size_t i = 0; i < ellipses_.size(); ++i) {
    if (!ellipses_.at(i)) continue;
    const Ellipse& ellipse = *ellipses_.at(i);
    std::vector<std::string> points;
    for (const Pose& corner : ellipse95_outline(ellipse.center, ellipse.covariance, 36))
      points.push_back(point_text(corner.x_m, corner.y_m));
    entities.push_back(
        entity(time_ns, route_frame, std::string(ids.at(i)), line_strip(points, colors.at(i), 2.0)));
  }
  return entities;
}

std::string Scene::everything(std::uint64_t time_ns) const {
  auto entities = route_entities(time_ns);
  for (std::size_t way = 0; way < ways_.size(); ++way) {
    for (auto& piece : way_entities(time_ns, way, 0)) entities.push_back(std::move(piece));
  }
  for (auto& ellipse : ellipse_entities(time_ns)) entities.push_back(std::move(ellipse));
  const std::string all = R"({"timestamp":)" + time_text(time_ns) + R"(,"type":1,"id":""})";
  return update_of({all}, entities);
}

std::optional<std::string> Scene::changes(std::uint64_t time_ns) {
  std::vector<std::string> deletions;
  std::vector<std::string> entities;
  if (route_changed_) entities = route_entities(time_ns);
  for (std::size_t way = 0; way < ways_.size(); ++way) {
    Way& changed = ways_.at(way);
    for (const std::uint64_t piece : changed.forgotten) {
      deletions.push_back(R"({"timestamp":)" + time_text(time_ns) + R"(,"type":0,"id":)" +
                          json_quoted(id_of(way, piece)) + "}");
    }
    if (changed.changed) {
      for (auto& piece : way_entities(time_ns, way, changed.first_changed))
        entities.push_back(std::move(piece));
    }
    changed.forgotten.clear();
    changed.changed = false;
  }
  if (ellipses_changed_) {
    for (auto& ellipse : ellipse_entities(time_ns)) entities.push_back(std::move(ellipse));
  }
  route_changed_ = ellipses_changed_ = false;
  if (deletions.empty() && entities.empty()) return std::nullopt;
  return update_of(deletions, entities);
}

}  // namespace wheelwright::daemon::telemetry
