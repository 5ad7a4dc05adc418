// The robot's port as a program of its own opens it at its start.
#pragma once

#include <filesystem>

#include "drivers/serial/serial_port.hpp"

namespace wheelwright::daemon {

// Opens the port. One that is in use is tried again for a while: the guardian of a daemon that was killed a
// moment ago has it until the wheels stand. Throws StartFailure, with the cause.
serial::OpenPort open_device(const std::filesystem::path& device, int baud);

}  // namespace wheelwright::daemon
