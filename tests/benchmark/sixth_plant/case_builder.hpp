#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/sixth_plant/case_plan.hpp"

namespace plants::sixth {

struct SizedEffect {
  Effect effect;
  double size;
  double visibility;  // alone, in multiples of the noise; 0 = was not asked
  std::string how;
};

struct BuiltCase {
  PlannedCase plan;  // with programme and channels
  std::vector<SizedEffect> hidden;
  bool battery = false;   // whether the log has its voltage
  std::vector<Run> runs;  // with a pose in every row
};

// Draws robot and drives, makes each effect as large as the case wants it to show, and drives. Depends on the
// plan only.
BuiltCase build_case(const PlannedCase& plan);

}  // namespace plants::sixth
