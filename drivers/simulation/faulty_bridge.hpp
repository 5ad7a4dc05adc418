// A faulty cable on the wall clock: between a serial port, behind which a robot is, and a pseudo-terminal
// made for the host.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "drivers/simulation/faulty_cable.hpp"
#include "drivers/simulation/pseudo_terminal.hpp"

namespace wheelwright::simulation {

// A fault that is over, and how soon after it the robot was received again.
struct BridgeFault {
  CableFaultRecord record;
  double from_unix_s = 0.0;
  double until_unix_s = 0.0;
  // From the end of the fault until some bytes of the robot's had reached the host; nothing where the next
  // fault came first.
  std::optional<double> answered_after_s = {};
};

class FaultyBridge {
 public:
  // `robot` is an open port, raw and non-blocking, and stays the caller's. `link` is where the host finds its
  // end; it is gone while the cable is out. Throws std::runtime_error where it cannot be made.
  FaultyBridge(int robot, std::filesystem::path link, const CableFaultConfig& config);

  // Carries what there is to carry; to be called about once a millisecond. False once the robot's port is
  // gone.
  bool carry();

  // The faults that are over, in order, each of them once.
  std::optional<BridgeFault> next_finished();
  void let_be() { cable_.let_be(); }

 private:
  std::chrono::nanoseconds now() const;
  void plug(bool in);
  bool carry_to_robot(std::chrono::nanoseconds now);
  bool carry_to_host(std::chrono::nanoseconds now);
  void note_finished(std::chrono::nanoseconds now);

  int robot_;
  std::filesystem::path path_;
  FaultyCable cable_;
  std::chrono::steady_clock::time_point started_;
  double started_unix_s_;
  std::unique_ptr<PseudoTerminal> terminal_;
  std::unique_ptr<TerminalLink> link_;
  std::optional<BridgeFault> waiting_;  // over, and the robot has not been received since
  std::size_t received_bytes_ = 0;      // since then
  std::deque<BridgeFault> finished_;
};

}  // namespace wheelwright::simulation
