#include "model/gap/adequacy/covariates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/gap/fit/free_run_errors.hpp"

namespace wheelwright::gap {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// `value(run, track, period)` at each reading.
template <typename Value>
Covariate covariate(const FitProblem& problem, std::span<const ResidualTrack* const> tracks,
                    std::string_view name, std::string_view unit, Value value) {
  Covariate result{name, unit, {}};
  for (const ResidualTrack* track : tracks) {
    const GapRun& run = problem.runs()[track->run];
    auto& values = result.value.emplace_back();
    values.reserve(track->period.size());
    for (const std::size_t period : track->period) values.push_back(value(run, *track, period));
  }
  return result;
}

WheelPair command_at(const GapRun& run, std::size_t period) {
  if (run.commands_m_s.empty()) return {unknown, unknown};
  return run.commands_m_s[std::min(period, run.commands_m_s.size() - 1)];
}

// Otherwise a turning command says no more than that of the one wheel.
bool are_both_wheels_commanded(const FitProblem& problem) {
  const auto commanded = [&](double WheelPair::*wheel) {
    return std::ranges::any_of(problem.runs(), [wheel](const GapRun& run) {
      return std::ranges::any_of(run.commands_m_s,
                                 [wheel](const WheelPair& command) { return command.*wheel != 0.0; });
    });
  };
  return commanded(&WheelPair::left) && commanded(&WheelPair::right);
}

// Time since the command last changed, with the sign of that change: what a transient leaves. Not known
// before the first change.
Covariate since_change(const FitProblem& problem, std::span<const ResidualTrack* const> tracks) {
  constexpr double min_change_m_s = 0.02;
  constexpr double longest_s = 3.0;
  Covariate result{"the time since a change of command", "s", {}, {}};
  for (const ResidualTrack* track : tracks) {
    const GapRun& run = problem.runs()[track->run];
    const auto command = [&](std::size_t period) {
      const WheelPair now = command_at(run, period);
      if (track->channel == Channel::left) return now.left;
      if (track->channel == Channel::right) return now.right;
      return track->channel == Channel::turn ? now.right - now.left : 0.5 * (now.left + now.right);
    };
    auto& values = result.value.emplace_back();
    auto& signs = result.sign.emplace_back();
    std::size_t at = 0;
    std::optional<std::size_t> changed;
    double sign = 1.0;
    for (const std::size_t period : track->period) {
      for (; at < period; ++at) {
        const double change = command(at + 1) - command(at);
        if (std::abs(change) < min_change_m_s) continue;
        changed = at;
        sign = change > 0.0 ? 1.0 : -1.0;
      }
      const double since_s = changed ? run.period_s * static_cast<double>(period - *changed) : longest_s;
      values.push_back(since_s < longest_s ? since_s : unknown);
      signs.push_back(sign);
    }
  }
  return result;
}

std::vector<Pose> predicted_poses_of(const TrialModel& model, const GapRun& run) {
  constexpr double reference_age_s = 1.0;
  if (run.passed.empty()) return {};
  const auto states = model_states(model, run);
  const auto age = static_cast<std::size_t>(std::lround(reference_age_s / run.period_s));
  std::vector<Pose> poses;
  poses.reserve(states.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    const std::size_t from = k > age ? k - age : 0;
    const Pose& known = run.passed[std::min(from, run.passed.size() - 1)];
    poses.push_back(compose(known, between(states[from].pose, states[k].pose)));
  }
  return poses;
}

}  // namespace

std::vector<std::vector<Pose>> predicted_poses(const FitProblem& problem, const TrialModel& model) {
  std::vector<std::vector<Pose>> poses;
  poses.reserve(problem.runs().size());
  for (const GapRun& run : problem.runs()) poses.push_back(predicted_poses_of(model, run));
  return poses;
}

std::vector<Covariate> covariates_for(const FitProblem& problem, std::span<const std::vector<Pose>> poses,
                                      std::span<const ResidualTrack* const> tracks) {
  std::vector<Covariate> all;
  const bool of_wheels = !tracks.empty() && tracks.front()->of_wheel();
  if (of_wheels) {
    all.push_back(covariate(problem, tracks, "the wheel's command", "m/s",
                            [](const GapRun& run, const ResidualTrack& track, std::size_t period) {
                              const WheelPair command = command_at(run, period);
                              return track.channel == Channel::left ? command.left : command.right;
                            }));
  } else {
    all.push_back(covariate(problem, tracks, "the forward command", "m/s",
                            [](const GapRun& run, const ResidualTrack&, std::size_t period) {
                              const WheelPair command = command_at(run, period);
                              return 0.5 * (command.left + command.right);
                            }));
  }
  if (are_both_wheels_commanded(problem)) {
    all.push_back(covariate(problem, tracks, "the turning command", "rad/s",
                            [](const GapRun& run, const ResidualTrack&, std::size_t period) {
                              const WheelPair command = command_at(run, period);
                              return (command.right - command.left) / run.wheel_base_m;
                            }));
  }
  const auto by_pose = [&](std::string_view name, std::string_view unit, auto value) {
    all.push_back(covariate(problem, tracks, name, unit,
                            [&](const GapRun&, const ResidualTrack& track, std::size_t period) {
                              const auto& of_run = poses[track.run];
                              if (of_run.empty()) return unknown;
                              return value(of_run[std::min(period, of_run.size() - 1)]);
                            }));
  };
  by_pose(heading_name, "rad", [](const Pose& pose) { return wrap_angle(pose.theta_rad); });
  by_pose("the place along x", "m", [](const Pose& pose) { return pose.x_m; });
  by_pose("the place along y", "m", [](const Pose& pose) { return pose.y_m; });
  all.push_back(covariate(problem, tracks, "the time since the start", "s",
                          [](const GapRun& run, const ResidualTrack&, std::size_t period) {
                            return run.period_s * static_cast<double>(period);
                          }));
  all.push_back(since_change(problem, tracks));
  return all;
}

RecentCommands recent_commands(const FitProblem& problem, std::span<const ResidualTrack* const> tracks) {
  constexpr double recent_s = 1.0;
  constexpr std::size_t most_looks = 50;  // commands last longer than a fiftieth of a second
  RecentCommands recent;
  for (const ResidualTrack* track : tracks) {
    const GapRun& run = problem.runs()[track->run];
    const auto periods = static_cast<std::size_t>(std::ceil(recent_s / run.period_s));
    const std::size_t step = std::max<std::size_t>(1, periods / most_looks);
    auto& forward = recent.forward_m_s.emplace_back();
    auto& turning = recent.turning_rad_s.emplace_back();
    for (const std::size_t period : track->period) {
      forward.push_back(0.0);
      turning.push_back(0.0);
      for (std::size_t k = period > periods ? period - periods : 0; k <= period; k += step) {
        const WheelPair command = command_at(run, k);
        forward.back() = std::max(forward.back(), std::abs(0.5 * (command.left + command.right)));
        turning.back() = std::max(turning.back(), std::abs(command.right - command.left) / run.wheel_base_m);
      }
    }
  }
  return recent;
}

}  // namespace wheelwright::gap
