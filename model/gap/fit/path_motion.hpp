// How a path that is given by its steps, one per period, moves between two times of the grid.
#pragma once

#include <cstddef>
#include <vector>

#include "model/gap/runs/run.hpp"
#include "model/simulation/model_simulation.hpp"

namespace wheelwright::gap {

// Motion from one pose to another, seen in the direction halfway through the turn; m and rad.
struct Increment {
  double forward = 0.0;
  double aside = 0.0;
  double turn = 0.0;
};

Increment increment(const Pose& from, const Pose& to);

// A share of the way from `a` to `b`.
inline double interpolated(double a, double b, double share) {
  return a + share * (b - a);
}

// Calls `step(k, share)` for each period between two grid times, with the share of it that lies between them.
template <typename Step>
void for_each_period(const GridTime& from, const GridTime& to, Step step) {
  for (std::size_t k = from.period; k <= to.period; ++k) {
    const double begin = k == from.period ? from.share : 0.0;
    const double end = k == to.period ? to.share : 1.0;
    if (end > begin) step(k, end - begin);
  }
}

class PathMotion {
 public:
  // `measured_by` is the model whose effects say which point of the robot the references show; null: the
  // middle of the axle. What is given must outlive this.
  PathMotion(const GapRun& run, const std::vector<OdometryStep>& steps,
             const ModelSimulation* measured_by = nullptr);
  // As the references show it: later and smoother, where they respond so.
  Increment increment(const GridTime& from, const GridTime& to) const;

 private:
  Pose shown_at(const GridTime& when) const;

  const std::vector<OdometryStep>& steps_;
  const ModelSimulation* measured_by_;
  std::vector<Pose> shown_;  // at each grid point; empty where the references show the robot at once
};

}  // namespace wheelwright::gap
