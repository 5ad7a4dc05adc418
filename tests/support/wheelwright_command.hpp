// The `wheelwright` command as tests call it, and logs for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "model/drive_log.hpp"
#include "tests/support/published_plant.hpp"
#include "tools/wheelwright/command_line.hpp"

namespace wheelwright::test {

struct Outcome {
  tools::ExitStatus status;
  std::string out;
  std::string err;
};

inline Outcome wheelwright_command(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const tools::ExitStatus status = tools::run_command_line(arguments, {out, err});
  return {status, out.str(), err.str()};
}

inline bool is_one_line(const std::string& text) {
  return !text.empty() && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

// The speed at which a wheel acts on a command, before it lags behind.
using SpeedCurve = std::function<double(double command_m_s)>;

// A run of the published plant by random commands, counted in whole ticks of a Roomba. Saved, its first row
// stands in line 8.
inline DriveLog plant_run(unsigned seed, std::size_t rows = 1000, const SpeedCurve& curve = nullptr,
                          std::size_t rows_per_command = 9) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-0.3, 0.3);
  PublishedPlant left;
  PublishedPlant right;
  constexpr double metres_per_tick = 0.000444565;
  DriveLog log{"plant", 0.235, 0.018, WheelPair{metres_per_tick, metres_per_tick}, {}, {{"robot", "plant"}},
               {},      {},    1};
  WheelPair travelled;
  WheelPair command;
  for (std::size_t k = 0; k < rows; ++k) {
    if (k % rows_per_command == 0) command = {any(random), any(random)};
    DriveSample sample;
    sample.t_s = 0.018 * static_cast<double>(k);
    sample.command_m_s = command;
    sample.ticks = WheelTicks{std::llround(travelled.left / metres_per_tick),
                              std::llround(travelled.right / metres_per_tick)};
    log.samples.push_back(sample);
    travelled.left += 0.018 * left.step(curve ? curve(command.left) : command.left);
    travelled.right += 0.018 * right.step(curve ? curve(command.right) : command.right);
  }
  return log;
}

}  // namespace wheelwright::test
