// A route as the model alone would drive it, before any wheel turns: when each checkpoint is reached, and how
// far from it the robot may be by then.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/brain/mission.hpp"
#include "model/geometry/pose.hpp"
#include "model/identification/refusal.hpp"
#include "model/route/route.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright {

struct RouteForecast {
  struct Checkpoint {
    double t_s = 0.0;         // since the start of the route
    Pose pose;                // by the model
    double radius95_m = 0.0;  // in 95 of 100 drives the robot is within it (model/uncertainty)
  };
  std::vector<Checkpoint> checkpoints;  // as far as they are reached, in order
  bool finished = false;                // all of them, within an hour
};

// Steers as Brain does from the model alone.
RouteForecast forecast_route(const RobotModel& model, const Route& route, const RobotLimits& limits);

// Why the mission's route is not to be driven by this model alone: the first checkpoint beyond
// Mission::largest_uncertainty_m, and where most of the uncertainty comes from. Nothing where it may be
// driven, where no limit is set, or where sensors steer.
std::optional<Refusal> doubt_of_route(const RobotModel& model, const Mission& mission,
                                      const RobotLimits& limits);

}  // namespace wheelwright
