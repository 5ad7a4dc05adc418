#include "model/gap/data_checks/commanded_stillness.hpp"

#include <cmath>
#include <vector>

#include "model/gap/data_checks/data_gate.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.02;
constexpr double metres_per_tick = 0.0004;
constexpr int dead_rows = 4;  // before a command acts

double slalom_m_s(int row) {
  return 0.25 + 0.17 * std::sin(1.5 * period_s * row);
}

// Wheels that do at once what they were told a while ago, but for what is smaller than the threshold.
DriveLog slalom(double threshold_m_s) {
  DriveLog log;
  log.wheel_base_m = 0.25;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{metres_per_tick, metres_per_tick};
  WheelPair way_m;
  const auto turned = [&](double commanded_m_s) {
    return std::abs(commanded_m_s) < threshold_m_s ? 0.0 : commanded_m_s;
  };
  for (int row = 0; row < 2000; ++row) {
    DriveSample sample;
    sample.t_s = period_s * row;
    sample.command_m_s = {slalom_m_s(row), 0.5 - slalom_m_s(row)};
    sample.ticks =
        WheelTicks{std::llround(way_m.left / metres_per_tick), std::llround(way_m.right / metres_per_tick)};
    log.samples.push_back(sample);
    if (row < dead_rows) continue;
    way_m.left += period_s * turned(slalom_m_s(row - dead_rows));
    way_m.right += period_s * turned(0.5 - slalom_m_s(row - dead_rows));
  }
  return log;
}

// The same counts at all rows of each segment of so many; then they catch up.
std::vector<Freeze> hold_counts(DriveLog& log, std::initializer_list<std::size_t> from, std::size_t rows) {
  std::vector<Freeze> held;
  for (const std::size_t first : from) {
    for (std::size_t k = first; k <= first + rows; ++k) {
      log.samples[k].ticks->left = log.samples[first].ticks->left;
    }
    held.push_back({first, first + rows, true});
  }
  return held;
}

}  // namespace

TEST_CASE("A wheel that stands whenever less is asked of it than a threshold has lost no counts") {
  const GatedLog gated = gate(slalom(0.13));
  CHECK(gated.dropouts.empty());
  CHECK(gated.faults.empty());
}

TEST_CASE("Counts that stand still at commands at which they go on elsewhere are lost") {
  DriveLog log = slalom(0.0);
  const auto held = hold_counts(log, {300, 700, 1150}, 20);
  CHECK_FALSE(stand_by_command(log, held));
  CHECK(gate(log).dropouts.size() == held.size());
}

TEST_CASE("Counts that stand still once may do so by chance at a small command") {
  DriveLog log = slalom(0.13);
  std::size_t smallest = 300;
  for (std::size_t k = 300; k < 700; ++k) {
    if (slalom_m_s(static_cast<int>(k)) < slalom_m_s(static_cast<int>(smallest))) smallest = k;
  }
  const Freeze one{smallest - 5, smallest + 5, true};
  CHECK_FALSE(stand_by_command(log, std::vector{one}));
  CHECK(stand_by_command(log, std::vector{one, one}));
}
