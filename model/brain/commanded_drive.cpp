#include "model/brain/commanded_drive.hpp"

namespace wheelwright {

CommandedDrive commanded_drive_of(const DriveLog& log) {
  CommandedDrive drive;
  drive.name = log.name;
  if (log.samples.empty()) return drive;
  const double start_s = log.samples.front().t_s;
  for (const DriveSample& sample : log.samples) {
    const WheelPair& command = sample.command_m_s;
    if (!drive.rows.empty() && drive.rows.back().command_m_s.left == command.left &&
        drive.rows.back().command_m_s.right == command.right) {
      continue;
    }
    drive.rows.push_back({sample.t_s - start_s, command});
  }
  drive.duration_s = log.samples.back().t_s - start_s + log.period_s;
  return drive;
}

}  // namespace wheelwright
