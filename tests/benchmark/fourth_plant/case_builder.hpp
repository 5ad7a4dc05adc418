#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/fourth_plant/effects.hpp"
#include "tests/benchmark/plants/exam.hpp"

namespace plants::fourth {

// Draws a robot and an experiment for each case. Case n depends on the seed and n only. The name of a case is
// its subject until the order is known.
class CaseBuilder {
 public:
  explicit CaseBuilder(std::uint64_t seed) : seed_(seed) {}

  ExamCase single(const Effect& effect, bool large);
  ExamCase several(const std::vector<const Effect*>& effects, const Showing& showing);
  ExamCase clean(const Showing& showing);
  // `pace` slows the driver down.
  ExamCase cannot_tell(const Effect& effect, const Showing& showing, double pace);
  ExamCase outside(const Effect& effect);

 private:
  void begin(CaseKind kind, const std::string& subject, const Showing& showing);
  void hide(const Effect& effect, bool large, const std::string& confusable);
  ExamCase finish();

  std::uint64_t seed_;
  std::uint64_t begun_ = 0;
  Random random_{0};  // stream of the case that is being drawn
  ExamCase item_;
  Experiment experiment_;
  Robot innocent_;
};

}  // namespace plants::fourth
