// Puts the wheels of a robot to rest on a port, without the link: where the daemon is gone or hangs.
//
// Calls only what a signal handler may call, so that a process that was forked with threads can use it. The
// port does not block.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>

#include "drivers/open_interface/commands.hpp"

namespace wheelwright::roomba {

// An order that the line garbles is not the last one: it is written so often, so far apart.
inline constexpr int rest_orders = 3;
inline constexpr std::chrono::milliseconds rest_order_period{40};

// Writes all of it, as far as the port takes it within 20 ms.
void write_whole(int port, std::span<const std::uint8_t> bytes);

// Writes the orders of rest_bytes(), waits until the wheels stand (longest_braking_s), and sends the robot to
// Passive.
void rest_and_leave(int port, const open_interface::CommandBytes& rest);

}  // namespace wheelwright::roomba
