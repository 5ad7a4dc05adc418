// The 95 % intervals of a model as ranges, for a simulation that draws its parameters at random.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/export/placed_number.hpp"

namespace wheelwright::tools {

struct ParameterRange {
  std::string place;
  Figure figure;
  std::string unit;
};

// The elements of lists one by one, as "[0]"; figures without an interval are left out.
std::vector<ParameterRange> ranges_of(const std::vector<PlacedNumber>& numbers);

// The parameters of all effects, at their places in the C header.
std::vector<ParameterRange> c_ranges(const RobotModel& model);

// A YAML file, `wheelwright_ranges: 1`.
std::string ranges_to_yaml(const RobotModel& model, const std::string& format,
                           const std::vector<ParameterRange>& ranges, const std::vector<Unsaid>& unsaid);

}  // namespace wheelwright::tools
