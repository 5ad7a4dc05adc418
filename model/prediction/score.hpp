// How far a model's free run and a measurement are apart.
//
// Each figure is a root mean square over all samples or windows, and absent where the log cannot show it. A
// difference of encoder counts is mostly noise (11.6 mm/s on a Create 2), which hides a wrong gain; so
// distance, position and heading are judged beside speed.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "model/log/drive_log.hpp"
#include "model/prediction/free_run.hpp"

namespace wheelwright {

// An error that grows with time belongs to the time over which it grew.
struct AtHorizon {
  double horizon_s = 0.0;
  double value = 0.0;
};

constexpr double longest_horizon_s = 10.0;
constexpr double between_windows_s = 1.0;  // of their starts

struct Score {
  // Mean speed of each wheel between two readings of the encoders.
  std::optional<double> wheel_speed_rms_m_s;
  // Travel of each wheel since the first reading, or since counts were lost (DriveSample::counter_reset).
  std::optional<double> distance_rms_m;
  // Displacement over the horizon, seen from the pose at its start; needs reference x, y and theta.
  std::optional<AtHorizon> position_rms_m;
  // Turn over the horizon; needs reference theta.
  std::optional<AtHorizon> heading_rms_rad;

  bool empty() const {
    return !wheel_speed_rms_m_s && !distance_rms_m && !position_rms_m && !heading_rms_rad;
  }
};

// Sums squared errors of any number of runs. A run's horizon is `longest_horizon_s`, or its span from first
// to last reference where that is shorter; windows start about every second. References that are too sparse
// for that (only the first and the last row, say) give one window from the first to the last. Runs of
// different horizons give the mean horizon of their windows.
class ScoreSums {
 public:
  // `predicted` holds one entry per row of `measured`, as free_run returns it.
  void add(Prediction predicted, const DriveLog& measured);
  // By several runs of one model (open_loop_runs): each window by the one that was told last where the robot
  // is, the wheels by the first.
  void add(std::span<const Prediction> runs, const DriveLog& measured);
  Score score() const;

 private:
  struct Sum {
    void add(double error);
    std::optional<double> rms() const;
    double squares = 0.0;
    std::size_t count = 0;
  };
  struct SumAtHorizon {
    std::optional<AtHorizon> rms() const;
    Sum errors;
    double horizons_s = 0.0;
  };

  void add_wheels(Prediction predicted, const DriveLog& measured);
  void add_poses(std::span<const Prediction> runs, const DriveLog& measured);
  void add_headings(std::span<const Prediction> runs, const DriveLog& measured);

  Sum wheel_speed_m_s_;
  Sum distance_m_;
  SumAtHorizon position_m_;
  SumAtHorizon heading_rad_;
};

// The score of one run.
Score score_run(Prediction predicted, const DriveLog& measured);

// Predicted minus measured travel of each wheel from the first to the last reading of the encoders.
std::optional<WheelPair> end_distance_error_m(Prediction predicted, const DriveLog& measured);

}  // namespace wheelwright
