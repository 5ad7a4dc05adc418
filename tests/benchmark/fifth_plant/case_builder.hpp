#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/exam.hpp"

namespace plants::fifth {

// A case with the robot that hides something and the one that does not.
struct BuiltCase {
  ExamCase exam;
  Experiment hidden;
  Experiment innocent;
};

// Draws a robot and an experiment for each case. Case n depends on the seed and n only. The name of a case is
// its subject until the order is known.
class CaseBuilder {
 public:
  explicit CaseBuilder(std::uint64_t seed) : seed_(seed) {}

  BuiltCase single(const Effect& effect, bool large);
  BuiltCase several(const std::vector<const Effect*>& effects, const Showing& showing);
  BuiltCase clean(const Showing& showing);
  // `pace` slows the driver down.
  BuiltCase cannot_tell(const Effect& effect, const Showing& showing, double pace);
  BuiltCase outside(const Effect& effect, bool large);

 private:
  void begin(CaseKind kind, const std::string& subject, const Showing& showing);
  void hide(const Effect& effect, bool large, const std::string& confusable);
  BuiltCase finish();

  std::uint64_t seed_;
  std::uint64_t begun_ = 0;
  Random random_{0};  // stream of the case that is being drawn
  BuiltCase built_;
};

}  // namespace plants::fifth
