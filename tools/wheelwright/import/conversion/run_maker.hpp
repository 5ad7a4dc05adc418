// One run of mapped rows as a drive log.
#pragma once

#include <string>
#include <vector>

#include "model/log/drive_log.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/time_repair.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

// The drive log of the rows of one run, whose times `times_s` (one for each row of the columns) rise; what
// was done to them is added to the remarks.
DriveLog make_run(const DriveColumns& columns, const Column& times_s, const Mapping& mapping,
                  const std::string& name, const RunRows& rows, std::vector<std::string>& remarks);

}  // namespace wheelwright::import
