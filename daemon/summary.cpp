#include "daemon/summary.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "config/load/printable_text.hpp"
#include "model/uncertainty/pose_uncertainty.hpp"

namespace wheelwright::daemon {
namespace {

class Table {
 public:
  void title(const std::string& text) { lines_ += "\n" + config::printable(text) + "\n"; }

  template <typename... Args>
  void row(const std::string& name, fmt::format_string<Args...> format, Args&&... args) {
    lines_ += fmt::format("  {:<28}{}\n", name,
                          config::printable(fmt::format(format, std::forward<Args>(args)...)));
  }

  const std::string& text() const { return lines_; }

 private:
  std::string lines_;
};

double microseconds(std::chrono::nanoseconds duration) {
  return 1e-3 * static_cast<double>(duration.count());
}

void add_calibration(Table& table, const CalibrationReport& calibration) {
  if (!calibration.encoder_scale && !calibration.model) return;
  table.title("Calibration");
  if (const auto& scale = calibration.encoder_scale) {
    table.row("metres per tick", "{:.4f} mm  +- {:.2f} %, mean of both wheels",
              1e3 * scale->metres_per_tick.left, 100.0 * scale->relative_standard_error);
    table.row("one full turn", "{:.1f} ticks of each wheel, on average", scale->ticks_per_turn);
    table.row("repetition of the signal", "{:.3f} of 1, over {:.1f} turns", scale->correlation, scale->turns);
    if (scale->drift)
      table.row("turning one way and back",
                "differ by {:.2f} %; the mean is taken, so that sliding on a slope cancels",
                200.0 * std::abs(*scale->drift));
  }
  if (const auto& model = calibration.model) {
    const std::size_t length = model->linear_part.left.from_left.size();
    if (model->linear_part.type == ModelType::arma) {
      table.row("order", "{}, largest pole {:.3f}", model->linear_part.left.from_own_past.size(),
                std::max(largest_pole(model->linear_part.left), largest_pole(model->linear_part.right)));
    } else {
      table.row("response", "{} periods, {:.0f} ms", length,
                1e3 * static_cast<double>(length) * model->linear_part.period_s);
    }
    table.row("gain, left wheel", "{:.4f} +- {:.4f}", model->left_fit->gain.from_left,
              model->left_fit->gain_standard_error.from_left);
    table.row("gain, right wheel", "{:.4f} +- {:.4f}", model->right_fit->gain.from_right,
              model->right_fit->gain_standard_error.from_right);
    if (calibration.late_readings) table.row("machine was late", "{}", *calibration.late_readings);
    table.row("reading against model", "{:.2f} mm", 1e3 * model->left_fit->position_noise_m);
  }
}

std::string steered_by(PoseSource source) {
  if (is_sensorless(source)) return "the model alone (" + std::string(name_of(source)) + ")";
  return source == PoseSource::hybrid ? "encoders filtered against the model" : "odometry";
}

void add_faults(Table& table, const CalibrationReport& calibration, const LogReport& log) {
  if (log.faults > 0) table.row("wheel and encoder faults", "{}", log.faults);
  if (log.apart_m)
    table.row(
        "model against encoders",
        "{:.3f} m apart at the end, more than both may err: a wheel or an encoder is not as it was when "
        "calibrated",
        *log.apart_m);
  if (!calibration.adapted.empty()) {
    table.row("models adapted", "{}", calibration.adapted.size());
  }
  if (log.recalibration_due) table.row("recalibration", "{}", "due: the model does not fit any more");
}

// Who steers by a pose brings just that pose to where it is wanted; another one says how well.
bool is_small_by_construction(PoseSource by, PoseSource steered) {
  return by == steered || (is_sensorless(by) && is_sensorless(steered));
}

// How far the robot may truly be from where the filter has it.
std::string doubt_of_filter(const HybridOutput& hybrid) {
  return fmt::format("+- {:.3f} m (95 %)", position_radius95_m(hybrid.covariance));
}

void add_route(Table& table, const config::DaemonConfig& config, const LogReport& log) {
  if (!config.route || !log.last_driven_record) return;
  const PoseRecord& last = *log.last_driven_record;
  table.title("Route '" + config.route->name + "', steered by " + steered_by(config.pose_source));
  table.row("checkpoints visited", "{} of {}", last.visited, config.route->checkpoints.size());
  if (is_sensorless(config.pose_source) && last.has_prediction && last.predicted_covariance.trace() > 0.0) {
    table.row("uncertainty of the end", "{:.3f} m ({})", position_radius95_m(last.predicted_covariance),
              log.recalibration_due ? "of a model that fits: this one does not any more"
                                    : "95 % of drives end within it of the prediction");
  }
  if (config.pose_source == PoseSource::hybrid && last.hybrid) {
    table.row("uncertainty of the end", "{:.3f} m (95 % of drives end within it of the filter's pose)",
              position_radius95_m(last.hybrid->covariance));
  }
  if (!is_closed(*config.route)) return;
  const auto closure = [&](const std::string& by, PoseSource source, const Pose& pose,
                           const std::string& measured) {
    table.row("loop closure by " + by, "{:.4f} m{}", std::hypot(pose.x_m, pose.y_m),
              is_small_by_construction(source, config.pose_source)
                  ? "  (small by construction: the robot was steered by it)"
                  : measured);
  };
  if (last.has_prediction) closure("the model", PoseSource::arma, last.predicted, "");
  if (last.hybrid)
    closure("the filter", PoseSource::hybrid, last.hybrid->pose,
            "  " + doubt_of_filter(*last.hybrid) + ", measured by encoders and model");
  closure("odometry", PoseSource::odometry, last.odometry, last.hybrid ? "" : "  (measured by encoders)");
  if (!is_sensorless(config.pose_source)) {
    table.row("", "{}", "how far the robot truly ended from its start, only a tape measure says");
  }
}

void add_commanded_drive(Table& table, const config::DaemonConfig& config, const LogReport& log) {
  if (!config.commanded_drive || !log.last_driven_record) return;
  const PoseRecord& last = *log.last_driven_record;
  table.title("Commands of '" + config.commanded_drive->name + "', as given");
  const auto end = [&](const std::string& by, const Pose& pose) {
    table.row("end by " + by, "x {:.3f} m, y {:.3f} m, heading {:.1f} deg", pose.x_m, pose.y_m,
              pose.theta_rad * 180.0 / std::numbers::pi);
  };
  table.row("duration", "{:.1f} s", config.commanded_drive->duration_s);
  if (last.has_prediction) end("the model", last.predicted);
  if (last.hybrid) end("the filter", last.hybrid->pose);
  end("odometry", last.odometry);
}

void add_loop(Table& table, const config::DaemonConfig& config, const roomba::SensorLoop& sensor_loop,
              const RealTimeStatus& real_time, std::uint64_t dropped) {
  const auto& lateness = sensor_loop.lateness();
  const roomba::LoopCounts counts = sensor_loop.counts();
  table.title("Sensor loop");
  table.row("system", "{}", describe(real_time));
  table.row("ticks of " + fmt::format("{:g} ms", 1e3 * config.link.period_s), "{}", counts.ticks);
  table.row("wake-up lateness p50", "{:.0f} us", microseconds(lateness.quantile(0.5)));
  table.row("wake-up lateness p99", "{:.0f} us", microseconds(lateness.quantile(0.99)));
  table.row("wake-up lateness, largest", "{:.0f} us", microseconds(lateness.largest()));
  for (const auto& step : coarse(lateness)) {
    table.row(fmt::format("  up to {:.1f} us", microseconds(step.upper_edge)), "{}", step.count);
  }
  table.row("periods skipped", "{} in {} overruns", counts.skipped_periods, counts.overruns);
  table.row("commands late", "{}", counts.commands_late);
  if (config.link.transport == roomba::Transport::query) {
    const auto& replies = sensor_loop.link().reply_counts();
    table.row("replies", "{} of {} sound, {} missing, {} incomplete, {} garbled", replies.sound,
              replies.asked, replies.missing, replies.incomplete, replies.garbled);
  } else {
    const auto& stream = sensor_loop.link().stream_counts();
    table.row("stream frames", "{} sound, {} corrupt", stream.frames, stream.corrupt);
  }
  if (sensor_loop.link().counts().implausible > 0) {
    table.row("implausible counts", "{}", sensor_loop.link().counts().implausible);
  }
  if (dropped > 0) table.row("dropped for a full ring", "{}", dropped);
}

void add_files(Table& table, const config::DaemonConfig& config, const CalibrationReport& calibration,
               const LogReport& log) {
  table.title("Files");
  if (calibration.model && !calibration.file_error) table.row("model", "{}", config.model_file.string());
  for (const auto& file : calibration.adapted) table.row("adapted model", "{}", file.string());
  for (const auto& file : log.files)
    table.row(file.extension() == ".csv" ? file.stem().string() : file.filename().string(), "{}",
              file.string());
  for (const auto& error : log.errors) table.row("not written", "{}", error);
  if (log.lost_messages > 0) table.row("messages lost", "{}", log.lost_messages);
  if (log.lost_lines > 0) table.row("lines lost", "{}", log.lost_lines);
}

}  // namespace

std::string route_in_words(const config::DaemonConfig& config, const LogReport& log) {
  if (!config.route || !log.last_driven_record) return "";
  const PoseRecord& last = *log.last_driven_record;
  std::string text =
      fmt::format("{} of {} checkpoints visited", last.visited, config.route->checkpoints.size());
  if (!is_closed(*config.route)) return text;
  const Pose& end = last.hybrid ? last.hybrid->pose : last.odometry;
  return text + fmt::format(", and the robot ended {:.3f} m{} from its start by {}",
                            std::hypot(end.x_m, end.y_m),
                            last.hybrid ? " " + doubt_of_filter(*last.hybrid) : "",
                            last.hybrid ? "the filter" : "odometry");
}

std::string summary(const config::DaemonConfig& config, const RunOutcome& outcome,
                    const CalibrationReport& calibration, const LogReport& log,
                    const roomba::SensorLoop& sensor_loop, const RealTimeStatus& real_time,
                    std::uint64_t dropped) {
  Table table;
  table.title(outcome.finished() ? "Result: finished" : "Result: stopped, " + outcome.stopped);
  if (calibration.refusal) table.row("calibration refused", "{}", *calibration.refusal);
  if (calibration.route_refusal) table.row("route refused", "{}", *calibration.route_refusal);
  for (const std::string& remark : calibration.remarks) table.row("look at", "{}", remark);
  add_calibration(table, calibration);
  add_route(table, config, log);
  add_commanded_drive(table, config, log);
  add_faults(table, calibration, log);
  add_loop(table, config, sensor_loop, real_time, dropped);
  add_files(table, config, calibration, log);
  return table.text();
}

}  // namespace wheelwright::daemon
