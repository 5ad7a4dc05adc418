#include "tools/wheelwright/gap/simulated_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/import/conversion/repair_checks.hpp"
#include "tools/wheelwright/import/conversion/stream_time.hpp"
#include "tools/wheelwright/import/import_files.hpp"

namespace wheelwright::tools {
namespace {

double duration_s(const DriveLog& log) {
  return log.samples.back().t_s - log.samples.front().t_s;
}

bool tells_motion(const DriveSample& sample) {
  return sample.ticks || sample.reference_x_m || sample.reference_theta_rad;
}

// How far a drive goes and turns, by its commands or by its reference poses.
struct Motion {
  double travel_m = 0.0;
  double turn_rad = 0.0;
};

Motion commanded_motion(const DriveLog& log) {
  Motion sum;
  for (std::size_t row = 0; row + 1 < log.samples.size(); ++row) {
    const double period_s = log.samples[row + 1].t_s - log.samples[row].t_s;
    const Twist twist = twist_of_wheels(log.samples[row].command_m_s, log.wheel_base_m);
    sum.travel_m += std::abs(twist.v_m_s) * period_s;
    sum.turn_rad += std::abs(twist.w_rad_s) * period_s;
  }
  return sum;
}

// A step of a full turn or less can be a heading that wraps.
double turned_rad(double change) {
  return std::abs(std::abs(change) > 2.0 * std::numbers::pi ? change : wrap_angle(change));
}

// Between poses so far apart that noise adds up to little.
Motion simulated_motion(const DriveLog& log) {
  constexpr double apart_s = 0.3;
  Motion sum;
  const DriveSample* last = nullptr;
  for (const DriveSample& sample : log.samples) {
    if (!sample.reference_x_m && !sample.reference_theta_rad) continue;
    if (last != nullptr && sample.t_s - last->t_s < apart_s) continue;
    if (last != nullptr && sample.reference_x_m && last->reference_x_m)
      sum.travel_m += std::hypot(*sample.reference_x_m - *last->reference_x_m,
                                 sample.reference_y_m.value_or(0.0) - last->reference_y_m.value_or(0.0));
    if (last != nullptr && sample.reference_theta_rad && last->reference_theta_rad)
      sum.turn_rad += turned_rad(*sample.reference_theta_rad - *last->reference_theta_rad);
    last = &sample;
  }
  return sum;
}

constexpr double min_share = 0.9;  // of a run, that a simulation of it has to hold

std::string last_of(const DriveLog& real) {
  return ", but the commands of " + real.name + " last " + config::fixed_number(duration_s(real), 1) + " s";
}

void check_that_it_moves(const DriveLog& simulated, const DriveLog& real) {
  constexpr double hardly = 0.01;
  constexpr double least_asked = 0.5;  // metres, radians
  const bool has_poses = std::ranges::any_of(simulated.samples, [](const DriveSample& sample) {
    return sample.reference_x_m || sample.reference_theta_rad;
  });
  const Motion asked = commanded_motion(real);
  const Motion motion = simulated_motion(simulated);
  if (simulated.has_ticks() || !has_poses || asked.travel_m + asked.turn_rad < least_asked ||
      motion.travel_m + motion.turn_rad > hardly * (asked.travel_m + asked.turn_rad))
    return;
  throw UsageError(simulated.name + ": the robot stands still, but its commands are for " +
                   config::fixed_number(asked.travel_m, 1) + " m and " +
                   config::fixed_number(asked.turn_rad, 1) + " rad");
}

double commanded_since(const DriveLog& log, double t_s) {
  DriveLog rest = log;
  std::erase_if(rest.samples, [&](const DriveSample& sample) { return sample.t_s < t_s; });
  const Motion motion = commanded_motion(rest);
  return motion.travel_m + motion.turn_rad;
}

bool is_same_pose(const DriveSample& one, const DriveSample& other) {
  return one.reference_x_m == other.reference_x_m && one.reference_y_m == other.reference_y_m &&
         one.reference_theta_rad == other.reference_theta_rad;
}

// A simulator that has hung writes its last pose again and again.
void check_that_it_goes_on(const DriveLog& simulated, const DriveLog& real) {
  constexpr double least_asked = 0.5;  // metres and radians
  if (simulated.has_ticks()) return;
  const DriveSample* last = nullptr;
  double moved_s = 0.0;  // when the pose last changed
  const double start_s = simulated.samples.front().t_s;
  for (const DriveSample& sample : simulated.samples) {
    if (!sample.reference_x_m && !sample.reference_theta_rad) continue;
    if (last != nullptr && !is_same_pose(*last, sample)) moved_s = sample.t_s - start_s;
    last = &sample;
  }
  const double rolls_out_s = 1.0;
  if (last == nullptr ||
      commanded_since(real, real.samples.front().t_s + moved_s + rolls_out_s) < least_asked)
    return;
  throw UsageError(simulated.name + ": the robot stands still from " + config::fixed_number(moved_s, 1) +
                   " s on, but its commands are for motion");
}

// Places that end before the headings do are those of a simulation without numbers.
void check_that_places_go_on(const DriveLog& simulated) {
  constexpr double longest_s = 1.0;
  double place_s = 0.0;
  double heading_s = 0.0;
  bool has_places = false;
  for (const DriveSample& sample : simulated.samples) {
    const double t_s = sample.t_s - simulated.samples.front().t_s;
    if (sample.reference_x_m && sample.reference_y_m) {
      place_s = t_s;
      has_places = true;
    }
    if (sample.reference_theta_rad) heading_s = t_s;
  }
  if (!has_places || heading_s < place_s + longest_s) return;
  throw UsageError(simulated.name + ": no numbers for x and y after " + config::fixed_number(place_s, 1) +
                   " s, but headings until " + config::fixed_number(heading_s, 1) +
                   " s; the simulation diverges");
}

// Millimetres and degrees are plain numbers, too.
void check_units(const DriveLog& simulated, const DriveLog& real) {
  constexpr double times = 10.0;
  const Motion asked = commanded_motion(real);
  const Motion motion = simulated_motion(simulated);
  if (motion.travel_m > times * std::max(asked.travel_m, 1.0)) {
    throw UsageError(simulated.name + ": the robot goes " + config::fixed_number(motion.travel_m, 0) +
                     " m, but its commands are for " + config::fixed_number(asked.travel_m, 1) +
                     " m; if its positions are in mm give --simulation-set reference.unit=mm");
  }
  if (motion.turn_rad > times * std::max(asked.turn_rad, 1.0)) {
    throw UsageError(simulated.name + ": the robot turns by " + config::fixed_number(motion.turn_rad, 0) +
                     " rad, but its commands are for " + config::fixed_number(asked.turn_rad, 1) +
                     " rad; if its headings are in degrees give --simulation-set reference.angle_unit=deg");
  }
}

void check_length(const DriveLog& simulated, const DriveLog& real) {
  if (duration_s(simulated) < min_share * duration_s(real)) {
    throw UsageError(simulated.name + ": ends after " + config::fixed_number(duration_s(simulated), 1) +
                     " s" + last_of(real));
  }
}

// A simulation that diverges leaves places where no robot comes, or rows without numbers.
void check_divergence(const DriveLog& simulated) {
  constexpr double farthest_m = 1e4;
  for (const DriveSample& sample : simulated.samples) {
    const double far_m = std::hypot(sample.reference_x_m.value_or(0.0), sample.reference_y_m.value_or(0.0));
    if (far_m <= farthest_m) continue;
    throw UsageError(simulated.name + ": after " +
                     config::fixed_number(sample.t_s - simulated.samples.front().t_s, 1) +
                     " s the robot is " + config::plain_number(far_m) + " m away; the simulation diverges");
  }
}

// Where poses and counts end before the commands do, what is wrong; else nothing.
std::string end_of_motion(const DriveLog& simulated, const DriveLog& real) {
  const auto& samples = simulated.samples;
  const auto last = std::find_if(samples.rbegin(), samples.rend(), tells_motion);
  const double told_s = last == samples.rend() ? 0.0 : last->t_s - samples.front().t_s;
  if (told_s >= min_share * duration_s(real)) return "";
  return simulated.name + ": neither poses nor counts after " + config::fixed_number(told_s, 1) + " s" +
         last_of(real);
}

// Commands and simulator have to count the same time.
void check_clock(const import::Understood& simulated, const DriveLog& real, const std::string& out) {
  constexpr double longest_s = 0.5;
  for (const import::Recording& recording : simulated.recordings) {
    for (const import::Stream& stream : recording.streams) {
      const std::vector<double> t_s = import::stream_times(stream, simulated.mapping.time);
      if (t_s.empty() || !std::isfinite(t_s.front())) continue;
      if (std::abs(t_s.front()) < std::max(longest_s, 3.0 * real.period_s)) continue;
      throw UsageError(out + ": its first row is of " + config::plain_number(t_s.front()) +
                       " s, the first command of 0 s; write the times of the commands");
    }
  }
}

// A simulator that writes poses alone was driven by the commands that it was given.
DriveLog load_with_commands(const SimulatorRun& run, const import::GivenMapping& given, std::ostream& err) {
  const std::string out = run.out.string();
  const auto both = import::understand({{run.commands, run.out}, std::nullopt, given});
  auto conversion = both ? import::to_runs(*both) : tl::unexpected(both.error());
  if (!conversion) throw UsageError(conversion.error());
  if (conversion->runs.size() != 1)
    throw UsageError(out + ": holds " + std::to_string(conversion->runs.size()) +
                     " runs, but one was asked for");
  const auto& reference = both->mapping.reference;
  if (reference && reference->scale_from_robot)
    throw UsageError(out +
                     ": its positions are in no unit of length; give --simulation-set reference.unit=m, or "
                     "the unit in which they are");
  for (const auto& doubt : both->inference.doubts) err << "wheelwright: " << out << ": " << doubt << "\n";
  for (const auto& remark : conversion->remarks) err << "wheelwright: " << out << ": " << remark << "\n";
  DriveLog simulated = std::move(conversion->runs.front());
  simulated.name = out;
  return simulated;
}

// What it was given and does not write again are commands and wheel base.
DriveLog load_unchecked(const SimulatorRun& run, const DriveLog& real, ImportOptions options,
                        std::ostream& err) {
  const std::string out = run.out.string();
  if (import::is_drive_log(out)) return load_one_run({{out}, options}, err);
  const import::GivenMapping given(options.mapping, options.settings);
  const auto alone = import::understand({{run.out}, std::nullopt, given});
  if (alone && !alone->mapping.command) {
    check_clock(*alone, real, out);
    return load_with_commands(run, given, err);
  }
  if (alone && !alone->mapping.wheel_base_m)
    options.settings.push_back("robot.wheel_base_m=" + config::plain_number(real.wheel_base_m));
  return load_one_run({{out}, options}, err);
}

}  // namespace

void check_simulation_run(const DriveLog& simulated, std::ostream& err) {
  check_divergence(simulated);
  check_that_places_go_on(simulated);
  check_that_it_moves(simulated, simulated);
  check_that_it_goes_on(simulated, simulated);
  if (const std::string end = end_of_motion(simulated, simulated); !end.empty())
    err << "wheelwright: " << end << "\n";
}

DriveLog load_simulated_run(const SimulatorRun& run, const DriveLog& real, const ImportOptions& options,
                            std::ostream& err) {
  DriveLog simulated = load_unchecked(run, real, options, err);
  check_length(simulated, real);
  check_divergence(simulated);
  if (std::string end = end_of_motion(simulated, real); !end.empty()) throw UsageError(end);
  check_that_places_go_on(simulated);
  check_that_it_moves(simulated, real);
  check_that_it_goes_on(simulated, real);
  check_units(simulated, real);
  return simulated;
}

}  // namespace wheelwright::tools
