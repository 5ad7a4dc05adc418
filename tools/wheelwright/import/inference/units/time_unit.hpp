// The unit of the time column of a log.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// By what the file states, else by its numbers; adds a line to `findings` where those decide.
void set_time_unit(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                   std::vector<std::string>& findings);

// Numbers of which the steps leave open whether they are hundredths of a second, or a unit of a thousand
// times as much: decided by the wheels, which go as fast as commanded in one of them; a doubt where those say
// nothing and the rows would be more than 200 a second.
void infer_unit_of_time(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings, std::vector<std::string>& doubts);

}  // namespace wheelwright::import
