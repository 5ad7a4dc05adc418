// The linear part of a model in C.
#pragma once

#include <optional>
#include <string>

#include "model/simulation/linear_model.hpp"

namespace wheelwright::tools {

// A C array; never empty.
std::string c_array(const std::string& name, const std::vector<double>& values);

// Weights, and the function that takes commands to wheel speeds. `ww_history` is the length of its memory.
std::string c_core(const LinearModel& linear_part);

// The function that takes steady wheel speeds to commands; nothing where no command moves the wheels apart.
std::optional<std::string> c_core_inverse(const LinearModel& linear_part);

}  // namespace wheelwright::tools
