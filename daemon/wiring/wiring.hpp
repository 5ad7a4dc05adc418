// What the threads of the daemon share: one ring per consumer, and flags. Nobody waits for anybody.
//
//   sensor loop --frames--> predictor  --commands--> sensor loop
//               --frames--> calibrator --deliveries--> predictor --old models--> calibrator
//               --events--> log        <--entries--   predictor
//               --wake-ups--> telemetry <--entries--  predictor
//
// A full ring drops what is new and counts it; the tick numbers make the gap visible.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <semaphore>

#include <boost/lockfree/spsc_queue.hpp>

#include "daemon/wiring/thread_failure.hpp"
#include "drivers/roomba/sensor_loop.hpp"
#include "model/brain/brain.hpp"
#include "model/brain/calibrator.hpp"

namespace wheelwright::daemon {

template <typename Item, std::size_t size>
using Ring = boost::lockfree::spsc_queue<Item, boost::lockfree::capacity<size>>;

// One tick for the logs.
struct LogEntry {
  SensorFrame frame;
  PoseRecord record;
};

// What the calibrator has for the predictor. A model is handed over with its ownership.
struct Delivery {
  std::optional<CalibrationKind> kind;  // nothing: the calibration was refused
  WheelPair metres_per_tick{};
  DrivingModel* model = nullptr;
  std::int64_t from_tick = 0;  // adaptation
  std::uint16_t version = 1;   // adaptation
};

struct WakeUp {
  std::chrono::steady_clock::time_point due;
  std::chrono::nanoseconds late{0};
};

// What the live view is fed with. Nobody misses what it loses.
struct TelemetryFeed {
  Ring<LogEntry, 256> entries;
  Ring<WakeUp, 256> wake_ups;
  std::atomic<std::uint64_t> dropped{0};

  template <typename Queue, typename Item>
  void push(Queue& queue, const Item& item) {
    if (!queue.push(item)) dropped.fetch_add(1, std::memory_order_relaxed);
  }
};

struct Wiring {
  Ring<SensorFrame, 256> frames_to_predictor;
  Ring<SensorFrame, 1024> frames_to_calibrator;  // a fit may take seconds
  Ring<Command, 64> commands;
  Ring<LogEntry, 512> entries;
  Ring<roomba::Event, 128> events;
  Ring<Delivery, 8> deliveries;
  Ring<DrivingModel*, 8> old_models;
  TelemetryFeed telemetry;
  bool has_telemetry = false;  // settled before any thread starts

  std::counting_semaphore<> frame_arrived{0};
  std::atomic<bool> ending{false};
  std::atomic<bool> robot_answers{false};       // it has answered
  std::atomic<bool> robot_is_connected{false};  // and has not been lost since
  std::atomic<bool> finished{false};            // the mission came to its end
  std::atomic<StopReason> stop{StopReason::none};
  std::atomic<std::uint64_t> dropped{0};  // items that found their ring full
  ThreadFailure failure;

  template <typename Queue, typename Item>
  void push(Queue& queue, const Item& item) {
    if (!queue.push(item)) dropped.fetch_add(1, std::memory_order_relaxed);
  }
};

}  // namespace wheelwright::daemon
