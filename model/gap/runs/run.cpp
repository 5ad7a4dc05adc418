#include "model/gap/runs/run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/gap/runs/gyro_turns.hpp"
#include "model/log/command_timeline.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::gap {
namespace {

constexpr double sparse_from_s = 1.5;  // median distance of references: "once a second" is not always

GridTime grid_time(const GapRun& run, double t_s) {
  const double periods = std::max(0.0, (t_s - run.start_s) / run.period_s);
  const double nearest = std::round(periods);
  // Times are printed with microseconds: what lies that near to the grid lies on it.
  const double exact = std::abs(periods - nearest) < 1e-3 ? nearest : periods;
  const double last = static_cast<double>(run.commands_m_s.size());
  const double clipped = std::min(exact, last);
  const double whole = std::floor(clipped);
  return {static_cast<std::size_t>(whole), clipped - whole};
}

void lay_commands(const DriveLog& log, GapRun& run) {
  const CommandTimeline timeline(log);
  const double span = log.samples.back().t_s - run.start_s;
  const auto periods = static_cast<std::size_t>(std::ceil(span / run.period_s - 1e-3));
  std::size_t row = 0;
  double battery_v = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < periods; ++k) {
    const double from = run.start_s + run.period_s * static_cast<double>(k);
    run.commands_m_s.push_back(timeline.mean_m_s(from, from + run.period_s));
    for (; row < log.samples.size() && log.samples[row].t_s <= from + 1e-3 * run.period_s; ++row) {
      battery_v = log.samples[row].battery_v.value_or(battery_v);
    }
    run.battery_v.push_back(battery_v);
  }
}

void lay_counts(const DriveLog& log, const RowFlags& flags, GapRun& run) {
  if (!log.metres_per_tick) return;
  char restart = 0;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    const auto& ticks = log.samples[i].ticks;
    if (!flags.restart.empty() && flags.restart[i]) restart = 1;
    if (!ticks || (!flags.counts.empty() && flags.counts[i])) {
      restart = 1;
      continue;
    }
    const GridTime at = grid_time(run, log.samples[i].t_s);
    const auto add = [&](Channel channel, double value) {
      run[channel].at.push_back(at);
      run[channel].value.push_back(value);
      run[channel].restarts.push_back(run[channel].at.size() == 1 ? char{0} : restart);
    };
    add(Channel::left, static_cast<double>(ticks->left) * log.metres_per_tick->left);
    add(Channel::right, static_cast<double>(ticks->right) * log.metres_per_tick->right);
    restart = 0;
  }
  run.has_counts = !run[Channel::left].empty();
}

// Travel of a counted wheel at any grid time, linear between readings.
class Travel {
 public:
  explicit Travel(const GapRun& run, const Series& series) : run_(run), series_(series) {}
  double at(double time_s) {
    while (next_ + 1 < series_.at.size() && seconds_at(run_, series_.at[next_]) < time_s) ++next_;
    if (next_ == 0) return series_.value.front();
    const double t0 = seconds_at(run_, series_.at[next_ - 1]);
    const double t1 = seconds_at(run_, series_.at[next_]);
    const double share = std::clamp((time_s - t0) / (t1 - t0), 0.0, 1.0);
    return series_.value[next_ - 1] + share * (series_.value[next_] - series_.value[next_ - 1]);
  }

 private:
  const GapRun& run_;
  const Series& series_;
  std::size_t next_ = 0;
};

void lay_odometry(GapRun& run) {
  Travel left(run, run[Channel::left]);
  Travel right(run, run[Channel::right]);
  WheelPair before{left.at(0.0), right.at(0.0)};
  for (std::size_t k = 1; k <= run.commands_m_s.size(); ++k) {
    const double t = run.period_s * static_cast<double>(k);
    const WheelPair now{left.at(t), right.at(t)};
    const double dl = now.left - before.left;
    const double dr = now.right - before.right;
    run.odometry.push_back({0.5 * (dl + dr), (dr - dl) / run.wheel_base_m});
    before = now;
  }
}

// How far the robot has turned by its counts, or else by its commands.
class ExpectedTurn {
 public:
  explicit ExpectedTurn(const GapRun& run) : turned_rad_{0.0} {
    for (std::size_t k = 0; k < run.commands_m_s.size(); ++k) {
      const WheelPair& u = run.commands_m_s[k];
      const double turn_rad =
          run.has_counts ? run.odometry[k].turn_rad : run.period_s * (u.right - u.left) / run.wheel_base_m;
      turned_rad_.push_back(turned_rad_.back() + turn_rad);
    }
  }
  double until(const GridTime& at) const {
    const double whole = turned_rad_[at.period];
    return at.share == 0.0 ? whole : whole + at.share * (turned_rad_[at.period + 1] - whole);
  }

 private:
  std::vector<double> turned_rad_;
};

std::optional<Pose> reference_of(const DriveSample& sample, bool heading_alone) {
  if (!heading_alone) return sample.reference_pose();
  if (!sample.reference_theta_rad) return std::nullopt;
  return Pose{0.0, 0.0, *sample.reference_theta_rad};
}

bool flagged(const std::vector<char>& rows, std::size_t i) {
  return !rows.empty() && rows[i] != 0;
}

// How long a smoothed reference still shows what counts have missed.
double memory_s(const ReferenceResponse& response) {
  const auto until_s = [](const DelayKernel& kernel) { return kernel.mean_s() + kernel.rise_time_s(); };
  return response.is_immediate() ? 0.0 : std::max(until_s(response.position), until_s(response.heading));
}

void collect_references(const DriveLog& log, const RowFlags& flags, GapRun& run) {
  run.heading_alone = !log.has_reference_positions();
  const ExpectedTurn expected(run);
  bool restart = false;
  bool lost = false;
  double shown_until_s = -std::numeric_limits<double>::infinity();
  double heading = 0.0;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    const DriveSample& sample = log.samples[i];
    // Behind lost counts, too: the first that are sound tell only of what comes after them.
    const bool lost_before = lost;
    lost = flagged(flags.counts, i);
    if (lost || lost_before || flagged(flags.restart, i)) {
      restart = true;
      shown_until_s = sample.t_s + memory_s(log.reference_response);
    }
    if (sample.t_s < shown_until_s) restart = true;
    const std::optional<Pose> pose = reference_of(sample, run.heading_alone);
    if (!pose) continue;
    // Angles may wrap: full turns are counted here, of which there may be more than one between two readings.
    const GridTime at = grid_time(run, sample.t_s);
    const bool first = run.references.empty();
    if (!first) heading += expected.until(at) - expected.until(run.references.back().at);
    heading = first ? pose->theta_rad : heading + wrap_angle(pose->theta_rad - heading);
    run.references.push_back({at, {pose->x_m, pose->y_m, heading}, restart && !first});
    restart = false;
  }
}

Pose between(const Reference& a, const Reference& b, double share) {
  return {a.pose.x_m + share * (b.pose.x_m - a.pose.x_m), a.pose.y_m + share * (b.pose.y_m - a.pose.y_m),
          a.pose.theta_rad + share * (b.pose.theta_rad - a.pose.theta_rad)};
}

void lay_passed(GapRun& run) {
  std::size_t next = 1;
  for (std::size_t k = 0; k <= run.commands_m_s.size(); ++k) {
    const double time_s = run.period_s * static_cast<double>(k);
    while (next + 1 < run.references.size() && seconds_at(run, run.references[next].at) < time_s) ++next;
    const double from_s = seconds_at(run, run.references[next - 1].at);
    const double to_s = seconds_at(run, run.references[next].at);
    const double share = to_s > from_s ? std::clamp((time_s - from_s) / (to_s - from_s), 0.0, 1.0) : 1.0;
    run.passed.push_back(between(run.references[next - 1], run.references[next], share));
  }
}

bool far_apart(const GapRun& run) {
  if (run.references.size() < 2) return true;
  std::vector<double> between;
  for (std::size_t i = 1; i < run.references.size(); ++i) {
    between.push_back(seconds_at(run, run.references[i].at) - seconds_at(run, run.references[i - 1].at));
  }
  return median(std::move(between)) > sparse_from_s;
}

// What the gyro says that the robot turned beyond its counts.
void lay_gyro(const DriveLog& log, const RowFlags& flags, GapRun& run) {
  const ExpectedTurn counted(run);
  Series& turn = run[Channel::turn];
  std::size_t row = 0;
  bool lost = false;
  for (const GyroTurn& gyro : gyro_turns(log)) {
    bool restarts = lost;
    lost = false;
    for (; row <= gyro.row; ++row) {
      lost = lost || flagged(flags.counts, row);
      restarts = restarts || lost || flagged(flags.restart, row);
    }
    const GridTime at = grid_time(run, log.samples[gyro.row].t_s);
    turn.restarts.push_back(restarts && !turn.at.empty() ? 1 : 0);
    turn.at.push_back(at);
    turn.value.push_back(gyro.turned_rad - counted.until(at));
  }
  run.by_gyro = !turn.empty();
}

}  // namespace

double seconds_at(const GapRun& run, const GridTime& at) {
  return run.period_s * (static_cast<double>(at.period) + at.share);
}

GridTime earlier(const GapRun& run, const GridTime& at, double by_s) {
  if (by_s == 0.0) return at;
  const auto last = static_cast<double>(run.commands_m_s.size());
  const double time = std::clamp(static_cast<double>(at.period) + at.share - by_s / run.period_s, 0.0, last);
  const double whole = std::floor(time);
  return {static_cast<std::size_t>(whole), time - whole};
}

GapRun make_gap_run(const DriveLog& log, const RowFlags& flags, double period_s) {
  GapRun run;
  run.name = log.name;
  run.period_s = period_s;
  run.wheel_base_m = log.wheel_base_m;
  run.start_s = log.samples.front().t_s;
  lay_commands(log, run);
  lay_counts(log, flags, run);
  if (run.has_counts) lay_odometry(run);
  collect_references(log, flags, run);
  run.sparse = far_apart(run);
  run.reference_noise = log.reference_noise;
  if (!run.sparse) {
    if (run.has_counts) run.reference_response = log.reference_response;
    lay_passed(run);
    for (const Channel channel : {Channel::forward, Channel::aside, Channel::turn}) {
      if (run.heading_alone && channel != Channel::turn) continue;
      for (const auto& reference : run.references) {
        run[channel].at.push_back(reference.at);
        run[channel].restarts.push_back(reference.counts_lost ? 1 : 0);
      }
    }
  } else if (run.has_counts) {
    lay_gyro(log, flags, run);
  }
  return run;
}

GapRun part_of(const GapRun& run, std::size_t from, std::size_t to) {
  GapRun part = run;
  const auto inside = [&](const GridTime& at) { return at.period >= from && at.period < to; };
  for (Series& series : part.series) {
    Series kept;
    for (std::size_t i = 0; i < series.at.size(); ++i) {
      if (!inside(series.at[i])) continue;
      kept.at.push_back(series.at[i]);
      if (!series.value.empty()) kept.value.push_back(series.value[i]);
      kept.restarts.push_back(series.restarts[i]);
    }
    series = std::move(kept);
  }
  std::erase_if(part.references, [&](const Reference& reference) { return !inside(reference.at); });
  return part;
}

}  // namespace wheelwright::gap
