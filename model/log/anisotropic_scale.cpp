#include "model/log/anisotropic_scale.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/log/counted_windows.hpp"
#include "model/statistics/dense_solve.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright {
namespace {

constexpr double sure_anisotropy = 5.0;     // standard errors
constexpr double matters = 0.003;           // of a and b together
constexpr double no_camera = 0.3;           // likewise
constexpr double largest_difference = 0.5;  // of halves, relative
constexpr double delay_step_s = 0.02;
constexpr double longest_delay_s = 0.4;  // for which the counts around a window are needed

// Least squares over windows; how the result changes without each of them says how sure it is.
struct Estimate {
  Eigen::VectorXd value;
  Eigen::MatrixXd covariance;
};

std::optional<Eigen::VectorXd> solution(const Eigen::MatrixXd& products) {
  const Eigen::Index count = products.cols() - 1;
  return solve_positive(products.topLeftCorner(count, count), products.col(count).head(count));
}

std::optional<Estimate> estimate(const std::vector<Eigen::MatrixXd>& windows) {
  if (windows.size() < least_counted_windows) return std::nullopt;
  const Eigen::Index count = windows.front().cols() - 1;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(count + 1, count + 1);
  for (const auto& window : windows) sum += window;
  const auto all = solution(sum);
  if (!all) return std::nullopt;
  Estimate result{*all, Eigen::MatrixXd::Zero(count, count)};
  for (const auto& window : windows) {
    const auto without = solution(sum - window);
    if (!without) return std::nullopt;
    result.covariance += (*without - *all) * (*without - *all).transpose();
  }
  const auto clusters = static_cast<double>(windows.size());
  result.covariance *= (clusters - 1.0) / clusters;
  return result;
}

// Of the first two values, in standard errors.
double sureness(const Estimate& estimate) {
  const Eigen::VectorXd value = estimate.value.head(2);
  return std::sqrt(value.dot(solve_symmetric(estimate.covariance.topLeftCorner(2, 2), value)));
}

// Whether each half of the windows has about the same first two values: what a few windows alone show is what
// the robot met there.
bool halves_agree(const std::vector<Eigen::MatrixXd>& windows, const Estimate& estimate) {
  for (const std::size_t half : {0UL, 1UL}) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(windows.front().rows(), windows.front().cols());
    for (std::size_t i = half; i < windows.size(); i += 2) sum += windows[i];
    const auto own = solution(sum);
    const Eigen::Vector2d value = estimate.value.head<2>();
    if (!own || (own->head<2>() - value).norm() > largest_difference * value.norm()) return false;
  }
  return true;
}

bool is_sure(const std::vector<Eigen::MatrixXd>& windows, const std::optional<Estimate>& estimate) {
  return estimate && sureness(*estimate) >= sure_anisotropy && halves_agree(windows, *estimate);
}

Eigen::MatrixXd position_products(const CountedWindow& window, const DelayKernel& kernel) {
  const PathInFrame path(window);
  const auto shown_at = [&](double t_s) {
    return filtered<Eigen::Vector2d>(kernel, t_s, [&](double when_s) { return path.at(when_s); });
  };
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(2 * window.shown.size()), 5);
  Eigen::Index row = 0;
  for (const ShownPose& shown : window.shown) {
    const Eigen::Vector2d p = shown_at(shown.t_s);
    columns.row(row) << p.x(), p.y(), p.x(), 0.0, shown.pose.x_m;
    columns.row(row + 1) << -p.y(), p.x(), p.y(), 0.0, shown.pose.y_m;
    columns.block<2, 1>(row, 3) = shown_at(shown.t_s + delay_step_s) - shown_at(shown.t_s - delay_step_s);
    row += 2;
  }
  return products_beside(drift_of_position(window, path), columns);
}

Eigen::MatrixXd heading_products(const CountedWindow& window, const DelayKernel& kernel) {
  const auto shown_at = [&](double t_s) {
    return filtered<double>(kernel, t_s, [&](double when_s) { return window.path.at(when_s).theta_rad; });
  };
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(window.shown.size()), 5);
  Eigen::Index row = 0;
  for (const ShownPose& shown : window.shown) {
    const double twice_rad = 2.0 * shown.pose.theta_rad;
    columns.row(row++) << -std::sin(twice_rad), std::cos(twice_rad), shown_at(shown.t_s),
        shown_at(shown.t_s + delay_step_s) - shown_at(shown.t_s - delay_step_s), shown.pose.theta_rad;
  }
  return products_beside(drift_of_heading(window), columns);
}

}  // namespace

double AnisotropicScale::largest_over_least() const {
  const double size = std::hypot(along, oblique);
  return (1.0 + size) / (1.0 - size);
}

double AnisotropicScale::longest_direction_rad() const {
  const double direction = 0.5 * std::atan2(oblique, along);
  return direction < 0.0 ? direction + std::numbers::pi : direction;
}

std::optional<AnisotropicScale> find_anisotropic_scale(std::span<const DriveLog* const> runs) {
  std::vector<Eigen::MatrixXd> positions;
  std::vector<Eigen::MatrixXd> headings;
  const ReferenceResponse response = runs.empty() ? ReferenceResponse{} : runs.front()->reference_response;
  for_each_window(runs, longest_delay_s, longest_delay_s, [&](const CountedWindow& window) {
    if (!window.shown.front().has_position) return;
    positions.push_back(position_products(window, response.position));
    headings.push_back(heading_products(window, response.heading));
  });
  const auto position = estimate(positions);
  if (!is_sure(positions, position) || !(position->value(2) > 0.0)) return std::nullopt;
  AnisotropicScale scale{position->value(2), position->value(0) / position->value(2),
                         position->value(1) / position->value(2)};
  const double size = std::hypot(scale.along, scale.oblique);
  if (size < matters || size > no_camera) return std::nullopt;
  const auto heading = estimate(headings);
  if (is_sure(headings, heading)) {
    scale.heading_along_rad = heading->value(0);
    scale.heading_oblique_rad = heading->value(1);
  }
  return scale;
}

void undo_anisotropic_scale(DriveLog& run, const AnisotropicScale& scale) {
  const double a = scale.along;
  const double b = scale.oblique;
  const double divisor = scale.gain * (1.0 - a * a - b * b);
  for (DriveSample& sample : run.samples) {
    if (sample.reference_x_m && sample.reference_y_m) {
      const double x = *sample.reference_x_m;
      const double y = *sample.reference_y_m;
      sample.reference_x_m = ((1.0 - a) * x - b * y) / divisor;
      sample.reference_y_m = ((1.0 + a) * y - b * x) / divisor;
    }
    if (sample.reference_theta_rad) {
      const double twice_rad = 2.0 * *sample.reference_theta_rad;
      *sample.reference_theta_rad +=
          scale.heading_along_rad * std::sin(twice_rad) - scale.heading_oblique_rad * std::cos(twice_rad);
    }
  }
  run.reference_scaled_by_counts = true;
}

std::string in_words(const AnisotropicScale& scale) {
  return "the reference's metre is " + in_digits(100.0 * (scale.largest_over_least() - 1.0), 2) +
         " % longer along " + in_digits(scale.longest_direction_rad() * 180.0 / std::numbers::pi, 2) +
         " deg of its frame than across, as of a camera that looks at a slant";
}

}  // namespace wheelwright
