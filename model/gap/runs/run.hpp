// One run as the gap workflow sees it: commands on the grid of model periods, and what was measured, as
// series of travel that a model's motion can be compared with.
//
// Everything is compared in the integrated domain. A series is a sum of increments:
//   left, right   travel of each wheel by its encoder, m
//   forward, aside, turn   motion of the reference point between two reference poses, m, m, rad, seen in the
//                 direction halfway through the turn. Where there are counts too, this is what the motion has
//                 beyond odometry: slip and geometry, without the motors.
// Where references tell the heading alone, there is no other channel of motion than `turn`.
// Where there are counts and a gyro, but no dense references, the gyro tells of `turn` (gyro_turns.hpp).
// References that lie far apart (`sparse`) are not summed: each segment between two of them is one reading,
// and odometry is integrated along it together with what the model adds.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright::gap {

enum class Channel { left, right, forward, aside, turn };
constexpr std::size_t channel_count = 5;
// A moment on the grid: so many whole periods after the start, and a share of the next.
struct GridTime {
  std::size_t period = 0;
  double share = 0.0;
};

struct Series {
  std::vector<GridTime> at;
  std::vector<double> value;   // since the first reading
  std::vector<char> restarts;  // 1 where nothing is known of the time since the reading before
  bool empty() const { return at.size() < 2; }
};

struct Reference {
  GridTime at;
  Pose pose;
  bool counts_lost = false;  // since the reference before
};

// Body motion by odometry over one period.
struct OdometryStep {
  double forward_m = 0.0;
  double turn_rad = 0.0;
};

struct GapRun {
  std::string name;
  double period_s = 0.0;
  double wheel_base_m = 0.0;
  double start_s = 0.0;                 // time of the first row
  std::vector<WheelPair> commands_m_s;  // one per period
  std::vector<double> battery_v;        // one per period; not-a-number where unknown
  WheelPair initial_travel_m;           // tells the angle at which the wheels stood at the start
  std::array<Series, channel_count> series;
  std::vector<Reference> references;  // with x, y and heading
  std::vector<Pose> passed;           // references interpolated at each grid point; empty if sparse
  bool heading_alone = false;         // of the references; then they say nothing of x and y
  bool has_counts = false;
  bool sparse = false;                       // references are far apart
  std::optional<PoseNoise> reference_noise;  // where it is known
  ReferenceResponse reference_response;      // of near references beside counts; else empty
  bool by_gyro = false;                      // `turn` is what a gyro says, with its drift and scale
  std::vector<OdometryStep> odometry;        // one per period, where there are counts

  const Series& operator[](Channel channel) const { return series[static_cast<std::size_t>(channel)]; }
  Series& operator[](Channel channel) { return series[static_cast<std::size_t>(channel)]; }
  double duration_s() const { return period_s * static_cast<double>(commands_m_s.size()); }
};

// Rows of a log that must not be used, as the data gate found them; one flag per row.
struct RowFlags {
  std::vector<char> counts;   // the counts of this row are not to be trusted
  std::vector<char> restart;  // counts or references jumped before this row
};

// Since the start of the run.
double seconds_at(const GapRun& run, const GridTime& at);

// So much earlier on a run's grid; not before its start.
GridTime earlier(const GapRun& run, const GridTime& at, double by_s);

// `flags` may be empty. The grid's period is `period_s`.
GapRun make_gap_run(const DriveLog& log, const RowFlags& flags, double period_s);

// A part of a run as a run of its own: readings whose grid time lies in [from, to) periods; the commands
// stay, so that the model arrives with its past.
GapRun part_of(const GapRun& run, std::size_t from, std::size_t to);

}  // namespace wheelwright::gap
