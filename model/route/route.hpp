// A route: checkpoints on the floor, visited in order.
#pragma once

#include <string>
#include <vector>

namespace wheelwright {

// In metres, relative to the start pose of the robot: x forward, y left.
struct Checkpoint {
  double x_m = 0.0;
  double y_m = 0.0;
};

struct Route {
  std::string name;
  double speed_m_s = 0.15;
  double tolerance_m = 0.02;  // how near the predicted pose has to come to a checkpoint
  std::vector<Checkpoint> checkpoints;
};

// The figure of a route that ends where it began.
inline bool is_closed(const Route& route) {
  return !route.checkpoints.empty() && route.checkpoints.back().x_m == 0.0 &&
         route.checkpoints.back().y_m == 0.0;
}

}  // namespace wheelwright
