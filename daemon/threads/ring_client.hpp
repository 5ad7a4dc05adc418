// The sensor loop's end of the wiring. Called on the loop's thread; neither blocks nor allocates.
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
