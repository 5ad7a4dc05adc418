#include "model/gap/adequacy/swing_amplitude.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace wheelwright::gap {
namespace {

constexpr double window_periods = 4.0;

// Squared amplitude of the sine of one frequency beside a line.
double squared_amplitude(std::span<const double> values, std::span<const double> at, double frequency) {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d moments = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double angle = 2.0 * std::numbers::pi * frequency * (at[k] - at.front());
    const double share = static_cast<double>(k) / static_cast<double>(values.size());
    const Eigen::Vector4d row(1.0, share - 0.5, std::cos(angle), std::sin(angle));
    information += row * row.transpose();
    moments += values[k] * row;
  }
  const Eigen::Vector4d solution = information.ldlt().solve(moments);
  return solution.tail<2>().squaredNorm();
}

double beyond(double swing, double below, double above) {
  return std::max(0.0, swing - std::sqrt(below * above));
}

}  // namespace

void SwingAmplitude::Sums::add(double squared) {
  count += 1.0;
  squares += squared;
  squared_squares += squared * squared;
}

void SwingAmplitude::add(std::span<const double> values, std::span<const double> at) {
  for (std::size_t from = 0; from < values.size();) {
    std::size_t to = from;
    while (to < values.size() && std::abs(at[to] - at[from]) < window_periods * period_) ++to;
    if (to == values.size()) break;
    const auto part = values.subspan(from, to - from);
    const auto where = at.subspan(from, to - from);
    const double squared = squared_amplitude(part, where, 1.0 / period_);
    if (squared > strongest_squared_) {
      strongest_squared_ = squared;
      strongest_ = {series_, from, to};
    }
    swing_.add(squared);
    below_.add(squared_amplitude(part, where, 0.5 / period_));
    above_.add(squared_amplitude(part, where, 1.5 / period_));
    from = to;
  }
  ++series_;
}

double SwingAmplitude::amplitude() const {
  return std::sqrt(beyond(swing_.weighted_mean(), below_.weighted_mean(), above_.weighted_mean()));
}

double SwingAmplitude::mean_square() const {
  return beyond(swing_.mean(), below_.mean(), above_.mean());
}

}  // namespace wheelwright::gap
