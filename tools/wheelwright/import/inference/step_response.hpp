// A log of one step: a command that never changes, and a wheel that starts and settles.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Of the columns that nothing is known of: a speed that rises from rest and settles, or a travel and the
// speed that is its rate, and the one column that stands at a number for the command. Fills in what `mapping`
// lacks of command and wheels; adds lines to `findings`.
void find_step(const Stream& stream, const std::vector<double>& t_s,
               const std::vector<const Channel*>& unused, const GivenMapping& given, Mapping& mapping,
               std::vector<std::string>& findings);

// Of a log whose command stands at one value: the speed at which the wheel settles, in proportion, gives the
// full scale of a duty. One level shows no dead zone: that is said.
void set_step_scale(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings);

}  // namespace wheelwright::import
