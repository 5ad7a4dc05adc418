#include "daemon/threads/calibrator_thread.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "config/load/model_file.hpp"
#include "config/load/utc_now.hpp"
#include "daemon/recording/calibration_remarks.hpp"

namespace wheelwright::daemon {
namespace {

constexpr auto look_every = std::chrono::milliseconds(20);

}  // namespace

CalibratorThread::CalibratorThread(const config::DaemonConfig& config, const Plan& plan,
                                   std::filesystem::path folder, roomba::SensorLoop& sensor_loop,
                                   Wiring& wiring)
    : config_(config),
      mission_(plan.mission),
      folder_(std::move(folder)),
      calibrator_(plan.mission, config.limits, plan.model),
      sensor_loop_(sensor_loop),
      wiring_(wiring) {}

void CalibratorThread::run() {
  while (!wiring_.ending.load(std::memory_order_relaxed)) {
    SensorFrame frame;
    while (wiring_.frames_to_calibrator.pop(frame)) {
      if (auto outcome = calibrator_.take(frame)) deliver(*outcome);
    }
    DrivingModel* old = nullptr;
    while (wiring_.old_models.pop(old)) delete old;
    std::this_thread::sleep_for(look_every);
  }
}

void CalibratorThread::deliver(CalibrationOutcome& outcome) {
  if (outcome.refusal) {
    spdlog::error("calibration refused: {}", outcome.refusal->reason);
    report_.refusal = outcome.refusal->reason;
    sensor_loop_.request_stop(StopReason::refused);
    wiring_.push(wiring_.deliveries, Delivery{});
    return;
  }
  if (outcome.route_refusal) {
    spdlog::error("{}", outcome.route_refusal->reason);
    report_.route_refusal = outcome.route_refusal->reason;
    sensor_loop_.request_stop(StopReason::refused);
    wiring_.push(wiring_.deliveries, Delivery{});
  }
  if (outcome.remark) {
    spdlog::warn("{}", *outcome.remark);
    report_.late_readings = outcome.remark;
  }
  switch (outcome.kind) {
    case CalibrationKind::encoder_order:
      deliver_encoder_order(outcome.encoders_swapped);
      break;
    case CalibrationKind::encoder_scale: {
      const EncoderScaleFit& fit = *outcome.encoder_scale;
      spdlog::info("encoder scale: {:.4f} mm per tick, one turn is {:.1f} ticks +- {:.2f} %",
                   1e3 * fit.metres_per_tick.left, fit.ticks_per_turn, 100.0 * fit.relative_standard_error);
      note(remark_on_scale(fit, config_));
      wiring_.push(wiring_.deliveries,
                   Delivery{.kind = outcome.kind, .metres_per_tick = fit.metres_per_tick});
      report_.encoder_scale = std::move(outcome.encoder_scale);
      break;
    }
    case CalibrationKind::response:
      deliver_response(outcome);
      break;
    case CalibrationKind::arma:
      deliver_arma(outcome);
      break;
    case CalibrationKind::adaptation:
      deliver_adaptation(outcome);
      break;
  }
}

void CalibratorThread::deliver_encoder_order(bool swapped) {
  report_.encoders_swapped = swapped;
  if (swapped && !config_.detect_encoder_order) {
    const std::string reason =
        "the left wheel moved, but the counter configured as the right one did; set link.encoder_order to "
        "auto";
    CalibrationOutcome refused;
    refused.refusal = Refusal{reason};
    deliver(refused);
    return;
  }
  if (swapped) {
    const bool left_first = config_.link.encoder_order == roomba::EncoderOrder::left_is_43;
    sensor_loop_.request_encoder_order(left_first ? roomba::EncoderOrder::right_is_43
                                                  : roomba::EncoderOrder::left_is_43);
  }
  spdlog::info("encoder order: packet {} is the left wheel", swapped ? "44" : "43");
  wiring_.push(wiring_.deliveries, Delivery{.kind = CalibrationKind::encoder_order});
}

void CalibratorThread::deliver_response(CalibrationOutcome& outcome) {
  const FirFit& fit = *outcome.response;
  spdlog::info("response: {} periods long, gain {:.3f} / {:.3f} (left / right), readings differ by {:.2f} mm",
               fit.model.left.from_left.size(), fit.left.gain.from_left, fit.right.gain.from_right,
               1e3 * fit.left.position_noise_m);
  // Where a random drive follows, this model only steers it.
  if (!mission_.random_drive) {
    note(remark_on_wheels(*outcome.model));
    keep_model(*outcome.model);
  }
  hand_over({.kind = outcome.kind}, *outcome.model);
}

void CalibratorThread::deliver_arma(CalibrationOutcome& outcome) {
  const ArmaFit& fit = *outcome.arma;
  spdlog::info("arma: order {}, gain {:.3f} / {:.3f} (left / right), free run {:.1f} mm off the encoders",
               fit.model.left.from_own_past.size(), fit.left.quality.gain.from_left,
               fit.right.quality.gain.from_right, 1e3 * fit.free_run_distance_rms_m);
  note(remark_on_wheels(*outcome.model));
  keep_model(*outcome.model);
  hand_over({.kind = outcome.kind}, *outcome.model);
}

void CalibratorThread::note(std::optional<std::string> remark) {
  if (!remark) return;
  spdlog::warn("{}", *remark);
  report_.remarks.push_back(*std::move(remark));
}

void CalibratorThread::deliver_adaptation(CalibrationOutcome& outcome) {
  const AdaptedModel& adapted = *outcome.adapted;
  RobotModel& model = *outcome.model;
  model.robot = config_.robot_name;
  model.created = config::utc_now();
  model.source.push_back(fmt::format(
      "adapted while driving, run {}, version {}: recalibration was due; over 2 s its free run is {:.1f} mm "
      "off the encoders, that of the model before it {:.1f} mm",
      folder_.filename().string(), adapted.version, 1e3 * adapted.error_m, 1e3 * adapted.error_before_m));
  const auto path = folder_ / fmt::format("model-{}.yaml", adapted.version);
  write_model(model, path);
  spdlog::info(
      "a better model from now on: over 2 s its free run is {:.1f} mm off the encoders instead of "
      "{:.1f} mm; {}",
      1e3 * adapted.error_m, 1e3 * adapted.error_before_m, path.string());
  report_.adapted.push_back(path);
  hand_over({.kind = outcome.kind, .from_tick = adapted.from_tick, .version = adapted.version}, model);
}

void CalibratorThread::keep_model(RobotModel model) {
  model.robot = config_.robot_name;
  model.created = config::utc_now();
  // Whatever becomes of the file elsewhere, the run's folder keeps what it calibrated.
  write_model(model, folder_ / "calibrated_model.yaml");
  write_model(model, config_.model_file);
  report_.model = std::move(model);
}

void CalibratorThread::write_model(const RobotModel& model, const std::filesystem::path& path) {
  try {
    config::save_model(model, path);
  } catch (const std::exception& error) {
    spdlog::error("the model could not be written: {}", error.what());
    report_.file_error = error.what();
  }
}

// With its ownership: Delivery has to be copied into the ring.
void CalibratorThread::hand_over(Delivery delivery, const RobotModel& model) {
  auto driving = std::make_unique<DrivingModel>(model);
  delivery.model = driving.get();
  if (wiring_.deliveries.push(delivery)) {
    static_cast<void>(driving.release());
  } else {
    wiring_.dropped.fetch_add(1, std::memory_order_relaxed);
  }
}

}  // namespace wheelwright::daemon
