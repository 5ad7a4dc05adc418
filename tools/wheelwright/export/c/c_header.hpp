// A model as one C99 header: no heap, no library but math.h, no variable that is not constant.
#pragma once

#include "tools/wheelwright/export/model_text.hpp"

namespace wheelwright::tools {

ModelText to_c(const RobotModel& model);

// The arrays of it that hold the parameters of an effect.
struct CParameters {
  std::string array;
  const AddedEffect* effect;  // of the model
};
std::vector<CParameters> c_parameter_arrays(const RobotModel& model);

}  // namespace wheelwright::tools
