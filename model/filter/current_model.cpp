#include "model/filter/current_model.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

constexpr double forgetting = 0.999;  // about four minutes of driving
constexpr double spread_rate = 0.02;
constexpr double min_spread_a = 0.008;
constexpr double outlier = 4.0;
constexpr double largest_covariance = 1e4;  // what is not excited must not wind up

double soft_sign(double value, double scale) {
  return std::clamp(value / scale, -1.0, 1.0);
}

}  // namespace

CurrentModel::Features CurrentModel::features(double speed_m_s, double acceleration_m_s2, double turning_m_s,
                                              double heading_rad) {
  return Features{soft_sign(speed_m_s, 0.02),   speed_m_s,   acceleration_m_s2,
                  soft_sign(turning_m_s, 0.04), turning_m_s, std::cos(heading_rad),
                  std::sin(heading_rad)};
}

double CurrentModel::noise_a() const {
  return std::max(min_spread_a, std::sqrt(variance_a2_));
}

// The covariance of the weights is in units of the noise's variance.
double CurrentModel::spread_a(const Features& features) const {
  return noise_a() * std::sqrt(1.0 + features.dot(covariance_ * features));
}

void CurrentModel::take(const Features& features, double current_a) {
  if (count_ == delay) {
    learn(waiting_[next_]);
  } else {
    ++count_;
  }
  waiting_[next_] = {features, current_a};
  next_ = (next_ + 1) % delay;
}

void CurrentModel::learn(const Sample& sample) {
  const double limit_a = outlier * noise_a();
  double residual_a = sample.current_a - expected_a(sample.features);
  if (ready()) residual_a = std::clamp(residual_a, -limit_a, limit_a);
  if (learnt_ >= min_learnt / 2) {
    variance_a2_ += spread_rate * (residual_a * residual_a - variance_a2_);
  }
  const Features reach = covariance_ * sample.features;
  const Features gain = reach / (forgetting + sample.features.dot(reach));
  weights_ += gain * residual_a;
  covariance_ -= gain * reach.transpose();
  if (covariance_.trace() < largest_covariance) covariance_ /= forgetting;
  ++learnt_;
}

}  // namespace wheelwright
