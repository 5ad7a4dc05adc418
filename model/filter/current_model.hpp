// What current a wheel's motor should draw, learnt while driving.
//
// Linear in what pulls at a wheel: direction (friction), speed, acceleration, direction and rate of turning
// (the scrub of the tyres), and heading (a floor that slopes). Fitted by recursive least squares with slow
// forgetting, on means over 0.25 s, since the wheel controller's ripple is as large as the current itself.
// What it is taught is older than 6 s, so that a change is seen before it is learnt; while a wheel stands
// nothing is learnt.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace wheelwright {

class CurrentModel {
 public:
  static constexpr int feature_count = 7;
  using Features = Eigen::Vector<double, feature_count>;

  // Of a wheel's speed (m/s), its acceleration (m/s^2), the difference to the other wheel's speed, and the
  // heading of the robot.
  static Features features(double speed_m_s, double acceleration_m_s2, double turning_m_s,
                           double heading_rad);

  // In amperes, signed as the speed.
  double expected_a(const Features& features) const { return weights_.dot(features); }
  // Standard deviation of a mean over 0.25 s about what is expected: its own, and that of the expectation
  // where little like it has been learnt yet.
  double spread_a(const Features& features) const;
  // Enough has been learnt to judge by it.
  bool ready() const { return learnt_ >= min_learnt; }

  // A mean over 0.25 s of driving that was sound.
  void take(const Features& features, double current_a);
  // What was not learnt yet, never will be.
  void forget_recent() { count_ = 0; }

 private:
  struct Sample {
    Features features = Features::Zero();
    double current_a = 0.0;
  };
  static constexpr std::size_t delay = 24;
  static constexpr int min_learnt = 24;

  void learn(const Sample& sample);
  double noise_a() const;

  Features weights_ = 0.1 * Features::Unit(0);
  Eigen::Matrix<double, feature_count, feature_count> covariance_ =
      100.0 * Eigen::Matrix<double, feature_count, feature_count>::Identity();
  double variance_a2_ = 0.03 * 0.03;
  int learnt_ = 0;
  std::array<Sample, delay> waiting_{};  // ring
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace wheelwright
