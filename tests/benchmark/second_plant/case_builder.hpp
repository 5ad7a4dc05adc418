#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/second_plant/case_list.hpp"

namespace plants::second {

// Draws a robot for each case and hides effects in it. Case n depends on the seed and n only.
class CaseBuilder {
 public:
  explicit CaseBuilder(std::uint64_t seed) : seed_(seed) {}

  Case single(const Effect& effect, double level);
  Case several(const std::vector<Effect>& effects, const std::vector<std::string>& names, Sensing sensing);
  Case clean(Sensing sensing);
  Case cannot_tell(const Effect& effect, Sensing sensing, Style style, const std::string& why);
  Case outside(const Effect& effect);

 private:
  Case draw(CaseKind kind, Drive drive, Sensing sensing, bool dense_poses);
  Sensing choose(const std::vector<Sensing>& possible) const;

  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
  Random random_{0};  // stream of the case that is being drawn
};

}  // namespace plants::second
