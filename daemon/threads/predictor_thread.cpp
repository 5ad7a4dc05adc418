#include "daemon/threads/predictor_thread.hpp"

#include <utility>

namespace wheelwright::daemon {
namespace {

void accept_deliveries(Brain& brain, Wiring& wiring) {
  Delivery delivery;
  while (wiring.deliveries.pop(delivery)) {
    if (!delivery.kind) {
      brain.refuse();
      continue;
    }
    switch (*delivery.kind) {
      case CalibrationKind::encoder_order:
        brain.accept_encoder_order();
        break;
      case CalibrationKind::encoder_scale:
        brain.accept_encoder_scale(delivery.metres_per_tick);
        break;
      case CalibrationKind::response:
      case CalibrationKind::arma:
        brain.accept_model(std::unique_ptr<DrivingModel>(delivery.model));
        break;
      case CalibrationKind::adaptation:
        brain.exchange_model(std::unique_ptr<DrivingModel>(delivery.model), delivery.from_tick,
                             delivery.version);
        break;
    }
  }
}

}  // namespace

void run_predictor(Brain& brain, Wiring& wiring, roomba::SensorLoop& sensor_loop) {
  while (!wiring.ending.load(std::memory_order_relaxed)) {
    wiring.frame_arrived.acquire();
    accept_deliveries(brain, wiring);
    LogEntry entry;
    while (wiring.frames_to_predictor.pop(entry.frame)) {
      entry.record = brain.take(entry.frame);
      if (const StopReason reason = brain.wanted_stop(); reason != StopReason::none)
        sensor_loop.request_stop(reason);
      while (const auto command = brain.next_command()) wiring.push(wiring.commands, *command);
      wiring.push(wiring.entries, entry);
      if (wiring.has_telemetry) wiring.telemetry.push(wiring.telemetry.entries, entry);
      // Freed by the thread that made it; where its ring is full it is kept for good, which is better than a
      // free here.
      if (auto retired = brain.take_retired_model()) wiring.push(wiring.old_models, retired.release());
      if (entry.frame.command.activity == Activity::finished) {
        wiring.finished.store(true, std::memory_order_relaxed);
      }
      wiring.stop.store(entry.frame.stop, std::memory_order_relaxed);
    }
  }
}

}  // namespace wheelwright::daemon
