// A log on its way through the data gate: what is left of it, and what was found.
#pragma once

#include <string>
#include <vector>

#include "model/gap/data_checks/commanded_stillness.hpp"
#include "model/gap/data_checks/data_gate.hpp"

namespace wheelwright::gap {

constexpr double impossible_speed_m_s = 2.0;  // of a wheel or the body between two rows

struct GateState {
  GatedLog result;
  std::vector<std::size_t> lines;  // of the rows that are left; empty while all are
  CounterEvidence elsewhere;       // of other runs of the robot
  std::vector<Freeze> held;        // where a reference saw that the wheel stood

  std::size_t line(std::size_t row) const { return lines.empty() ? result.log.first_line + row : lines[row]; }
  void fault(std::size_t row, const std::string& what, bool explains = false) {
    result.faults.push_back({result.log.name, line(row), what, false, explains, false, ""});
  }
  void treated_fault(std::size_t row, const std::string& what, const std::string& treatment) {
    result.faults.push_back({result.log.name, line(row), what, false, false, false, treatment});
  }
  void event(std::size_t row, const std::string& what) {
    result.faults.push_back({result.log.name, line(row), what, false, false, true, ""});
  }
  // Of a wheel, by its counter.
  double travel(std::size_t row, bool left) const {
    const DriveSample& sample = result.log.samples[row];
    return left ? static_cast<double>(sample.ticks->left) * result.log.metres_per_tick->left
                : static_cast<double>(sample.ticks->right) * result.log.metres_per_tick->right;
  }
};

}  // namespace wheelwright::gap
