#pragma once

#include <vector>

#include "tests/benchmark/plants/run.hpp"
#include "tests/benchmark/sixth_plant/case_plan.hpp"
#include "tests/benchmark/sixth_plant/drive_script.hpp"

namespace plants::sixth {

// The robot of a case, what its effects have besides their sizes, and its drives.
struct CaseSetting {
  PlannedCase plan;  // with programme and channels
  Robot robot;
  Details details;
  std::vector<DriveScript> scripts;

  [[nodiscard]] bool hides(Effect effect) const;
  [[nodiscard]] std::vector<Run> simulated(const Hidden& hidden, std::size_t runs) const;
};

CaseSetting drawn_setting(const PlannedCase& plan, Random& random);

}  // namespace plants::sixth
