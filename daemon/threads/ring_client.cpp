#include "daemon/threads/ring_client.hpp"

namespace wheelwright::daemon {

std::optional<Command> RingClient::command_for(std::int64_t tick) {
  auto& commands = wiring_.commands;
  // What was planned before the robot was armed belongs to a run that is over.
  while (commands.read_available() > 0 && (!armed_ || commands.front().tick < tick)) commands.pop();
  if (commands.read_available() == 0 || commands.front().tick != tick) return std::nullopt;
  const Command command = commands.front();
  commands.pop();
  return command;
}

void RingClient::on_frame(const SensorFrame& frame) {
  armed_ = frame.armed;
  wiring_.push(wiring_.frames_to_predictor, frame);
  wiring_.push(wiring_.frames_to_calibrator, frame);
  wiring_.frame_arrived.release();
}

void RingClient::on_event(const roomba::Event& event) {
  if (event.code == roomba::EventCode::robot_answers) {
    wiring_.robot_answers.store(true, std::memory_order_relaxed);
    wiring_.robot_is_connected.store(true, std::memory_order_relaxed);
  } else if (event.code == roomba::EventCode::link_lost) {
    wiring_.robot_is_connected.store(false, std::memory_order_relaxed);
  }
  wiring_.push(wiring_.events, event);
}

void RingClient::on_wake_up(std::chrono::steady_clock::time_point due, std::chrono::nanoseconds late) {
  if (!wiring_.has_telemetry) return;
  wiring_.telemetry.push(wiring_.telemetry.wake_ups, WakeUp{due, late});
}

}  // namespace wheelwright::daemon
