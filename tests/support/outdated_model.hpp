// Models that have become wrong, and routes long enough to learn better ones.
#pragma once

#include <vector>

#include "model/route/route.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::test {

// The model of a robot whose wheels roll 1 / `factor` as far as it says.
inline RobotModel scaled(RobotModel model, double factor) {
  for (auto* response : {&model.linear_part.left, &model.linear_part.right}) {
    for (double& weight : response->from_left) weight *= factor;
    for (double& weight : response->from_right) weight *= factor;
  }
  return model;
}

// Round and round a rectangle of 0.5 m by 0.4 m.
inline std::vector<Checkpoint> laps(int count) {
  std::vector<Checkpoint> points;
  for (int lap = 0; lap < count; ++lap) {
    for (const Checkpoint& corner :
         {Checkpoint{0.5, 0.0}, Checkpoint{0.5, 0.4}, Checkpoint{0.0, 0.4}, Checkpoint{0.0, 0.0}}) {
      points.push_back(corner);
    }
  }
  return points;
}

}  // namespace wheelwright::test
