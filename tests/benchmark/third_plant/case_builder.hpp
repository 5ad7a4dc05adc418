#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmark/third_plant/case_list.hpp"

namespace plants::third {

// Draws a robot for each case and hides effects in it. Case n depends on the seed and n only.
class CaseBuilder {
 public:
  explicit CaseBuilder(std::uint64_t seed) : seed_(seed) {}

  Case single(const Effect& effect, bool large);
  Case several(const std::vector<Effect>& effects, const std::vector<std::string>& names, Sensing sensing,
               Style style);
  Case clean(Sensing sensing, Style style);
  Case cannot_tell(const Effect& effect, Sensing sensing, Style style, Loop loop);
  Case outside(const Effect& effect);

 private:
  void begin(CaseKind kind, const std::string& subject, const Showing& showing, Response response);
  void hide(const Effect& effect, bool large, bool alone);
  Case finish(double min_reference_hz);

  std::uint64_t seed_;
  std::uint64_t begun_ = 0;
  Random random_{0};  // stream of the case that is being drawn
  Case item_;
};

}  // namespace plants::third
