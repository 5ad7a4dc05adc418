// The linear part of a robot's model: commands of both wheels in, speeds of both wheels out (eq. 1 of the
// source paper).
//
// For each wheel, with u the commands, y its speed and k counting periods,
//
//   y(k) = sum_i from_left[i] u_left(k-i) + sum_i from_right[i] u_right(k-i) + sum_i from_own_past[i]
//   y(k-1-i)
//
// u(k) is the command in force from tick k to tick k+1, y(k) the mean speed over the same interval, both in
// m/s (in the robot's command units where the wheel PID is off). Without the last sum this is the paper's
// moving average (FIR): from_left and from_right are then impulse responses. The paper states the outputs as
// v and w; these are exact linear combinations of the wheel speeds (twist_response below), and wheels are
// what the encoders measure and what physical effects act on.
#pragma once

#include <cstddef>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/geometry/sensor_period.hpp"

namespace wheelwright {

enum class ModelType { fir, arma };

// How one wheel answers.
struct WheelResponse {
  std::vector<double> from_left;      // weight of the left command, i periods ago
  std::vector<double> from_right;     // weight of the right command, i periods ago
  std::vector<double> from_own_past;  // weight of the wheel's own speed, i+1 periods ago; empty for FIR
};

struct LinearModel {
  ModelType type = ModelType::fir;
  double period_s = default_period_s;
  double wheel_base_m = 0.235;
  WheelResponse left;
  WheelResponse right;
};

// Speed that a wheel settles at for a constant command of 1 on one side.
struct DcGain {
  double from_left = 0.0;
  double from_right = 0.0;
};
DcGain dc_gain(const WheelResponse& response);

// Impulse responses of v and w to each motor (eq. 8-10), `length` periods long. A free run of the model, so
// it holds for both types.
struct TwistResponse {
  std::vector<double> v_from_left;  // per unit of command
  std::vector<double> v_from_right;
  std::vector<double> w_from_left;   // 1/m
  std::vector<double> w_from_right;  // 1/m
};
TwistResponse twist_response(const LinearModel& model, std::size_t length);

// The same answers as impulse responses (type fir). A tail that decays beyond 200 periods is cut there; the
// gain stays.
LinearModel as_fir(const LinearModel& model);

// Size of the largest pole of one wheel's recursion; 0 for FIR. Below 1 is stable.
double largest_pole(const WheelResponse& response);

// Runs a LinearModel forward one period at a time, from rest. Allocates when it is made and never after:
// copying one predictor onto another of the same model does not allocate either.
class LinearPredictor {
 public:
  explicit LinearPredictor(const LinearModel& model);

  // Takes the command of one period and returns the mean wheel speeds over that period.
  WheelPair step(const WheelPair& command);

  // Puts the model to rest: all past commands and speeds zero.
  void reset();

 private:
  // The last `length` values, newest first, as one contiguous run.
  class History {
   public:
    explicit History(std::size_t length);
    void push(double value);
    const double* newest() const { return values_.data() + at_; }
    void clear();

   private:
    std::size_t length_;
    std::size_t at_;
    std::vector<double> values_;
  };

  // Weights of the command in force, and of what is in the histories.
  struct Wheel {
    WheelPair from_command;
    WheelResponse from_history;
    History past;
  };

  static Wheel wheel_of(WheelResponse response);
  double output(Wheel& wheel, const WheelPair& command);

  History left_commands_;
  History right_commands_;
  Wheel left_;
  Wheel right_;
};

}  // namespace wheelwright
