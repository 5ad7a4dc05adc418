#include "model/simulation/linear_model.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <numeric>
#include <utility>

#include "model/simulation/poles.hpp"

namespace wheelwright {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// In four sums, none of which waits for another.
double dot(const std::vector<double>& weights, const double* history) {
  std::array<double, 4> sums{};
  const std::size_t size = weights.size();
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    for (std::size_t part = 0; part < 4; ++part) sums[part] += weights[i + part] * history[i + part];
  }
  for (; i < size; ++i) sums[i % 4] += weights[i] * history[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

double take_first(std::vector<double>& weights) {
  if (weights.empty()) return 0.0;
  const double first = weights.front();
  weights.erase(weights.begin());
  return first;
}

std::size_t longest_history(const std::vector<double>& one, const std::vector<double>& other) {
  const std::size_t longest = std::max(one.size(), other.size());
  return longest == 0 ? 0 : longest - 1;
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

LinearModel as_fir(const LinearModel& model) {
  if (model.type == ModelType::fir) return model;
  constexpr double negligible = 1e-5;
  constexpr std::size_t longest = 200;
  const double pole = std::max(largest_pole(model.left), largest_pole(model.right));
  const auto given = std::max({model.left.from_left.size(), model.left.from_right.size(),
                               model.right.from_left.size(), model.right.from_right.size()});
  std::size_t length = given;
  for (double left = 1.0; left > negligible && length < longest; left *= pole) ++length;
  LinearModel fir{ModelType::fir, model.period_s, model.wheel_base_m, {}, {}};
  const auto excite = [&](const WheelPair& impulse, std::vector<double>& of_left,
                          std::vector<double>& of_right) {
    LinearPredictor predictor(model);
    for (std::size_t k = 0; k < length; ++k) {
      const WheelPair speed = predictor.step(k == 0 ? impulse : WheelPair{});
      of_left.push_back(speed.left);
      of_right.push_back(speed.right);
    }
  };
  excite({1.0, 0.0}, fir.left.from_left, fir.right.from_left);
  excite({0.0, 1.0}, fir.left.from_right, fir.right.from_right);
  const auto keep_gain = [](WheelResponse& response, const DcGain& gain) {
    const DcGain cut = dc_gain(response);
    response.from_left.back() += gain.from_left - cut.from_left;
    response.from_right.back() += gain.from_right - cut.from_right;
  };
  keep_gain(fir.left, dc_gain(model.left));
  keep_gain(fir.right, dc_gain(model.right));
  return fir;
}

double largest_pole(const WheelResponse& response) {
  double largest = 0.0;
  for (const auto& pole : poles(response)) largest = std::max(largest, std::abs(pole));
  return largest;
}

// Values are written from the back of the buffer to its front; at the front the live part moves to the back.
// Short histories have room enough that this is seldom.
LinearPredictor::History::History(std::size_t length)
    : length_(length), at_(length), values_(length + std::max<std::size_t>(length + 1, 64), 0.0) {}

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
    : left_commands_(longest_history(model.left.from_left, model.right.from_left)),
      right_commands_(longest_history(model.left.from_right, model.right.from_right)),
      left_(wheel_of(model.left)),
      right_(wheel_of(model.right)) {}

LinearPredictor::Wheel LinearPredictor::wheel_of(WheelResponse response) {
  response = without_idle_weights(std::move(response));
  const WheelPair from_command{take_first(response.from_left), take_first(response.from_right)};
  const std::size_t length = response.from_own_past.size();
  return {from_command, std::move(response), History(length)};
}

WheelPair LinearPredictor::step(const WheelPair& command) {
  const WheelPair speed{output(left_, command), output(right_, command)};
  left_commands_.push(command.left);
  right_commands_.push(command.right);
  return speed;
}

double LinearPredictor::output(Wheel& wheel, const WheelPair& command) {
  const double of_now = wheel.from_command.left * command.left + wheel.from_command.right * command.right;
  const double of_commands = dot(wheel.from_history.from_left, left_commands_.newest()) +
                             dot(wheel.from_history.from_right, right_commands_.newest());
  const double y = of_now + of_commands + dot(wheel.from_history.from_own_past, wheel.past.newest());
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
