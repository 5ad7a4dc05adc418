// The side of the wiring that the sensor loop calls, on its own thread: frames, events and lateness go into
// the rings, commands come out of one. Neither blocks nor allocates; what a full ring cannot take is dropped
// (wiring.hpp).
#pragma once

#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon {

class RingClient final : public roomba::LoopClient {
 public:
  explicit RingClient(Wiring& wiring) : wiring_(wiring) {}

  std::optional<Command> command_for(std::int64_t tick) override;
  void on_frame(const SensorFrame& frame) override;
  void on_event(const roomba::Event& event) override;
  void on_wake_up(std::chrono::steady_clock::time_point due, std::chrono::nanoseconds late) override;

 private:
  Wiring& wiring_;
  bool armed_ = false;
};

}  // namespace wheelwright::daemon
