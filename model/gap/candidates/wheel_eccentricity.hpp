// Ripples in residuals that go with how far a wheel has rolled.
//
// The residuals of each run are laid against sine and cosine of its own wheels' travel: a speed of
// 1 + s sin(angle) + c cos(angle) leaves -s cos + c sin, over the angle per metre, in the travel.
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"

namespace wheelwright::gap {

// Sine and cosine of the left wheel, then of the right one.
using RippleAmounts = Eigen::Vector4d;

// Normal equations of residuals on the four patterns.
struct RippleEquations {
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  RippleAmounts right_side = RippleAmounts::Zero();

  RippleEquations& operator+=(const RippleEquations& other);
  RippleAmounts solution() const;
  double nats() const { return 0.5 * right_side.dot(solution()); }
};

struct Ripple {
  double circumference_m = 0.0;
  double nats = 0.0;  // with an angle for each run
  std::vector<RippleAmounts> of_run;
  RippleEquations together;  // with one angle for all
};

enum class RippleAngle { of_each_run, of_all_runs };

// The wheels' travel in runs, and what of it shows where a ripple at this stage would.
class RippleSearch {
 public:
  // `initial_travel_m` has a pair for each run of the problem. Counts tell the travel where there are any,
  // else the model does. The problem has to outlive the search.
  RippleSearch(const FitProblem& problem, const std::vector<WheelPair>& initial_travel_m,
               const TrialModel& model, EffectStage stage);

  // `residuals` are those of the problem for a model.
  Ripple at(const std::vector<double>& residuals, double circumference_m) const;
  // Of every circumference that suits the robot.
  Ripple strongest(const std::vector<double>& residuals, RippleAngle angle,
                   const ParallelFor& parallel_for) const;

 private:
  struct Watched {
    Channel channel;
    WheelPair share;                  // of each wheel's travel in this channel
    std::vector<WheelPair> rolled_m;  // at each of its readings
  };
  using RunTravel = std::vector<Watched>;

  RippleEquations equations(std::size_t run, const std::vector<double>& residuals,
                            double circumference_m) const;
  double longest_way_m() const;

  const FitProblem& problem_;
  std::vector<RunTravel> runs_;
};

}  // namespace wheelwright::gap
