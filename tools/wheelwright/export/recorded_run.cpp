#include "tools/wheelwright/export/recorded_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "config/load/drive_log_file.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {
namespace {

namespace fs = std::filesystem;
using config::CsvTable;

// Columns that mean something only together.
template <std::size_t size>
class Group {
 public:
  Group(const CsvTable& table, const std::array<const char*, size>& names) : table_(table) {
    for (std::size_t i = 0; i < size; ++i) columns_.at(i) = table.find(names.at(i));
  }
  // Nothing where a column or a field is missing.
  std::optional<std::array<double, size>> at(std::size_t row) const {
    std::array<double, size> values{};
    for (std::size_t i = 0; i < size; ++i) {
      const auto value = columns_[i] ? table_.number(row, *columns_[i]) : std::nullopt;
      if (!value) return std::nullopt;
      values[i] = *value;
    }
    return values;
  }

 private:
  const CsvTable& table_;
  std::array<std::optional<std::size_t>, size> columns_{};
};

std::optional<WheelPair> wheels(const std::optional<std::array<double, 2>>& values) {
  if (!values) return std::nullopt;
  return WheelPair{(*values)[0], (*values)[1]};
}

std::optional<Pose> pose(const std::optional<std::array<double, 3>>& values) {
  if (!values) return std::nullopt;
  return Pose{(*values)[0], (*values)[1], (*values)[2]};
}

std::optional<double> alone(const std::optional<std::array<double, 1>>& value) {
  if (!value) return std::nullopt;
  return (*value)[0];
}

int whole(double value) {
  return static_cast<int>(std::clamp(std::round(value), -1e9, 1e9));
}

class DriveRows {
 public:
  explicit DriveRows(const CsvTable& table) : table_(table) {}

  void add(std::size_t row, mcap::TickValues& tick) const {
    tick.command_m_s = wheels(command_.at(row));
    if (const auto counts = ticks_.at(row)) {
      tick.ticks = {std::llround((*counts)[0]), std::llround((*counts)[1])};
    }
    tick.reference = pose(reference_.at(row));
    mcap::SensorValues sensors;
    sensors.battery_v = alone(battery_.at(row));
    sensors.gyro_z_rad_s = alone(gyro_.at(row));
    sensors.motor_current_a = wheels(current_.at(row));
    sensors.light_bumper = light_.at(row);
    if (const auto flags = flags_.at(row)) {
      const auto& [bump, drop, cliff, overcurrents] = *flags;
      sensors.bump = bump > 0.0;
      sensors.wheel_drop = drop > 0.0;
      sensors.cliff = cliff > 0.0;
      sensors.overcurrents = whole(overcurrents);
    }
    tick.sensors = sensors;
    if (!activity_) return;
    mcap::StateValues& state = tick.state.emplace();
    state.activity = table_.text(row, *activity_);
    if (stop_) state.stop = table_.text(row, *stop_);
    if (const auto version = version_.at(row)) state.model_version = whole((*version)[0]);
  }

 private:
  const CsvTable& table_;
  Group<2> command_{table_, {"cmd_left", "cmd_right"}};
  Group<2> ticks_{table_, {"ticks_left", "ticks_right"}};
  Group<3> reference_{table_, {"ref_x", "ref_y", "ref_theta"}};
  Group<1> battery_{table_, {"battery_v"}};
  Group<1> gyro_{table_, {"gyro_z"}};
  Group<2> current_{table_, {"current_left_a", "current_right_a"}};
  Group<6> light_{table_,
                  {"light_left", "light_front_left", "light_center_left", "light_center_right",
                   "light_front_right", "light_right"}};
  Group<4> flags_{table_, {"bump", "wheel_drop", "cliff", "overcurrents"}};
  Group<1> version_{table_, {"model_version"}};
  std::optional<std::size_t> activity_ = table_.find("activity");
  std::optional<std::size_t> stop_ = table_.find("stop");
};

class PoseRows {
 public:
  explicit PoseRows(const CsvTable& table) : table_(table) {}

  void add(std::size_t row, mcap::TickValues& tick) const {
    tick.model = pose(model_.at(row));
    tick.odometry = pose(odometry_.at(row));
    tick.hybrid = pose(hybrid_.at(row));
    tick.predicted_m_s = wheels(predicted_.at(row));
    tick.measured_m_s = wheels(measured_.at(row));
    tick.covariance = covariance_.at(row);
    tick.model_covariance = model_covariance_.at(row);
    tick.events = text(row, events_);
    if (!activity_) return;
    if (!tick.state) tick.state.emplace().activity = text(row, activity_);
    mcap::StateValues& state = *tick.state;
    if (const auto visited = visited_.at(row)) state.checkpoints_visited = whole((*visited)[0]);
    state.discarded = text(row, discarded_);
    state.fault_left = text(row, fault_left_);
    state.fault_right = text(row, fault_right_);
    if (const auto due = due_.at(row)) state.recalibration_due = (*due)[0] > 0.0;
  }

 private:
  std::string text(std::size_t row, const std::optional<std::size_t>& column) const {
    return column ? std::string(table_.text(row, *column)) : std::string();
  }

  const CsvTable& table_;
  Group<3> model_{table_, {"x", "y", "theta"}};
  Group<3> odometry_{table_, {"odometry_x", "odometry_y", "odometry_theta"}};
  Group<3> hybrid_{table_, {"hybrid_x", "hybrid_y", "hybrid_theta"}};
  Group<2> predicted_{table_, {"speed_left", "speed_right"}};
  Group<2> measured_{table_, {"measured_speed_left", "measured_speed_right"}};
  Group<6> covariance_{table_,
                       {"hybrid_cov_xx", "hybrid_cov_xy", "hybrid_cov_yy", "hybrid_cov_xtheta",
                        "hybrid_cov_ytheta", "hybrid_cov_thetatheta"}};
  Group<6> model_covariance_{table_,
                             {"model_cov_xx", "model_cov_xy", "model_cov_yy", "model_cov_xtheta",
                              "model_cov_ytheta", "model_cov_thetatheta"}};
  Group<1> visited_{table_, {"checkpoints_visited"}};
  Group<1> due_{table_, {"recalibration_due"}};
  std::optional<std::size_t> activity_ = table_.find("activity");
  std::optional<std::size_t> discarded_ = table_.find("discarded");
  std::optional<std::size_t> fault_left_ = table_.find("fault_left");
  std::optional<std::size_t> fault_right_ = table_.find("fault_right");
  std::optional<std::size_t> events_ = table_.find("events");
};

std::vector<double> rising_times(const std::optional<CsvTable>& table) {
  if (!table) return {};
  auto times = table->numbers("t");
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (row > 0 ? times[row] > times[row - 1] : !std::isnan(times[row])) continue;
    const std::string before = row > 0 ? config::plain_number(times[row - 1]) : "nothing";
    throw config::LogError(table->name() + ": time goes from " + before + " to " +
                           config::plain_number(times[row]) +
                           " s, but must rise; where the file holds several runs, split it");
  }
  return times;
}

}  // namespace

RecordedRun load_recorded_run(const std::string& path) {
  RecordedRun run;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    for (const char* name : {"drive_log.csv", "pose_log.csv"}) {
      const fs::path file = fs::path(path) / name;
      if (!fs::exists(file, ignored)) continue;
      (std::string_view(name) == "drive_log.csv" ? run.drive : run.poses) = CsvTable::load(file);
    }
    if (!run.drive && !run.poses) {
      throw UsageError(path + ": holds neither drive_log.csv nor pose_log.csv; name the folder of a run");
    }
    return run;
  }
  CsvTable table = CsvTable::load(path);
  const bool drive = table.has("cmd_left");
  if (!drive && !(table.has("x") && table.has("y") && table.has("theta"))) {
    throw config::LogError(table.name() +
                           ": is no drive log (cmd_left, cmd_right) and no pose log (x, y, theta)");
  }
  (drive ? run.drive : run.poses) = std::move(table);
  return run;
}

void for_each_tick(const RecordedRun& run, const std::function<void(const mcap::TickValues&)>& take) {
  const auto drive_times = rising_times(run.drive);
  const auto pose_times = rising_times(run.poses);
  const auto drive = run.drive ? std::make_unique<DriveRows>(*run.drive) : nullptr;
  const auto poses = run.poses ? std::make_unique<PoseRows>(*run.poses) : nullptr;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < drive_times.size() || j < pose_times.size()) {
    const double end = std::numeric_limits<double>::infinity();
    const double drive_t = i < drive_times.size() ? drive_times[i] : end;
    const double pose_t = j < pose_times.size() ? pose_times[j] : end;
    mcap::TickValues tick;
    tick.t_s = std::min(drive_t, pose_t);
    if (drive_t <= pose_t) drive->add(i++, tick);
    if (pose_t <= drive_t) poses->add(j++, tick);
    take(tick);
  }
}

std::map<std::string, std::string> metadata_of(const RecordedRun& run) {
  std::map<std::string, std::string> all;
  for (const auto* table : {&run.drive, &run.poses}) {
    if (*table) all.insert((*table)->all_metadata().begin(), (*table)->all_metadata().end());
  }
  all.erase("wheelwright_drive_log");
  all.erase("wheelwright_pose_log");
  return all;
}

}  // namespace wheelwright::tools
