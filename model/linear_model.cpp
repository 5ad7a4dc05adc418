#include "model/linear_model.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

namespace wheelwright {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double dot(const std::vector<double>& weights, const double* history) {
  return std::inner_product(weights.begin(), weights.end(), history, 0.0);
}

// Most wheels know nothing of the other one's command: a row of zeros need not be summed in every sample.
WheelResponse without_idle_weights(WheelResponse response) {
  for (auto* weights : {&response.from_left, &response.from_right, &response.from_own_past}) {
    while (!weights->empty() && weights->back() == 0.0) weights->pop_back();
  }
  return response;
}

}  // namespace

DcGain dc_gain(const WheelResponse& response) {
  const double rest = 1.0 - sum(response.from_own_past);
  return {sum(response.from_left) / rest, sum(response.from_right) / rest};
}

TwistResponse twist_response(const LinearModel& model, std::size_t length) {
  TwistResponse result;
  const auto excite = [&](const WheelPair& impulse, std::vector<double>& v, std::vector<double>& w) {
    LinearPredictor predictor(model);
    for (std::size_t k = 0; k < length; ++k) {
      const WheelPair speed = predictor.step(k == 0 ? impulse : WheelPair{});
      const Twist twist = twist_of_wheels(speed, model.wheel_base_m);
      v.push_back(twist.v_m_s);
      w.push_back(twist.w_rad_s);
    }
  };
  excite({1.0, 0.0}, result.v_from_left, result.w_from_left);
  excite({0.0, 1.0}, result.v_from_right, result.w_from_right);
  return result;
}

double largest_pole(const WheelResponse& response) {
  const auto order = static_cast<Eigen::Index>(response.from_own_past.size());
  if (order == 0) return 0.0;
  // The poles are the eigenvalues of the companion matrix of the recursion.
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
  for (Eigen::Index i = 0; i < order; ++i) {
    companion(0, i) = response.from_own_past[static_cast<std::size_t>(i)];
  }
  companion.diagonal(-1).setOnes();
  return companion.eigenvalues().cwiseAbs().maxCoeff();
}

LinearPredictor::History::History(std::size_t length)
    : length_(length), at_(length), values_(2 * length + 1, 0.0) {}

// Values are written from the back of the buffer to its front; at the front the live part moves to the back.
void LinearPredictor::History::push(double value) {
  if (length_ == 0) return;
  if (at_ == 0) {
    std::copy_backward(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(length_),
                       values_.end());
    at_ = values_.size() - length_;
  }
  values_[--at_] = value;
}

void LinearPredictor::History::clear() {
  std::fill(values_.begin(), values_.end(), 0.0);
}

LinearPredictor::LinearPredictor(const LinearModel& model)
    : left_commands_(std::max(model.left.from_left.size(), model.right.from_left.size())),
      right_commands_(std::max(model.left.from_right.size(), model.right.from_right.size())),
      left_{without_idle_weights(model.left), History(model.left.from_own_past.size())},
      right_{without_idle_weights(model.right), History(model.right.from_own_past.size())} {}

WheelPair LinearPredictor::step(const WheelPair& command) {
  left_commands_.push(command.left);
  right_commands_.push(command.right);
  return {output(left_), output(right_)};
}

double LinearPredictor::output(Wheel& wheel) {
  const double y = dot(wheel.response.from_left, left_commands_.newest()) +
                   dot(wheel.response.from_right, right_commands_.newest()) +
                   dot(wheel.response.from_own_past, wheel.past.newest());
  wheel.past.push(y);
  return y;
}

void LinearPredictor::reset() {
  left_commands_.clear();
  right_commands_.clear();
  left_.past.clear();
  right_.past.clear();
}

}  // namespace wheelwright
