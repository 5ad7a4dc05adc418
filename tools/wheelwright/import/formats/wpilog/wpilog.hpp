// WPILOG, the data log of FRC robots: a 12-byte header, then records of typed entries. Specification: WPILib,
// "WPILib Data Log File Format Specification, Version 1.0" (wpiutil/doc/datalog.adoc).
//
// Each entry (a name such as "/drive/left/velocity") becomes a stream of one channel, or of one a place in an
// array ("[0]"), beside a channel "timestamp" in us. Read are double, float, int64, boolean and arrays of
// them. Entries of other types ("struct:Pose2d", "string", "raw") are named with their records, not decoded.
#pragma once

#include <string>
#include <string_view>

#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

bool is_wpilog(std::string_view head);

// `bytes`: the whole file; `name` stands for it in messages. What lies before a cut is read.
ReadResult read_wpilog(std::string_view bytes, std::string name);

}  // namespace wheelwright::import
