#include "model/gap/candidates/region_scale.hpp"

#include <algorithm>
#include <limits>

namespace wheelwright::gap {
namespace {

constexpr double room_m = 2.5;

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

}  // namespace

double region_scale(const FitProblem& problem) {
  Range x_m;
  Range y_m;
  for (const GapRun& run : problem.runs()) {
    for (const Reference& reference : run.references) {
      x_m.add(reference.pose.x_m);
      y_m.add(reference.pose.y_m);
    }
  }
  return std::max(1.0, std::max(x_m.most - x_m.least, y_m.most - y_m.least) / room_m);
}

}  // namespace wheelwright::gap
