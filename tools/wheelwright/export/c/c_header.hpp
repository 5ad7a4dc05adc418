// A model as one C99 header: no heap, no library but math.h, no variable that is not constant.
#pragma once

#include "tools/wheelwright/export/model_text.hpp"

namespace wheelwright::tools {

ModelText to_c(const RobotModel& model);

}  // namespace wheelwright::tools
