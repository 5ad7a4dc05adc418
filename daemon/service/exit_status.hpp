// How the daemon ends, as a number.
//
// By hand: 0 done, 1 the run did not reach its end, 2 bad usage, configuration or input, as every program of
// the project. As a service (--service) the causes are told apart, with the numbers of sysexits.h, so that
// the service manager knows which of them another try can cure.
#pragma once

#include <stdexcept>
#include <string>

namespace wheelwright::daemon {

enum class EndCause {
  done,
  asked,          // ended by a signal, before the run was over
  run_stopped,    // a bump, a cliff, a refused calibration: a person has to look
  usage,          // of the command line
  configuration,  // configuration, route or model file
  no_permission,  // for the device, or for what real_time.policy 'require' wants
  no_device,
  device_in_use,
  robot_silent,  // it does not answer, or fell silent in mid-run
  files_lost,    // the run is over, but not all of its files could be written
  internal,      // of the daemon: a fault of its own, or of the system below it
};

constexpr int exit_status(EndCause cause, bool as_service) {
  switch (cause) {
    case EndCause::done:
      return 0;
    case EndCause::asked:
      return as_service ? 0 : 1;
    case EndCause::run_stopped:
      return 1;
    case EndCause::usage:
      return as_service ? 64 : 2;
    case EndCause::configuration:
      return as_service ? 78 : 2;
    case EndCause::no_permission:
      return as_service ? 77 : 2;
    case EndCause::no_device:
      return as_service ? 69 : 2;
    case EndCause::device_in_use:
      return as_service ? 75 : 2;
    case EndCause::robot_silent:
      return as_service ? 76 : 1;
    case EndCause::files_lost:
      return as_service ? 74 : 1;
    case EndCause::internal:
      return as_service ? 70 : 1;
  }
  return 1;
}

// The daemon cannot start; what() is one line for a person.
class StartFailure : public std::runtime_error {
 public:
  StartFailure(EndCause cause, const std::string& what) : std::runtime_error(what), cause_(cause) {}
  EndCause cause() const { return cause_; }

 private:
  EndCause cause_;
};

}  // namespace wheelwright::daemon
