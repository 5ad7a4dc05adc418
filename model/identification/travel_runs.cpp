#include "model/identification/travel_runs.hpp"

#include <algorithm>
#include <cmath>

#include "model/identification/settled_response.hpp"
#include "model/log/command_timeline.hpp"
#include "model/log/run_periods.hpp"

namespace wheelwright {
namespace {

constexpr double time_tolerance = 1e-4;  // of a period; times in files are printed with microseconds

TravelRun travel_run(const DriveLog& log, double period_s) {
  TravelRun run;
  const CommandTimeline timeline(log);
  const auto& rows = log.samples;
  const double start_s = rows.front().t_s;
  double known_since_s = -1e300;  // the run starts from rest: its past is known to be zero
  double last_used_s = start_s;
  bool restart = true;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double t_s = rows[k].t_s;
    if (k > 0 && t_s - rows[k - 1].t_s > longest_step_periods * log.period_s) {
      known_since_s = t_s;
      restart = true;
    }
    if (!rows[k].ticks || t_s - forgetting_periods * period_s < known_since_s) continue;
    const double periods = (t_s - start_s) / period_s;
    // A row on the grid ends its period, though its time may lie a microsecond behind it.
    const double period = std::max(0.0, std::ceil(periods - time_tolerance) - 1.0);
    const WheelPair recent = timeline.mean_m_s(t_s - moving_window_periods * period_s, t_s);
    const WheelTicks& first = *rows.front().ticks;
    TravelReading reading;
    reading.period = static_cast<std::size_t>(period);
    reading.share = periods - period;
    reading.travel_m = {static_cast<double>(rows[k].ticks->left - first.left) * log.metres_per_tick->left,
                        static_cast<double>(rows[k].ticks->right - first.right) * log.metres_per_tick->right};
    reading.periods_since = (t_s - last_used_s) / period_s;
    reading.fastest_m_s = std::max(std::abs(recent.left), std::abs(recent.right));
    reading.restart = restart;
    run.readings.push_back(reading);
    restart = false;
    last_used_s = t_s;
  }
  const std::size_t periods = run.readings.empty() ? 0 : run.readings.back().period + 1;
  for (std::size_t k = 0; k < periods; ++k) {
    run.commands_m_s.push_back(timeline.mean_m_s(start_s + period_s * static_cast<double>(k),
                                                 start_s + period_s * static_cast<double>(k + 1)));
  }
  return run;
}

}  // namespace

std::vector<TravelRun> travel_runs(std::span<const DriveLog> logs, double period_s) {
  std::vector<TravelRun> runs;
  for (const auto& log : logs) runs.push_back(travel_run(log, period_s));
  return runs;
}

}  // namespace wheelwright
