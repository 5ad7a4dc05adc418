#include "model/gap/error_sources/residual_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "model/gap/noise/correlation_time.hpp"
#include "model/prediction/free_run.hpp"
#include "model/statistics/confidence.hpp"

namespace wheelwright::gap {
namespace {

constexpr double window_s = 0.25;
constexpr std::size_t row_count = 8;
constexpr std::size_t min_windows = 80;

enum Quantity {
  own_command,
  command_change,
  speed,
  turn_rate,
  since_start,
  heading,
  battery,
  quantity_count
};

struct QuantityName {
  const char* name;
  const char* unit;
};
constexpr std::array<QuantityName, quantity_count> quantity_names{{{"own command", "m/s"},
                                                                   {"change of own speed", "m/s^2"},
                                                                   {"forward speed", "m/s"},
                                                                   {"turn rate", "rad/s"},
                                                                   {"time since start", "s"},
                                                                   {"heading", "rad"},
                                                                   {"battery", "V"}}};

// The mean over a quarter of a second.
struct Window {
  std::size_t block = 0;
  double residual = 0.0;
  std::array<double, quantity_count> at{};  // not-a-number where unknown
};

using Windows = std::vector<Window>;

struct Side {
  double command = 0.0;
  double change = 0.0;
};

Window window_of(const DriveLog& log, const std::vector<PredictedMotion>& motion, std::size_t from,
                 std::size_t to, const Side& own, double residual) {
  Window window;
  window.residual = residual;
  window.at.fill(std::numeric_limits<double>::quiet_NaN());
  const double duration_s = motion[to].t_s - motion[from].t_s;
  window.at[own_command] = own.command;
  window.at[command_change] = own.change;
  window.at[speed] = 0.5 *
                     (motion[to].distance_m.left - motion[from].distance_m.left +
                      motion[to].distance_m.right - motion[from].distance_m.right) /
                     duration_s;
  window.at[turn_rate] = (motion[to].pose.theta_rad - motion[from].pose.theta_rad) / duration_s;
  window.at[since_start] = motion[from].t_s - motion.front().t_s;
  if (log.samples[from].reference_theta_rad)
    window.at[heading] = wrap_angle(*log.samples[from].reference_theta_rad);
  if (log.samples[from].battery_v) window.at[battery] = *log.samples[from].battery_v;
  return window;
}

bool restarts_between(const GatedLog& gated, std::size_t from, std::size_t to) {
  if (gated.flags.restart.empty()) return false;
  for (std::size_t i = from + 1; i <= to; ++i) {
    if (gated.flags.restart[i]) return true;
  }
  return false;
}

bool counted(const GatedLog& gated, std::size_t i) {
  return gated.log.samples[i].ticks && (gated.flags.counts.empty() || !gated.flags.counts[i]);
}

double mean_command(const DriveLog& log, std::size_t from, std::size_t to, double WheelPair::*side) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    sum += log.samples[i].command_m_s.*side * (log.samples[i + 1].t_s - log.samples[i].t_s);
  }
  return sum / (log.samples[to].t_s - log.samples[from].t_s);
}

void add_body_window(const GatedLog& gated, const std::vector<PredictedMotion>& motion, std::size_t from,
                     std::size_t to, double residual, std::size_t first_block, Windows& windows) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // no wheel of its own
  Window window = window_of(gated.log, motion, from, to, {unknown, unknown}, residual);
  window.block = first_block + static_cast<std::size_t>(window.at[since_start] / independent_after_s);
  windows.push_back(window);
}

// Both wheels of one run.
void add_wheels(const GatedLog& gated, const std::vector<PredictedMotion>& motion, std::size_t first_block,
                Windows& windows) {
  const DriveLog& log = gated.log;
  for (double WheelPair::*side : {&WheelPair::left, &WheelPair::right}) {
    const auto ticks = [&](std::size_t i) {
      const WheelTicks& both = *log.samples[i].ticks;
      return static_cast<double>(side == &WheelPair::left ? both.left : both.right);
    };
    std::optional<std::size_t> from;
    for (std::size_t i = 0; i < log.samples.size(); ++i) {
      if (!counted(gated, i)) continue;
      if (!from || restarts_between(gated, *from, i)) {
        from = i;
        continue;
      }
      const double duration_s = log.samples[i].t_s - log.samples[*from].t_s;
      if (duration_s < window_s) continue;
      const double measured = (ticks(i) - ticks(*from)) * ((*log.metres_per_tick).*side);
      const double predicted = motion[i].distance_m.*side - motion[*from].distance_m.*side;
      const Side own{mean_command(log, *from, i, side),
                     (motion[i].speed_m_s.*side - motion[*from].speed_m_s.*side) / duration_s};
      Window window = window_of(log, motion, *from, i, own, (measured - predicted) / duration_s);
      window.block = first_block + static_cast<std::size_t>(window.at[since_start] / independent_after_s);
      windows.push_back(window);
      from = i;
    }
  }
}

// How fast the robot turns by its wheels' counts.
void add_wheel_turns(const GatedLog& gated, const std::vector<PredictedMotion>& motion,
                     std::size_t first_block, Windows& windows) {
  const DriveLog& log = gated.log;
  const auto heading_at = [&](std::size_t i) {
    return (static_cast<double>(log.samples[i].ticks->right) * log.metres_per_tick->right -
            static_cast<double>(log.samples[i].ticks->left) * log.metres_per_tick->left) /
           log.wheel_base_m;
  };
  const auto predicted_at = [&](std::size_t i) {
    return (motion[i].distance_m.right - motion[i].distance_m.left) / log.wheel_base_m;
  };
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    if (!counted(gated, i)) continue;
    if (!from || restarts_between(gated, *from, i)) {
      from = i;
      continue;
    }
    const double duration_s = log.samples[i].t_s - log.samples[*from].t_s;
    if (duration_s < window_s) continue;
    const double measured = heading_at(i) - heading_at(*from);
    const double predicted = predicted_at(i) - predicted_at(*from);
    add_body_window(gated, motion, *from, i, (measured - predicted) / duration_s, first_block, windows);
    from = i;
  }
}

// How fast it turns by the reference.
void add_turns(const GatedLog& gated, const std::vector<PredictedMotion>& motion, std::size_t first_block,
               Windows& windows) {
  const DriveLog& log = gated.log;
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    if (!log.samples[i].reference_theta_rad) continue;
    if (!from) from = i;
    const double duration_s = log.samples[i].t_s - log.samples[*from].t_s;
    if (duration_s < window_s) continue;
    if (duration_s < 2.0 * independent_after_s) {
      const double measured =
          wrap_angle(*log.samples[i].reference_theta_rad - *log.samples[*from].reference_theta_rad);
      const double predicted = motion[i].pose.theta_rad - motion[*from].pose.theta_rad;
      add_body_window(gated, motion, *from, i, wrap_angle(measured - predicted) / duration_s, first_block,
                      windows);
    }
    from = i;
  }
}

ResidualRow row_of(std::span<const Window* const> windows, Quantity quantity, std::size_t all) {
  ResidualRow row;
  const double count = static_cast<double>(windows.size());
  row.from = windows.front()->at.at(quantity);
  row.to = windows.back()->at.at(quantity);
  row.share_of_time = count / static_cast<double>(all);
  for (const Window* window : windows) row.mean += window->residual / count;
  std::map<std::size_t, double> blocks;
  for (const Window* window : windows) blocks[window->block] += window->residual - row.mean;
  double variance = 0.0;
  for (const auto& [block, sum] : blocks) variance += sum * sum;
  row.ci95 = deviations_in_ci95 * std::sqrt(variance) / count;
  return row;
}

// Rows of equal time over one quantity, and how far beyond chance they differ.
struct Tabulated {
  ResidualTable table;
  double surprise = 0.0;
};

std::optional<Tabulated> tabulated(const Windows& windows, Quantity quantity) {
  std::vector<const Window*> sorted;
  for (const auto& window : windows) {
    if (std::isfinite(window.at.at(quantity))) sorted.push_back(&window);
  }
  if (sorted.size() < min_windows) return std::nullopt;
  std::ranges::sort(sorted, {}, [quantity](const Window* window) { return window->at.at(quantity); });
  if (sorted.back()->at.at(quantity) - sorted.front()->at.at(quantity) < 1e-6) return std::nullopt;
  Tabulated result;
  double mean = 0.0;
  double power = 0.0;
  for (const Window* window : sorted) mean += window->residual / static_cast<double>(sorted.size());
  for (const Window* window : sorted) power += std::pow(window->residual - mean, 2);
  double between = 0.0;
  for (std::size_t r = 0; r < row_count; ++r) {
    const std::size_t begin = r * sorted.size() / row_count;
    const std::size_t end = (r + 1) * sorted.size() / row_count;
    const ResidualRow row = row_of(std::span(sorted).subspan(begin, end - begin), quantity, sorted.size());
    const double deviation = row.mean - mean;
    between += static_cast<double>(end - begin) * deviation * deviation;
    if (row.ci95 > 0.0) result.surprise += std::pow(deviations_in_ci95 * deviation / row.ci95, 2);
    result.table.rows.push_back(row);
  }
  result.table.explained = power > 0.0 ? between / power : 0.0;
  result.table.over = quantity_names.at(quantity).name;
  result.table.over_unit = quantity_names.at(quantity).unit;
  return result;
}

}  // namespace

std::optional<ResidualTable> residual_table(const RobotModel& model, std::span<const GatedLog> logs) {
  constexpr double by_chance = 27.0;  // of chi squared with 8 rows, once in 1500 tables
  struct Residual {
    const char* name;
    const char* unit;
    void (*add)(const GatedLog&, const std::vector<PredictedMotion>&, std::size_t, Windows&);
    bool of_counts;
    Windows windows;
  };
  std::array<Residual, 3> residuals{{{"wheel speed", "m/s", add_wheels, true, {}},
                                     {"turn rate by the wheels", "rad/s", add_wheel_turns, true, {}},
                                     {"turn rate by the reference", "rad/s", add_turns, false, {}}}};
  std::size_t first_block = 0;
  for (const auto& gated : logs) {
    if (gated.log.samples.size() < 2) continue;
    const auto motion = free_run(model, gated.log);
    for (auto& residual : residuals) {
      if (residual.of_counts && !gated.log.has_ticks()) continue;
      residual.add(gated, motion, first_block, residual.windows);
    }
    first_block +=
        1 + static_cast<std::size_t>((gated.log.samples.back().t_s - gated.log.samples.front().t_s) /
                                     independent_after_s);
  }
  std::optional<ResidualTable> best;
  for (const auto& residual : residuals) {
    for (int i = 0; i < quantity_count; ++i) {
      auto next = tabulated(residual.windows, static_cast<Quantity>(i));
      if (!next || next->surprise < by_chance) continue;
      if (best && next->table.explained <= best->explained) continue;
      best = std::move(next->table);
      best->residual = residual.name;
      best->residual_unit = residual.unit;
    }
  }
  return best;
}

}  // namespace wheelwright::gap
