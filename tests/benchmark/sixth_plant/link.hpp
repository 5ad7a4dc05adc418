#pragma once

#include <vector>

#include "tests/benchmark/plants/random.hpp"
#include "tests/benchmark/sixth_plant/drive_script.hpp"
#include "tests/benchmark/sixth_plant/hidden.hpp"
#include "tests/benchmark/sixth_plant/robot.hpp"

namespace plants::sixth {

// The radio: brings commands late, and holds the last one while it stands still.
class Link {
 public:
  Link(const Robot& robot, const Hidden& hidden, const DriveScript& script, Random& chance);

  // To be asked for rising times.
  const PerWheel<double>& command_m_s(double time_s);

 private:
  struct Stall {
    double from_s;
    double to_s;
  };
  [[nodiscard]] bool stalls(double time_s) const;

  const DriveScript& script_;
  double latency_s_;
  double buffered_s_;
  std::vector<Stall> stalls_;
  std::size_t next_ = 0;
  PerWheel<double> held_m_s_{};
};

}  // namespace plants::sixth
