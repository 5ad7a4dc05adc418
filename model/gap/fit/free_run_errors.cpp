#include "model/gap/fit/free_run_errors.hpp"

#include <algorithm>

#include "model/gap/fit/path_motion.hpp"
#include "model/gap/runs/gyro_turns.hpp"

namespace wheelwright::gap {
namespace {

struct Path {
  std::vector<WheelPair> distance_m;  // of the wheels at each grid point
  // Of the motion; left out where only the wheels are asked for.
  std::vector<OdometryStep> odometry;  // what the model's own counts would say, per period
  std::vector<OdometryStep> body;      // what the model's body does, per period
};

Pose first_pose(const GapRun& run, const ModelSimulation& simulation) {
  return run.references.empty() ? Pose{} : simulation.axle_of(run.references.front().pose);
}

// What is known of a run better than by a run of the model that has gone astray: effects that act by place,
// heading or the wheels' angle act there. The path is the model's own all the same.
struct Known {
  bool poses = false;   // by dense references
  bool travel = false;  // of the wheels, by counts
};

bool any_hangs_on(bool EffectInfo::*what, const TrialModel& model) {
  return std::ranges::any_of(model.effects, [&](const TrialEffect& effect) { return effect.info->*what; });
}

Known known_of(const MeasuredSimulation& model, const GapRun& run) {
  return {!run.passed.empty() && model.by_pose, run.has_counts && model.by_wheel_angle};
}

Path simulate(ModelSimulation& simulation, const GapRun& run, const Known& known, Outputs outputs) {
  const std::size_t periods = run.commands_m_s.size();
  Path path;
  path.distance_m.reserve(periods + 1);
  if (outputs != Outputs::wheels) {
    path.odometry.reserve(periods);
    path.body.reserve(periods);
  }
  simulation.reset(first_pose(run, simulation), run.initial_travel_m);
  path.distance_m.push_back(run.initial_travel_m);
  const double t = run.period_s;
  WheelPair counted_m = run.initial_travel_m;
  for (std::size_t k = 0; k < periods; ++k) {
    if (known.poses) simulation.set_pose(simulation.axle_of(run.passed[k]));
    if (known.travel) simulation.set_distance_m(counted_m);
    const auto& now = simulation.step(run.commands_m_s[k], run.battery_v[k]);
    const WheelPair& before_m = path.distance_m.back();
    path.distance_m.push_back(
        {before_m.left + now.wheel_m_s.left * t, before_m.right + now.wheel_m_s.right * t});
    if (known.travel) {
      const auto& [forward_m, turn_rad] = run.odometry[k];
      const double half_m = 0.5 * turn_rad * run.wheel_base_m;
      counted_m = {counted_m.left + forward_m - half_m, counted_m.right + forward_m + half_m};
    }
    if (outputs == Outputs::wheels) continue;
    const Twist counted = twist_of_wheels(now.wheel_m_s, run.wheel_base_m);
    path.odometry.push_back({counted.v_m_s * t, counted.w_rad_s * t});
    path.body.push_back({now.twist.v_m_s * t, now.twist.w_rad_s * t});
  }
  return path;
}

void wheel_errors(const GapRun& run, const Path& path, Channel channel, std::vector<double>& errors) {
  const Series& series = run[channel];
  const auto travel = [&](const GridTime& at) {
    const auto side = [&](const WheelPair& pair) {
      return channel == Channel::left ? pair.left : pair.right;
    };
    const double a = side(path.distance_m[at.period]);
    if (at.share == 0.0) return a;
    return interpolated(a, side(path.distance_m[at.period + 1]), at.share);
  };
  errors.reserve(series.at.size());
  for (std::size_t i = 0; i < series.at.size(); ++i) errors.push_back(series.value[i] - travel(series.at[i]));
}

void motion_errors(const GapRun& run, const ModelSimulation& simulation, const Path& path, double lag_s,
                   RunErrors& errors) {
  const auto& at = run[Channel::turn].at;
  const PathMotion body(run, path.body, &simulation);
  const PathMotion odometry(run, path.odometry);
  Increment sum;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (i > 0) {
      Increment step = body.increment(earlier(run, at[i - 1], lag_s), earlier(run, at[i], lag_s));
      if (run.has_counts) {
        const Increment counted = odometry.increment(at[i - 1], at[i]);
        step = {step.forward - counted.forward, step.aside - counted.aside, step.turn - counted.turn};
      }
      sum = {sum.forward + step.forward, sum.aside + step.aside, sum.turn + step.turn};
    }
    const auto add = [&](Channel channel, double predicted) {
      errors.series[static_cast<std::size_t>(channel)].push_back(run[channel].value[i] - predicted);
    };
    add(Channel::turn, sum.turn);
    if (run.heading_alone) continue;
    add(Channel::forward, sum.forward);
    add(Channel::aside, sum.aside);
  }
}

double at(const std::vector<double>& turned_rad, const GridTime& when) {
  const double a = turned_rad[when.period];
  return when.share == 0.0 ? a : interpolated(a, turned_rad[when.period + 1], when.share);
}

std::vector<double> turned_by(const std::vector<OdometryStep>& steps) {
  std::vector<double> turned_rad{0.0};
  turned_rad.reserve(steps.size() + 1);
  for (const OdometryStep& step : steps) turned_rad.push_back(turned_rad.back() + step.turn_rad);
  return turned_rad;
}

// A gyro too large by its scale says so much more of the whole turn: of the model's, since counts are
// rounded, and what is rounded in two places at once would look like a scale.
void gyro_errors(const GapRun& run, const Path& path, const MeasuredSimulation& model, RunErrors& errors) {
  const auto own_rad = turned_by(path.odometry);
  const auto body_rad = turned_by(path.body);
  const Series& series = run[Channel::turn];
  std::vector<double> all;
  all.reserve(series.at.size());
  for (std::size_t i = 0; i < series.at.size(); ++i) {
    const GridTime& when = series.at[i];
    const double turned = at(body_rad, earlier(run, when, model.reference_lag_s));
    all.push_back(series.value[i] - (turned - at(own_rad, when)) - model.gyro_scale * turned);
  }
  GyroErrors found = without_drift(run, std::move(all));
  errors.series[static_cast<std::size_t>(Channel::turn)] = std::move(found.errors_rad);
  errors.gyro_drift_rad_s = found.drift_rad_s;
}

// Odometry, with what the model adds to it, from one reference to the next.
SegmentError segment_error(const GapRun& run, const ModelSimulation& simulation, const Path& path,
                           double lag_s, const Reference& from, const Reference& to) {
  Pose pose = simulation.axle_of(from.pose);
  for_each_period(earlier(run, from.at, lag_s), earlier(run, to.at, lag_s), [&](std::size_t k, double share) {
    if (k >= path.body.size()) return;
    OdometryStep step = path.body[k];
    if (run.has_counts) {
      step.forward_m += run.odometry[k].forward_m - path.odometry[k].forward_m;
      step.turn_rad += run.odometry[k].turn_rad - path.odometry[k].turn_rad;
    }
    pose = move_along_arc(pose, {step.forward_m, step.turn_rad}, share);
  });
  if (run.heading_alone) return {0.0, 0.0, wrap_angle(to.pose.theta_rad - pose.theta_rad)};
  const Pose measured = between(from.pose, to.pose);
  const Pose predicted = between(from.pose, simulation.observed(pose));
  return {measured.x_m - predicted.x_m, measured.y_m - predicted.y_m,
          wrap_angle(measured.theta_rad - predicted.theta_rad)};
}

}  // namespace

void measure_motion(GapRun& run) {
  if (run.sparse) return;
  const PathMotion odometry(run, run.odometry);
  Increment sum;
  for (std::size_t i = 0; i < run.references.size(); ++i) {
    if (i > 0) {
      Increment step = increment(run.references[i - 1].pose, run.references[i].pose);
      if (run.has_counts) {
        const Increment counted = odometry.increment(run.references[i - 1].at, run.references[i].at);
        step = {step.forward - counted.forward, step.aside - counted.aside, step.turn - counted.turn};
      }
      sum = {sum.forward + step.forward, sum.aside + step.aside, sum.turn + step.turn};
    }
    run[Channel::turn].value.push_back(sum.turn);
    if (run.heading_alone) continue;
    run[Channel::forward].value.push_back(sum.forward);
    run[Channel::aside].value.push_back(sum.aside);
  }
}

MeasuredSimulation measured_simulation(const TrialModel& model) {
  return {model.simulation(), any_hangs_on(&EffectInfo::by_pose, model),
          any_hangs_on(&EffectInfo::by_wheel_angle, model), model.reference_lag_s(), model.gyro_scale()};
}

RunErrors free_run_errors(const TrialModel& model, const GapRun& run, Outputs outputs) {
  return free_run_errors(measured_simulation(model), run, outputs);
}

RunErrors free_run_errors(MeasuredSimulation model, const GapRun& run, Outputs outputs) {
  ModelSimulation& simulation = model.simulation;
  if (!model.by_pose) simulation.leave_out_place();
  const Path path = simulate(simulation, run, known_of(model, run), outputs);
  RunErrors errors;
  for (const Channel channel : {Channel::left, Channel::right}) {
    if (!run[channel].empty() && outputs != Outputs::motion) {
      wheel_errors(run, path, channel, errors.series[static_cast<std::size_t>(channel)]);
    }
  }
  if (outputs == Outputs::wheels) return errors;
  if (run.sparse) {
    for (std::size_t i = 1; i < run.references.size(); ++i) {
      errors.segments.push_back(segment_error(run, simulation, path, model.reference_lag_s,
                                              run.references[i - 1], run.references[i]));
    }
  }
  if (run.by_gyro) {
    gyro_errors(run, path, model, errors);
  } else if (!run.sparse && !run[Channel::turn].empty()) {
    motion_errors(run, simulation, path, model.reference_lag_s, errors);
  }
  return errors;
}

WheelPair travel_gain(const TrialModel& model, const GapRun& run) {
  constexpr double window_s = 1.0;
  const RunErrors errors = free_run_errors(model, run);
  const auto gain_of = [&](Channel channel) {
    double power = 0.0;
    double product = 0.0;
    const Series& series = run[channel];
    const auto& error = errors.series[static_cast<std::size_t>(channel)];
    std::size_t from = 0;
    for (std::size_t i = 1; i < series.at.size(); ++i) {
      if (series.restarts[i]) from = i;
      if (static_cast<double>(series.at[i].period - series.at[from].period) * run.period_s < window_s)
        continue;
      const double measured = series.value[i] - series.value[from];
      const double predicted = measured - (error[i] - error[from]);
      power += predicted * predicted;
      product += predicted * measured;
      from = i;
    }
    return power > 0.0 ? product / power : 1.0;
  };
  if (run.has_counts) return {gain_of(Channel::left), gain_of(Channel::right)};
  const double forward = gain_of(Channel::forward);
  return {forward, forward};
}

std::vector<ModelState> model_states(const TrialModel& model, const GapRun& run) {
  ModelSimulation simulation = model.simulation();
  simulation.reset(first_pose(run, simulation), run.initial_travel_m);
  std::vector<ModelState> states;
  states.reserve(run.commands_m_s.size());
  for (std::size_t k = 0; k < run.commands_m_s.size(); ++k) {
    const auto& now = simulation.step(run.commands_m_s[k], run.battery_v[k]);
    states.push_back({now.wheel_m_s, now.twist, simulation.pose(), simulation.distance_m()});
  }
  return states;
}

}  // namespace wheelwright::gap
