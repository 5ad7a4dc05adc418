#include "model/identification/speed_curve.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "model/identification/settled_response.hpp"
#include "model/statistics/dense_solve.hpp"

namespace wheelwright {
namespace {

constexpr std::size_t min_curve_commands = 3;
constexpr double min_span = 1.5;              // largest command over smallest
constexpr double bend_stands_out = 4.0;       // standard errors
constexpr double min_bend = 0.02;             // of the gain
constexpr double curve_is_rough_m_s = 0.001;  // no parabola is nearer to a robot's curve than this
constexpr double smallest_step_m_s = 0.005;
constexpr double largest_step_m_s = 0.06;
constexpr double between_steps_m_s = 0.0005;
constexpr int edges = 20;        // places of the first edge that are tried, in a step
constexpr double tries = 100.0;  // that differ: neighbouring steps and edges nearly agree
constexpr double max_p_value = 0.01;

struct Level {
  double command = 0.0;  // its size
  double speed = 0.0;
  double error = 0.0;
  bool left = false;
};

void add_levels(const std::vector<SteadyStateSpeed>& speeds, bool left, std::vector<Level>& levels) {
  for (const auto& held : speeds) {
    const double sign = held.command_m_s < 0.0 ? -1.0 : 1.0;
    levels.push_back({sign * held.command_m_s, sign * held.speed_m_s, held.standard_error_m_s, left});
  }
}

std::size_t count_commands(const std::vector<Level>& levels) {  // sorted
  std::size_t count = 0;
  double last = -1.0;
  for (const auto& level : levels) {
    if (level.command - last <= same_command_m_s) continue;
    last = level.command;
    ++count;
  }
  return count;
}

constexpr int unknowns = 4;

// What is left, in squared standard deviations, of speeds as a parabola of something in place of the command,
// with a gain for each wheel.
double fit_curve(const std::vector<Level>& levels, const std::function<double(double)>& acts_as) {
  using Matrix = Eigen::Matrix<double, unknowns, unknowns>;
  using Vector = Eigen::Matrix<double, unknowns, 1>;
  Matrix normal = 1e-12 * Matrix::Identity();  // one wheel may have held nothing
  Vector right = Vector::Zero();
  const auto regressors = [&](const Level& level) {
    const double x = acts_as(level.command);
    return Vector(1.0, level.left ? x : 0.0, level.left ? 0.0 : x, x * x);
  };
  const auto weight = [](const Level& level) {
    return 1.0 / (level.error * level.error + curve_is_rough_m_s * curve_is_rough_m_s);
  };
  for (const auto& level : levels) {
    const Vector row = regressors(level);
    normal += weight(level) * row * row.transpose();
    right += weight(level) * level.speed * row;
  }
  const Vector solution = solve_symmetric(normal, right);
  double square_sum = 0.0;
  for (const auto& level : levels) {
    square_sum += weight(level) * std::pow(level.speed - regressors(level).dot(solution), 2);
  }
  return square_sum;
}

// Mean gain of the levels; what they scatter beyond their errors widens its own.
GainAt mean_gain(const std::vector<Level>& levels) {
  GainAt mean;
  double weights = 0.0;
  const auto weight = [](const Level& level) { return std::pow(level.command / level.error, 2); };
  for (const auto& level : levels) {
    mean.gain += weight(level) * level.speed / level.command;
    mean.command_m_s += weight(level) * level.command;
    weights += weight(level);
  }
  mean.gain /= weights;
  mean.command_m_s /= weights;
  double scatter = 0.0;
  for (const auto& level : levels) {
    scatter += weight(level) * std::pow(level.speed / level.command - mean.gain, 2);
  }
  const double expected = std::max(1.0, static_cast<double>(levels.size()) - 1.0);
  mean.standard_error = std::sqrt(std::max(1.0, scatter / expected) / weights);
  return mean;
}

std::optional<GainBend> find_bend(const std::vector<Level>& levels) {
  const double smallest = levels.front().command;
  const double largest = levels.back().command;
  if (largest < min_span * smallest) return std::nullopt;
  std::vector<Level> low;
  std::vector<Level> high;
  for (const auto& level : levels) {
    const double place = (level.command - smallest) / (largest - smallest);
    if (place < 1.0 / 3.0) low.push_back(level);
    if (place > 2.0 / 3.0) high.push_back(level);
  }
  const GainBend bend{mean_gain(low), mean_gain(high)};
  const double difference = std::abs(bend.low.gain - bend.high.gain);
  const double error = std::hypot(bend.low.standard_error, bend.high.standard_error);
  if (difference < bend_stands_out * error || difference < min_bend * std::abs(bend.high.gain)) {
    return std::nullopt;
  }
  return bend;
}

struct StepTrial {
  double step = 0.0;
  double first_edge = 0.0;
  double square_sum = std::numeric_limits<double>::infinity();
};

double step_number(double command, const StepTrial& trial) {
  return 1.0 + std::floor((command - trial.first_edge) / trial.step + 1e-9);
}

// Two commands on one step at least: else each has a step of its own, and nothing is shown.
bool is_shared(const std::vector<Level>& levels, const StepTrial& trial) {
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (levels[i].command - levels[i - 1].command > same_command_m_s &&
        step_number(levels[i].command, trial) == step_number(levels[i - 1].command, trial)) {
      return true;
    }
  }
  return false;
}

std::vector<StepTrial> try_steps(const std::vector<Level>& levels) {
  std::vector<StepTrial> trials;
  const auto count = static_cast<int>((largest_step_m_s - smallest_step_m_s) / between_steps_m_s);
  for (int i = 0; i <= count; ++i) {
    for (int edge = 0; edge < edges; ++edge) {
      StepTrial trial;
      trial.step = smallest_step_m_s + between_steps_m_s * i;
      trial.first_edge = trial.step * edge / edges;
      if (!is_shared(levels, trial)) continue;
      trial.square_sum = fit_curve(levels, [&](double command) { return step_number(command, trial); });
      trials.push_back(trial);
    }
  }
  return trials;
}

std::optional<SpeedSteps> find_steps(const std::vector<Level>& levels) {
  const double freedom = static_cast<double>(levels.size()) - unknowns - 2.0;  // step and first edge
  if (freedom < 2.0) return std::nullopt;
  const auto trials = try_steps(levels);
  if (trials.empty()) return std::nullopt;
  const StepTrial best = *std::ranges::min_element(trials, {}, &StepTrial::square_sum);
  const double smooth = fit_curve(levels, [](double command) { return command; });
  // Of an F test with two more unknowns, which has this closed form.
  const double p_value = tries * std::pow(best.square_sum / smooth, 0.5 * freedom);
  if (!(p_value < max_p_value)) return std::nullopt;
  SpeedSteps steps{best.step, best.step, best.step, p_value};
  const double as_likely = best.square_sum * (1.0 + 4.0 / freedom);
  for (const auto& trial : trials) {
    if (trial.square_sum > as_likely) continue;
    steps.smallest_m_s = std::min(steps.smallest_m_s, trial.step);
    steps.largest_m_s = std::max(steps.largest_m_s, trial.step);
  }
  return steps;
}

}  // namespace

SpeedCurve find_speed_curve(const SteadyStateSpeeds& speeds) {
  std::vector<Level> levels;
  add_levels(speeds.left, true, levels);
  add_levels(speeds.right, false, levels);
  std::ranges::sort(levels, {}, &Level::command);
  SpeedCurve curve{count_commands(levels), std::nullopt, std::nullopt};
  if (curve.commands < min_curve_commands) return curve;
  curve.bend = find_bend(levels);
  curve.steps = find_steps(levels);
  return curve;
}

}  // namespace wheelwright
