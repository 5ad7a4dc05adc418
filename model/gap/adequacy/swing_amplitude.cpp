#include "model/gap/adequacy/swing_amplitude.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace wheelwright::gap {
namespace {

constexpr double window_periods = 4.0;

// Squared amplitude of the sine of one frequency beside a line; none where the values do not hold it.
std::optional<double> squared_amplitude(std::span<const double> values, std::span<const double> at,
                                        double frequency) {
  constexpr double least_pivot = 1e-3;  // of a value's share: below, rounding decides
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d moments = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double angle = 2.0 * std::numbers::pi * frequency * (at[k] - at.front());
    const double share = static_cast<double>(k) / static_cast<double>(values.size());
    const Eigen::Vector4d row(1.0, share - 0.5, std::cos(angle), std::sin(angle));
    information += row * row.transpose();
    moments += values[k] * row;
  }
  const Eigen::LDLT<Eigen::Matrix4d> solver(information);
  if (solver.vectorD().minCoeff() < least_pivot * static_cast<double>(values.size())) return std::nullopt;
  return solver.solve(moments).tail<2>().squaredNorm();
}

double beyond(double swing, double below, double above) {
  return std::max(0.0, swing - std::sqrt(below * above));
}

// The range that positions cover, one after the other.
struct Covered {
  explicit Covered(double at) : least(at), most(at) {}
  double with(double at) {
    least = std::min(least, at);
    most = std::max(most, at);
    return most - least;
  }
  double least;
  double most;
};

}  // namespace

void SwingAmplitude::Sums::add(double squared) {
  count += 1.0;
  squares += squared;
  squared_squares += squared * squared;
}

void SwingAmplitude::add_window(std::span<const double> values, std::span<const double> at,
                                const Window& window) {
  const auto squared = squared_amplitude(values, at, 1.0 / period_);
  const auto below = squared_amplitude(values, at, 0.75 / period_);
  const auto above = squared_amplitude(values, at, 1.25 / period_);
  if (!squared || !below || !above) return;
  if (*squared > strongest_squared_) {
    strongest_squared_ = *squared;
    strongest_ = window;
  }
  swing_.add(*squared);
  below_.add(*below);
  above_.add(*above);
}

// From the start, four periods after the other; what is left at the end is measured together with what lies
// before it.
void SwingAmplitude::add_part(std::span<const double> values, std::span<const double> at,
                              std::size_t offset) {
  const double width = window_periods * period_;
  const auto add_from = [&](std::size_t from, std::size_t to) {
    add_window(values.subspan(from, to - from), at.subspan(from, to - from),
               {series_, offset + from, offset + to});
  };
  std::size_t from = 0;
  Covered covered(at.front());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (covered.with(at[k]) < width) continue;
    add_from(from, k + 1);
    from = k + 1;
    if (from < values.size()) covered = Covered(at[from]);
  }
  if (from == values.size()) return;
  Covered backward(at.back());
  for (std::size_t k = values.size(); k-- > 0;) {
    if (backward.with(at[k]) >= width) return add_from(k, values.size());
  }
}

void SwingAmplitude::add(std::span<const double> values, std::span<const double> at,
                         std::span<const char> breaks) {
  for (std::size_t from = 0; from < values.size();) {
    std::size_t to = from + 1;
    while (to < values.size() && (breaks.empty() || breaks[to] == 0)) ++to;
    add_part(values.subspan(from, to - from), at.subspan(from, to - from), from);
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
