// The table at the end of a run: what came out, with units, and where the files are.
#pragma once

#include <string>

#include "config/load/daemon_config.hpp"
#include "daemon/supervisor.hpp"
#include "daemon/threads/calibrator_thread.hpp"
#include "daemon/threads/log_thread.hpp"
#include "daemon/threads/real_time_setup.hpp"

namespace wheelwright::daemon {

std::string summary(const config::DaemonConfig& config, const RunOutcome& outcome,
                    const CalibrationReport& calibration, const LogReport& log,
                    const roomba::SensorLoop& sensor_loop, const RealTimeStatus& real_time,
                    std::uint64_t dropped);

// How a route came out, in half a sentence: for who watches. Empty where none was driven.
std::string route_in_words(const config::DaemonConfig& config, const LogReport& log);

}  // namespace wheelwright::daemon
