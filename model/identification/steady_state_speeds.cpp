#include "model/identification/steady_state_speeds.hpp"

#include <algorithm>
#include <cmath>

#include "model/identification/settled_response.hpp"
#include "model/log/run_periods.hpp"
#include "model/prediction/free_run.hpp"

namespace wheelwright {
namespace {

constexpr double settling_periods =
    14.0;                            // what is left of the lag then is small enough for the model to tell
constexpr double min_periods = 6.0;  // of a hold behind that

struct Hold {
  double command_m_s = 0.0;
  double speed_m_s = 0.0;
  double variance = 0.0;
  double held_s = 0.0;
};

class HoldFinder {
 public:
  HoldFinder(const DriveLog& log, const LinearModel& model, bool left, const WheelFit& fit)
      : log_(log),
        motion_(free_run(model, log)),
        left_(left),
        gain_(dc_gain(left ? model.left : model.right)),
        period_s_(model.period_s),
        fit_(fit) {}

  void find(std::vector<Hold>& holds) const {
    const auto& rows = log_.samples;
    std::size_t first = 0;
    for (std::size_t k = 1; k <= rows.size(); ++k) {
      if (k < rows.size() && continues(k)) continue;
      take(first, k - 1, holds);
      first = k;
    }
  }

 private:
  double of_wheel(const WheelPair& pair) const { return left_ ? pair.left : pair.right; }

  bool continues(std::size_t row) const {
    const DriveSample& sample = log_.samples[row];
    const DriveSample& before = log_.samples[row - 1];
    return sample.ticks && before.ticks &&
           std::abs(of_wheel(sample.command_m_s) - of_wheel(before.command_m_s)) < same_command_m_s &&
           sample.t_s - before.t_s <= longest_step_periods * log_.period_s;
  }

  double travel_m(std::size_t from, std::size_t to) const {
    const WheelTicks& a = *log_.samples[from].ticks;
    const WheelTicks& b = *log_.samples[to].ticks;
    return left_ ? static_cast<double>(b.left - a.left) * log_.metres_per_tick->left
                 : static_cast<double>(b.right - a.right) * log_.metres_per_tick->right;
  }

  // Mean of what the model would settle at for the commands of each moment.
  double settled_by_model(std::size_t from, std::size_t to) const {
    double sum = 0.0;
    for (std::size_t k = from; k < to; ++k) {
      const WheelPair& command = log_.samples[k].command_m_s;
      const double step_s = log_.samples[k + 1].t_s - log_.samples[k].t_s;
      sum += step_s * (gain_.from_left * command.left + gain_.from_right * command.right);
    }
    return sum / (log_.samples[to].t_s - log_.samples[from].t_s);
  }

  void take(std::size_t first, std::size_t last, std::vector<Hold>& holds) const {
    const auto& rows = log_.samples;
    const double command = of_wheel(rows[first].command_m_s);
    if (std::abs(command) < same_command_m_s || !rows[first].ticks) return;
    std::size_t from = first;
    while (from < last && rows[from].t_s < rows[first].t_s + settling_periods * period_s_) ++from;
    const double held_s = rows[last].t_s - rows[from].t_s;
    if (held_s < min_periods * period_s_) return;
    const double by_model = of_wheel(motion_[last].distance_m) - of_wheel(motion_[from].distance_m);
    const double still_owed = settled_by_model(from, last) - by_model / held_s;
    const double drift = fit_.drift_m_per_sqrt_s;
    const double noise = fit_.position_noise_m;
    holds.push_back({command, travel_m(from, last) / held_s + still_owed,
                     2.0 * noise * noise / (held_s * held_s) + drift * drift / held_s, held_s});
  }

  const DriveLog& log_;
  std::vector<PredictedMotion> motion_;
  bool left_;
  DcGain gain_;
  double period_s_;
  const WheelFit& fit_;
};

// Holds of one command together; what they scatter beyond their noise widens the error.
SteadyStateSpeed joined(std::span<const Hold> holds) {
  SteadyStateSpeed level{holds.front().command_m_s, 0.0, 0.0, holds.size(), 0.0};
  double weights = 0.0;
  for (const auto& hold : holds) {
    level.speed_m_s += hold.speed_m_s / hold.variance;
    weights += 1.0 / hold.variance;
    level.held_s += hold.held_s;
  }
  level.speed_m_s /= weights;
  double scatter = 0.0;
  for (const auto& hold : holds) scatter += std::pow(hold.speed_m_s - level.speed_m_s, 2) / hold.variance;
  const double expected = std::max(1.0, static_cast<double>(holds.size()) - 1.0);
  level.standard_error_m_s = std::sqrt(std::max(1.0, scatter / expected) / weights);
  return level;
}

std::vector<SteadyStateSpeed> by_command(std::vector<Hold> holds) {
  std::ranges::sort(holds, {}, &Hold::command_m_s);
  std::vector<SteadyStateSpeed> levels;
  for (auto first = holds.begin(); first != holds.end();) {
    const auto last = std::find_if(first, holds.end(), [&](const Hold& hold) {
      return hold.command_m_s - first->command_m_s > same_command_m_s;
    });
    levels.push_back(joined({first, last}));
    first = last;
  }
  return levels;
}

}  // namespace

SteadyStateSpeeds steady_state_speeds(std::span<const DriveLog> logs, const LinearModel& model,
                                      const WheelFit& left, const WheelFit& right) {
  std::vector<Hold> of_left;
  std::vector<Hold> of_right;
  for (const auto& log : logs) {
    if (!log.has_ticks()) continue;
    HoldFinder(log, model, true, left).find(of_left);
    HoldFinder(log, model, false, right).find(of_right);
  }
  return {by_command(std::move(of_left)), by_command(std::move(of_right))};
}

}  // namespace wheelwright
