// The floor as a scene of Foxglove's 3D panel: the route, its checkpoints, the ways driven by each source of
// pose, and the ellipses that hold the filtered position, and the position by the model alone, with 95 %
// probability.
//
// An entity replaces the one of the same id, so a way is cut into pieces and only the newest of them is sent
// again; who comes later gets all of them by everything().
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/wiring/wiring.hpp"
#include "model/route/route.hpp"

namespace wheelwright::daemon::telemetry {

class Scene {
 public:
  explicit Scene(std::optional<Route> route) : route_(std::move(route)) {}

  // One tick, in order. Returns whether all ways begin again with it, as their poses do.
  bool take(const LogEntry& entry);
  // Where a simulated robot truly is, in the frame of the route.
  void take_truth(const Pose& pose);

  // The scene as a whole, for a new subscriber.
  std::string everything(std::uint64_t time_ns) const;
  // What has changed since the last call; nothing where nothing has.
  std::optional<std::string> changes(std::uint64_t time_ns);

 private:
  struct Point {
    double x_m = 0.0;
    double y_m = 0.0;
  };
  struct Piece {
    std::uint64_t number = 0;
    std::vector<Point> points;
  };
  // The way by one source of pose.
  class Way {
   public:
    void add(const Pose& pose);
    void clear();

    std::deque<Piece> pieces;
    std::uint64_t next_number = 0;
    std::uint64_t first_changed = 0;       // piece, by number
    std::vector<std::uint64_t> forgotten;  // pieces to be deleted at the clients
    bool changed = false;
  };
  struct Ellipse {
    Pose center;
    Eigen::Matrix3d covariance;
  };

  void restart();
  std::string entity(std::uint64_t time_ns, std::string_view frame, const std::string& id,
                     const std::string& shapes) const;
  std::vector<std::string> route_entities(std::uint64_t time_ns) const;
  std::vector<std::string> way_entities(std::uint64_t time_ns, std::size_t way,
                                        std::uint64_t from_piece) const;
  std::vector<std::string> ellipse_entities(std::uint64_t time_ns) const;

  std::optional<Route> route_;
  std::array<Way, 4> ways_;                         // predicted, odometry, filtered, truth
  std::array<std::optional<Ellipse>, 2> ellipses_;  // filtered, predicted
  std::uint16_t visited_ = 0;
  Activity activity_ = Activity::idle;
  bool route_changed_ = false;
  bool ellipses_changed_ = false;
};

}  // namespace wheelwright::daemon::telemetry
