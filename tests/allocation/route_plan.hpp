// A route and a model to drive it by, without a file or a calibration.
#pragma once

#include <cmath>

#include "model/brain/mission.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::test {

inline Mission triangle_mission(PoseSource source) {
  Mission mission;
  mission.route = Route{"triangle", 0.15, 0.02, {{0.4, 0.0}, {0.4, 0.3}, {0.0, 0.0}}};
  mission.pose_source = source;
  return mission;
}

// A lag of 60 ms after a dead time of two periods, of gain one.
inline LinearModel lagging_model() {
  LinearModel model;
  const double keeps = std::exp(-0.018 / 0.06);
  for (auto* weights : {&model.left.from_left, &model.right.from_right}) {
    weights->assign(40, 0.0);
    double weight = 1.0 - keeps;
    for (std::size_t i = 2; i < weights->size(); ++i, weight *= keeps) weights->at(i) = weight;
  }
  model.left.from_right.assign(40, 0.0);
  model.right.from_left.assign(40, 0.0);
  return model;
}

// The same with an encoder scale, so that the hybrid filter runs.
inline RobotModel lagging_robot() {
  RobotModel robot;
  robot.linear_part = lagging_model();
  robot.encoder_scale = EncoderScale{{0.000444565, 0.000444565}, 1660.0, 0.001};
  return robot;
}

}  // namespace wheelwright::test
