#include "model/gap/data_checks/commanded_stillness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr double acts_within_s = 0.4;        // a command, on a wheel
constexpr double moving_share = 0.25;        // of what is asked; slower, a wheel stands
constexpr double exceptions_per_row = 0.05;  // of those that stand

double size_of(const DriveLog& log, std::size_t row, bool left) {
  const WheelPair& command = log.samples[row].command_m_s;
  return std::abs(left ? command.left : command.right);
}

// What was asked for while the counts stood still, in the middle of its sizes; how much earlier than it acted
// is not known, and the least is taken.
double median_command_m_s(const DriveLog& log, const Freeze& freeze) {
  double min_m_s = std::numeric_limits<double>::infinity();
  std::vector<double> sizes;
  for (std::size_t earlier = 0; earlier <= freeze.first; ++earlier) {
    if (log.samples[freeze.first].t_s - log.samples[freeze.first - earlier].t_s > acts_within_s) break;
    sizes.clear();
    for (std::size_t k = freeze.first; k <= freeze.end; ++k) {
      sizes.push_back(size_of(log, k - earlier, freeze.left));
    }
    min_m_s = std::min(min_m_s, median(sizes));
  }
  return min_m_s;
}

// Rows at which a wheel turns although for a while no more was asked of it than so much.
std::size_t rows_that_move(const DriveLog& log, bool left, double max_m_s) {
  const double tick_m = left ? log.metres_per_tick->left : log.metres_per_tick->right;
  const auto travel_m = [&](std::size_t from, std::size_t to) {
    const WheelTicks& a = *log.samples[from].ticks;
    const WheelTicks& b = *log.samples[to].ticks;
    return std::abs(static_cast<double>(left ? b.left - a.left : b.right - a.right)) * tick_m;
  };
  std::size_t rows = 0;
  std::size_t asked_from = 0;  // since when it was something, and no more than that
  std::size_t before = 0;
  for (std::size_t k = 1; k < log.samples.size(); ++k) {
    const double size = size_of(log, k - 1, left);
    if (size == 0.0 || size > max_m_s) asked_from = k;
    const double now_s = log.samples[k].t_s;
    while (now_s - log.samples[before].t_s > 0.5 * acts_within_s) ++before;
    if (now_s - log.samples[asked_from].t_s < acts_within_s) continue;
    if (!log.samples[k].ticks || !log.samples[before].ticks) continue;
    const double asked_m = size * (now_s - log.samples[before].t_s);
    if (travel_m(before, k) > moving_share * asked_m + tick_m) ++rows;
  }
  return rows;
}

}  // namespace

bool stand_by_command(const DriveLog& log, std::span<const Freeze> freezes) {
  if (freezes.size() < more_than_chance) return false;
  double max_m_s = 0.0;
  std::size_t standing = 0;
  for (const Freeze& freeze : freezes) {
    max_m_s = std::max(max_m_s, median_command_m_s(log, freeze));
    standing += freeze.end - freeze.first;
  }
  const std::size_t moving = rows_that_move(log, true, max_m_s) + rows_that_move(log, false, max_m_s);
  return static_cast<double>(moving) < exceptions_per_row * static_cast<double>(standing);
}

}  // namespace wheelwright::gap
