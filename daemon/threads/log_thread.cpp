#include "daemon/threads/log_thread.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <thread>
#include <utility>

#include "config/load/atomic_file.hpp"
#include "daemon/recording/fault_text.hpp"
#include "daemon/recording/log_format.hpp"
#include "model/uncertainty/pose_uncertainty.hpp"

namespace wheelwright::daemon {
namespace {

constexpr auto write_every = std::chrono::milliseconds(50);

std::string_view title_of(Activity activity) {
  switch (activity) {
    case Activity::encoder_check:
      return "calibration: which counter is the left wheel's";
    case Activity::encoder_turn:
      return "calibration A: turning in place past the surroundings";
    case Activity::left_on:
      return "calibration B: response of each wheel";
    case Activity::random_drive:
      return "calibration C: random drive";
    case Activity::route:
      return "route: driving";
    case Activity::commanded_drive:
      return "commands: driving";
    case Activity::finished:
      return "finished";
    case Activity::stopped:
      return "stopped";
    default:
      return "";
  }
}

}  // namespace

LogThread::LogThread(const config::DaemonConfig& config, std::filesystem::path folder,
                     const WheelPair& metres_per_tick, Wiring& wiring, StatusBoard& board)
    : config_(config),
      folder_(std::move(folder)),
      metres_per_tick_(metres_per_tick),
      wiring_(wiring),
      board_(board) {
  recorder_.reserve(recorder_ticks);
}

void LogThread::run() {
  for (GrowingFile* file : {&drive_log_, &pose_log_}) {
    const bool drive = file == &drive_log_;
    const auto path = folder_ / (drive ? "drive_log.csv" : "pose_log.csv");
    if (file->create(path, drive ? drive_log_head(config_, metres_per_tick_) : pose_log_head(config_))) {
      report_.files.push_back(path);
    }
  }
  if (config_.mcap_log) {
    mcap_log_.emplace(config_, folder_ / "run.mcap");
    if (mcap_log_->file().is_open()) report_.files.push_back(mcap_log_->file().path());
  }
  note_file_errors();
  while (!wiring_.ending.load(std::memory_order_relaxed)) {
    drain();
    std::this_thread::sleep_for(write_every);
  }
  drain();
  finish();
}

void LogThread::drain() {
  roomba::Event event;
  while (wiring_.events.pop(event)) tell(event);
  LogEntry entry;
  bool any = false;
  for (; wiring_.entries.pop(entry); any = true) take(entry);
  if (any) board_.put(entry);
  const auto now = std::chrono::steady_clock::now();
  drive_log_.flush(now);
  pose_log_.flush(now);
  if (mcap_log_) mcap_log_->flush(now);
  note_file_errors();
}

void LogThread::take(const LogEntry& entry) {
  if (recorder_.size() < recorder_ticks) {
    recorder_.push_back(entry);
  } else {
    recorder_[recorder_next_] = entry;
  }
  recorder_next_ = (recorder_next_ + 1) % recorder_ticks;
  note_activity(entry);
  run_has_begun_ = run_has_begun_ || entry.frame.armed;
  if (run_has_begun_ && is_logged(entry)) {
    drive_log_.add_line(drive_log_line(entry));
    pose_log_.add_line(pose_log_line(entry, config_.limits.wheel_base_m));
    if (mcap_log_) mcap_log_->take(entry);
    ++report_.logged_ticks;
    note_faults(entry.record);
  }
  const Activity activity = entry.frame.command.activity;
  if (activity == Activity::route || activity == Activity::commanded_drive) {
    report_.last_driven_record = entry.record;
    note_disagreement(entry.record);
  }
  if (entry.frame.stop != last_stop_) {
    last_stop_ = entry.frame.stop;
    if (last_stop_ != StopReason::none && last_stop_ != StopReason::requested)
      write_flight_recorder(last_stop_);
  }
}

void LogThread::note_activity(const LogEntry& entry) {
  const Activity activity = entry.frame.command.activity;
  if (activity == last_activity_) return;
  const bool repeats = activity == Activity::left_on && entry.frame.command.repetition > 0;
  if (const auto title = title_of(activity); !title.empty() && !repeats) spdlog::info("{}", title);
  last_activity_ = activity;
}

// From encoders nobody can tell which of both is wrong; that one of them is, can be said. Of a model that is
// due for a calibration it has been.
void LogThread::note_disagreement(const PoseRecord& record) {
  constexpr double lasting_s = 2.0;
  if (!record.hybrid || !record.has_prediction || record.predicted_covariance.trace() <= 0.0) return;
  const HybridOutput& filter = *record.hybrid;
  const bool apart =
      !filter.recalibration_due &&
      exclude_each_other(record.predicted, record.predicted_covariance, filter.pose, filter.covariance);
  apart_ticks_ = apart ? apart_ticks_ + 1 : 0;
  if (!apart || apart_ticks_ * config_.link.period_s < lasting_s) return report_.apart_m.reset();
  const bool is_known = report_.apart_m.has_value();
  report_.apart_m = distance_between_m(record.predicted, filter.pose);
  if (is_known) return;
  spdlog::warn(
      "{:.2f} s: model and encoders put the robot {:.2f} m apart, which is more than both may err: a wheel "
      "or an "
      "encoder is not as it was when calibrated; look at them, then calibrate again",
      record.t_s, *report_.apart_m);
}

void LogThread::note_faults(const PoseRecord& record) {
  if (!record.hybrid) return;
  for (const FaultEvent& event : record.hybrid->events) {
    const bool began = event.stage == FaultEvent::Stage::began;
    report_.faults += began ? 1 : 0;
    // What is known at once is named in the same tick.
    if (began && event.kind != FaultKind::misfit) continue;
    spdlog::warn("{:.2f} s: {}", record.t_s, sentence_of(event));
  }
  if (record.hybrid->raised_recalibration) {
    spdlog::warn(
        "{:.2f} s: both wheels need other currents or move otherwise than the model says, for good: "
        "calibrate again",
        record.t_s);
  }
  report_.recalibration_due = record.hybrid->recalibration_due;
}

void LogThread::tell(const roomba::Event& event) {
  using roomba::EventCode;
  switch (event.code) {  // all of them, so that the compiler names one that is forgotten
    case EventCode::port_opened:
    case EventCode::robot_answers:
    case EventCode::link_lost:
    case EventCode::robot_text:
    case EventCode::checksum_rule:
    case EventCode::counts_stuck:
    case EventCode::stream_period:
      return tell_of_link(event);
    case EventCode::armed:
    case EventCode::arm_refused:
    case EventCode::arm_needless:
    case EventCode::stopped:
    case EventCode::overrun:
    case EventCode::moves_unarmed:
      return tell_of_drive(event);
  }
}

void LogThread::tell_of_link(const roomba::Event& event) {
  using roomba::EventCode;
  switch (event.code) {
    case EventCode::port_opened:
      return spdlog::info("{} is open again", config_.device.string());
    case EventCode::robot_answers:
      return spdlog::info("the robot answers, battery at {:.1f} V", event.value);
    case EventCode::link_lost:
      return spdlog::error("the robot does not answer any more");
    case EventCode::robot_text:
      return spdlog::info("the robot prints: {}", event.text.data());
    case EventCode::checksum_rule:
      return spdlog::info(
          "stream checksum: the header byte is {}",
          static_cast<int>(event.value) == static_cast<int>(open_interface::ChecksumRule::header_included)
              ? "included"
              : "not included");
    case EventCode::counts_stuck:
      return spdlog::error(
          "the serial adapter damages every byte: bits {:#04x} of the encoder counts never change; use "
          "another adapter, and see wheelwright doctor",
          static_cast<unsigned>(event.value));
    case EventCode::stream_period:
      spdlog::info("the robot streams every {:.3f} ms", 1e3 * event.value);
      if (std::abs(event.value / config_.link.period_s - 1.0) > 0.01)
        spdlog::warn("link.period_s is {:.3f} ms: set it to {:.6f}", 1e3 * config_.link.period_s,
                     event.value);
      return;
    default:
      return;
  }
}

void LogThread::tell_of_drive(const roomba::Event& event) {
  using roomba::EventCode;
  switch (event.code) {
    case EventCode::armed:
      return spdlog::info("armed: the robot obeys");
    case EventCode::arm_refused:
      return spdlog::warn("not armed: the robot does not answer; arm it once it does");
    case EventCode::arm_needless:
      return spdlog::info("armed already: the robot drives on");
    case EventCode::stopped:
      return spdlog::warn("stopped at {:.2f} s: {}", event.t_s,
                          name_of(static_cast<StopReason>(static_cast<int>(event.value))));
    case EventCode::overrun:
      return spdlog::warn("the loop woke up {:.0f} periods late", event.value);
    case EventCode::moves_unarmed:
      return spdlog::warn(
          "the robot moves at {:.2f} s though it is not armed: it cleans by itself, is pushed, or obeys "
          "another program; press its Clean button or end that program",
          event.t_s);
    default:
      return;
  }
}

void LogThread::note_file_errors() {
  const GrowingFile* mcap_file = mcap_log_ ? &mcap_log_->file() : nullptr;
  for (const GrowingFile* file : std::array<const GrowingFile*, 3>{&drive_log_, &pose_log_, mcap_file}) {
    if (file == nullptr || !file->error()) continue;
    if (std::find(report_.errors.begin(), report_.errors.end(), *file->error()) != report_.errors.end())
      continue;
    report_.errors.push_back(*file->error());
    spdlog::error("{}", *file->error());
  }
}

// What led to a stop, from memory: complete even where the log is not.
void LogThread::write_flight_recorder(StopReason reason) {
  std::string text =
      "# stopped: " + std::string(name_of(reason)) + "\n" + drive_log_head(config_, metres_per_tick_);
  const std::size_t first = recorder_.size() < recorder_ticks ? 0 : recorder_next_;
  for (std::size_t i = 0; i < recorder_.size(); ++i) {
    text += drive_log_line(recorder_[(first + i) % recorder_.size()]) + "\n";
  }
  const auto path = folder_ / "flight_recorder.csv";
  if (const auto error = config::write_file_atomically(path, text)) {
    spdlog::error("{}", *error);
    report_.errors.push_back(*error);
    return;
  }
  report_.files.push_back(path);
  spdlog::info("the last {} ticks are in {}", recorder_.size(), path.string());
}

void LogThread::finish() {
  drive_log_.close();
  pose_log_.close();
  if (mcap_log_) report_.lost_messages = mcap_log_->close();
  note_file_errors();
  report_.lost_lines = drive_log_.lost_lines() + pose_log_.lost_lines();
}

}  // namespace wheelwright::daemon
