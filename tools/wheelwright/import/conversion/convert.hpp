// Mapped columns to drive logs: units to SI, counts unwrapped, time made to rise, one log per run.
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "model/log/drive_log.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

struct Conversion {
  std::vector<DriveLog> runs;
  std::vector<std::string> remarks;  // what was done to the data, one line each, with the places
};

// Fails, with one line, where a run cannot be made of them: no commands, no wheel base, no scale of the
// counts.
tl::expected<Conversion, std::string> convert(const DriveColumns& columns, const Mapping& mapping,
                                              const std::string& name);

}  // namespace wheelwright::import
