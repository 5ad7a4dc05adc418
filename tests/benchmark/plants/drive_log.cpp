#include "tests/benchmark/plants/drive_log.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/benchmark/plants/text.hpp"

namespace plants {

namespace {

std::string header(const DriveLog& log, const SensorSet& sensors) {
  std::string text = "# wheelwright_drive_log: 1\n# wheel_base_m: " + fixed(log.wheel_base_m, 4) +
                     "\n# period_s: " + fixed(log.period_s, 4) + "\n";
  if (sensors.ticks)
    text += "# metres_per_tick_left: " + fixed(log.metres_per_tick, 9) +
            "\n# metres_per_tick_right: " + fixed(log.metres_per_tick, 9) + "\n";
  text += "t,cmd_left,cmd_right";
  if (sensors.ticks) text += ",ticks_left,ticks_right";
  if (sensors.poses) text += ",ref_x,ref_y,ref_theta";
  if (sensors.battery) text += ",battery_v";
  return text + "\n";
}

std::string reference_fields(const std::optional<Pose>& pose, int digits) {
  if (!pose) return ",,,";
  return "," + fixed(pose->x_m, digits) + "," + fixed(pose->y_m, digits) + "," +
         fixed(pose->heading_rad, digits);
}

std::string line(const LogRow& row, const LogDigits& digits, const SensorSet& sensors) {
  std::string text = fixed(row.time_s, digits.time) + "," +
                     fixed(row.command_m_s[left_side], digits.command) + "," +
                     fixed(row.command_m_s[right_side], digits.command);
  if (sensors.ticks)
    text += "," + std::to_string(row.ticks[left_side]) + "," + std::to_string(row.ticks[right_side]);
  if (sensors.poses) text += reference_fields(row.reference, digits.pose);
  if (sensors.battery) text += "," + fixed(row.battery_v, digits.battery);
  return text + "\n";
}

}  // namespace

void write_drive_log(const std::filesystem::path& file, const DriveLog& log, const SensorSet& sensors) {
  std::string text = header(log, sensors);
  for (const LogRow& row : log.rows) text += line(row, log.digits, sensors);
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << text)) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace plants
