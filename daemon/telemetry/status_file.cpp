#include "daemon/telemetry/status_file.hpp"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "config/load/output_file.hpp"
#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "config/load/utc_now.hpp"
#include "daemon/threads/calibrator_thread.hpp"

namespace wheelwright::daemon {
namespace {

struct KnownPose {
  Pose pose;
  std::string_view by;
};

// The pose that the run is about: by the source that steers, as far as it has one yet.
std::optional<KnownPose> pose_of(const StatusView& view) {
  if (!view.latest) return std::nullopt;
  const PoseRecord& record = view.latest->record;
  if (view.config.pose_source == PoseSource::hybrid && record.hybrid) {
    return KnownPose{record.hybrid->pose, "hybrid"};
  }
  if (is_sensorless(view.config.pose_source) && record.has_prediction) {
    return KnownPose{record.predicted, "model"};
  }
  return KnownPose{record.odometry, "odometry"};
}

double microseconds(std::chrono::nanoseconds time) {
  return 1e-3 * static_cast<double>(time.count());
}

nlohmann::json lateness_json(const roomba::LatenessHistogram& lateness) {
  nlohmann::json histogram = nlohmann::json::array();
  for (const auto& step : coarse(lateness)) {
    histogram.push_back({microseconds(step.upper_edge), step.count});
  }
  return {{"p50", microseconds(lateness.quantile(0.5))},
          {"p99", microseconds(lateness.quantile(0.99))},
          {"p999", microseconds(lateness.quantile(0.999))},
          {"largest", microseconds(lateness.largest())},
          {"histogram", histogram}};
}

nlohmann::json loop_json(const StatusView& view) {
  const roomba::LoopCounts counts = view.sensor_loop.counts();
  return {{"system", describe(view.real_time)},
          {"period_s", view.config.link.period_s},
          {"ticks", counts.ticks},
          {"overruns", counts.overruns},
          {"skipped_periods", counts.skipped_periods},
          {"commands_late", counts.commands_late},
          {"readings_sound", counts.sound_readings},
          {"lateness_us", lateness_json(view.sensor_loop.lateness())}};
}

}  // namespace

std::string phase_of(const StatusView& view) {
  if (!view.robot_answers) return "waiting for the robot on " + view.config.device.string();
  if (!view.latest) return "starting";
  const SensorFrame& frame = view.latest->frame;
  if (frame.stop != StopReason::none) return "stopped: " + std::string(name_of(frame.stop));
  if (!frame.armed) return "standing, not armed";
  return std::string(name_of(frame.command.activity));
}

std::string status_line(const StatusView& view) {
  std::string line = phase_of(view);
  const auto known = view.robot_answers ? pose_of(view) : std::nullopt;
  if (!known) return line;
  line += fmt::format("; pose {:.2f} m, {:.2f} m, {:.0f} deg by {}", known->pose.x_m, known->pose.y_m,
                      known->pose.theta_rad * 180.0 / M_PI, known->by);
  line += fmt::format("; battery {:.1f} V", view.latest->frame.battery_v);
  const roomba::LoopCounts counts = view.sensor_loop.counts();
  return line + fmt::format("; {} overruns, worst wake-up {:.0f} us late", counts.overruns,
                            microseconds(view.sensor_loop.lateness().largest()));
}

std::string status_json(const StatusView& view) {
  nlohmann::json status = {{"wheelwright_status", 1},
                           {"time", config::utc_now()},
                           {"pid", ::getpid()},
                           {"robot", view.config.robot_name},
                           {"device", view.config.device.string()},
                           {"phase", phase_of(view)},
                           {"run_folder", view.run_folder.string()},
                           {"loop", loop_json(view)}};
  status["watch"] = view.watch.empty() ? nlohmann::json() : nlohmann::json(view.watch);
  if (view.latest) {
    const SensorFrame& frame = view.latest->frame;
    status["stop"] = frame.stop == StopReason::none ? nullptr : nlohmann::json(name_of(frame.stop));
    status["armed"] = frame.armed;
    status["battery_v"] = frame.valid ? nlohmann::json(frame.battery_v) : nullptr;
    status["model_version"] = view.latest->record.model_version;
  }
  if (const auto known = pose_of(view)) {
    status["pose"] = {{"x_m", known->pose.x_m},
                      {"y_m", known->pose.y_m},
                      {"theta_rad", known->pose.theta_rad},
                      {"by", known->by}};
  }
  return config::printable_json(status.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)) + "\n";
}

void remove_own_status(const std::filesystem::path& file) {
  if (file.empty()) return;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) return;
  const auto text = config::read_text(file, config::record_file);
  if (!text || !config::is_of_kind(config::OutputKind::status, *text)) return;
  const auto status = nlohmann::json::parse(*text, nullptr, false);
  if (status.is_discarded() || status.value("pid", 0) != ::getpid()) return;
  std::filesystem::remove(file, ignored);
}

}  // namespace wheelwright::daemon
