// Commands such as people send to robots when they record a log.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "model/geometry/pose.hpp"

namespace wheelwright::test {

// `mixed` holds everything that an effect can need; the others lack something, as many real logs do.
enum class Program {
  mixed,          // held random commands, routes, steps, slow ramps through zero, reversals, in random order
  forward_only,   // neither wheel ever turns backward
  straight_only,  // both wheels are given the same command
  one_speed,      // straight on at one speed
};

std::string_view name_of(Program program);
std::optional<Program> program_named(std::string_view name);

inline constexpr double largest_program_speed_m_s = 0.42;  // of a wheel

// One command per period, in m/s at the wheel; begins and ends with half a second of rest.
std::vector<WheelPair> drive_commands(Program program, double seconds, double period_s, double wheel_base_m,
                                      std::uint64_t seed);

}  // namespace wheelwright::test
