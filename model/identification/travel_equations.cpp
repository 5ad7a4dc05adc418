#include "model/identification/travel_equations.hpp"

#include <algorithm>
#include <cmath>

#include "model/identification/settled_response.hpp"
#include "model/log/command_timeline.hpp"
#include "model/log/run_periods.hpp"

namespace wheelwright {

double whitened_travel_equations(std::span<const DriveLog> logs, double period_s, std::size_t taps,
                                 const RelativeTravelNoise& noise, const EquationSink& sink) {
  const auto columns = static_cast<Eigen::Index>(2 * taps);
  WhiteningGains gains(noise);
  TravelWhitener whitener(columns + 2);
  double log_variance_sum = 0.0;
  Eigen::RowVectorXd row(columns + 2);
  Eigen::RowVectorXd whitened(columns + 2);
  Eigen::RowVectorXd regressors(columns);
  for (const auto& log : logs) {
    const CommandTimeline timeline(log);
    gains.restart();
    double known_since_s = -1e300;  // the run starts from rest: its past is known to be zero
    double last_used_s = log.samples.front().t_s;
    for (std::size_t k = 0; k < log.samples.size(); ++k) {
      const DriveSample& sample = log.samples[k];
      if (k > 0 && sample.t_s - log.samples[k - 1].t_s > longest_step_periods * log.period_s) {
        known_since_s = sample.t_s;
        gains.restart();
      }
      const double oldest_s = sample.t_s - period_s * static_cast<double>(taps);
      if (!sample.ticks || oldest_s < known_since_s) continue;
      for (std::size_t i = 0; i < taps; ++i) {
        const WheelPair commanded = timeline.distance_m(sample.t_s - period_s * static_cast<double>(i));
        row[static_cast<Eigen::Index>(2 * i)] = commanded.left;
        row[static_cast<Eigen::Index>(2 * i + 1)] = commanded.right;
      }
      const WheelTicks& start = *log.samples.front().ticks;
      row[columns] = static_cast<double>(sample.ticks->left - start.left) * log.metres_per_tick->left;
      row[columns + 1] = static_cast<double>(sample.ticks->right - start.right) * log.metres_per_tick->right;
      const double periods = (sample.t_s - last_used_s) / period_s;
      last_used_s = sample.t_s;
      const WheelPair speed = timeline.mean_m_s(sample.t_s - moving_window_periods * period_s, sample.t_s);
      const double fastest_m_s = std::max(std::abs(speed.left), std::abs(speed.right));
      const WhiteningStep step = gains.next(periods, noise.reading_variance(fastest_m_s));
      log_variance_sum += step.log_variance;
      if (!whitener.filter(row, step, whitened)) continue;
      regressors = whitened.head(columns);
      sink(regressors, whitened.tail<2>());
    }
  }
  return log_variance_sum;
}

}  // namespace wheelwright
