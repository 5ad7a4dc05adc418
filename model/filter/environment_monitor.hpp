// Has the robot's world changed for good: another floor, another load, worn wheels? Then the model is due to
// be made again.
//
// Three signs, each of both wheels, since what concerns one wheel is a fault of that wheel:
//   * motor currents against what the motion should need (current_model.hpp): cumulative sums
//     (CUSUM) over means of 0.25 s of driving, upwards, downwards, and of the size of the deviation (a floor
//     that scrubs pulls at both wheels in turn). Both wheels are added up, and each alone has to show a
//     quarter of it. Where the robot controls its wheel speeds by itself, this is nearly all that a floor
//     changes,
//   * power of the travel innovations against its usual power, by CUSUM for each wheel, of which the smaller
//     counts (it hangs together between wheels): starting and stopping have become different,
//   * a lasting drift or misfit of both encoders against the model alike, as the fault detector reports it,
//     or another gain of both wheels than the model has (gain_misfit.hpp).
//
// Only driving counts; while the robot stands, and while a wheel has a fault, nothing is added up and nothing
// is learnt. The verdict stays until recalibrated() is called. Before about 12 s of driving the usual values
// are not known and nothing but the last is reported; nor is anything in the first quarter of a second of
// driving backward, which shows what sign currents have. A floor that has less grip but pulls no harder does
// not show.
#pragma once

#include <array>
#include <cstdint>

#include "model/filter/current_model.hpp"
#include "model/filter/current_sign.hpp"
#include "model/filter/usual_level.hpp"
#include "model/geometry/pose.hpp"

namespace wheelwright {

struct DrivingEvidence {
  bool received = false;
  bool sound = false;   // driven, and no wheel has a fault
  WheelPair speed_m_s;  // of the model
  WheelPair acceleration_m_s2;
  double heading_rad = 0.0;
  WheelPair current_a;
  WheelPair innovation;      // in standard deviations
  bool both_misfit = false;  // both encoders have left the model alike
};

class EnvironmentMonitor {
 public:
  explicit EnvironmentMonitor(double period_s);

  // Takes a tick. Returns true where this tick raises the verdict.
  bool take(const DrivingEvidence& evidence);

  bool recalibration_due() const { return due_; }
  // The model has been made again: what is usual is learnt again.
  void recalibrated();

  // Motor current beyond what the motion needs, in its direction, smoothed over about 0.1 s. Until the need
  // is known: beyond a multiple of what driving has taken so far, or 0.
  const WheelPair& excess_a() const { return excess_a_; }

  // The tests themselves, in standard deviations added up; the verdict is at 1.
  double current_score() const;
  double innovation_score() const;

 private:
  struct Sums {
    double more = 0.0;  // of current, upwards and downwards
    double less = 0.0;
    double other = 0.0;    // of its deviation to either side
    double rougher = 0.0;  // of innovation power
  };
  // Of one block, in standard deviations.
  struct BlockScore {
    double current = 0.0;
    double other = 0.0;
    double power = 0.0;
  };
  struct Wheel {
    CurrentModel model;
    UsualLevel power;
    CurrentModel::Features features = CurrentModel::Features::Zero();  // sums over the block
    double current_a = 0.0;
    double innovation2 = 0.0;
    double driving_a = 0.0;  // mean of all ticks of sound driving so far
    int driving_ticks = 0;
    Sums sums;
  };

  void add_tick(Wheel& wheel, const CurrentModel::Features& features, double current_a, double innovation,
                double& excess_a) const;
  double excess_of(const Wheel& wheel, const CurrentModel::Features& features, double current_a) const;
  BlockScore close_block(Wheel& wheel) const;
  void add_up(const BlockScore& left, const BlockScore& right);
  double score_of(double Sums::*sum) const;
  void drop_block();

  bool currents_are_known(const DrivingEvidence& evidence);

  int ticks_per_block_;
  int settle_ticks_ = 0;  // after a fault, until its traces have gone
  int ticks_ = 0;
  CurrentSign current_sign_;
  std::array<Wheel, 2> wheels_;
  Sums both_;
  WheelPair excess_a_;
  bool due_ = false;
};

}  // namespace wheelwright
