// Commands that are given as they stand, whatever the robot does: those of a recorded run, or of the
// experiment that a gap analysis asks for.
#pragma once

#include <string>
#include <vector>

#include "model/log/drive_log.hpp"

namespace wheelwright {

struct CommandedDrive {
  struct Row {
    double t_s = 0.0;       // since the start of the drive, rising
    WheelPair command_m_s;  // in force from then on
  };
  std::string name;
  std::vector<Row> rows;  // the first one at zero
  double duration_s = 0.0;
};

// The commands of a log, from its first row until a period after its last; rows that change nothing are left
// out.
CommandedDrive commanded_drive_of(const DriveLog& log);

}  // namespace wheelwright
