#include "model/log/headings_by_positions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "model/statistics/dense_solve.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright {
namespace {

using State = Eigen::Matrix<double, 5, 1>;  // x, y, heading, marker ahead and left
using Covariance = Eigen::Matrix<double, 5, 5>;

constexpr double along_m2_per_m = 4e-3;  // of counted travel, along the path
constexpr double across_m2_per_m = 1e-5;
constexpr double turn_rad2_per_m = 1e-3;
constexpr double turn_rad2_per_rad = 5e-3;
constexpr double first_heading_rad = 0.5;  // standard deviation
constexpr double marker_m = 0.3;
constexpr double least_noise_m = 5e-4;
constexpr double most_noise_m = 1.0;
constexpr double unknown_rad = 0.2;

// Of the poses that stay.
constexpr double pose_every_s = 2.0;
constexpr double least_apart_s = 1.5;
constexpr double worst_variance = 4.0;  // times the median

// A position, and what the counts say of the way there from the one before.
struct Fix {
  std::size_t row = 0;
  Eigen::Vector2d position_m;
  std::vector<WheelPair> counted_m;
};

std::vector<Fix> fixes_of(const DriveLog& log) {
  std::vector<Fix> fixes;
  std::vector<WheelPair> counted_m;
  const WheelTicks* last = nullptr;
  for (std::size_t row = 0; row < log.samples.size(); ++row) {
    const DriveSample& sample = log.samples[row];
    if (sample.ticks) {
      if (last != nullptr && !sample.counter_reset)
        counted_m.push_back(
            {static_cast<double>(sample.ticks->left - last->left) * log.metres_per_tick->left,
             static_cast<double>(sample.ticks->right - last->right) * log.metres_per_tick->right});
      last = &*sample.ticks;
    }
    if (!sample.reference_x_m || !sample.reference_y_m) continue;
    const Eigen::Vector2d position_m(*sample.reference_x_m, *sample.reference_y_m);
    if (!fixes.empty() && fixes.back().position_m == position_m) continue;  // repeated until a new one comes
    if (fixes.empty()) counted_m.clear();
    fixes.push_back({row, position_m, std::move(counted_m)});
    counted_m.clear();
  }
  return fixes;
}

Pose moved(const Pose& pose, const WheelPair& travel_m, double wheel_base_m) {
  return move_along_arc(pose, twist_of_wheels(travel_m, wheel_base_m), 1.0);
}

// By the first chord that is long beside the positions' noise: which way it points on the floor, and by the
// counts. Nothing where the robot does not come so far.
std::optional<double> first_heading(const std::vector<Fix>& fixes, double wheel_base_m, double noise_m) {
  constexpr double shortest_m = 0.3;
  constexpr double noises = 10.0;
  Pose counted;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    for (const WheelPair& travel_m : fixes[i].counted_m) counted = moved(counted, travel_m, wheel_base_m);
    const Eigen::Vector2d chord = fixes[i].position_m - fixes.front().position_m;
    const double enough_m = std::max(shortest_m, noises * noise_m);
    if (chord.norm() < enough_m || std::hypot(counted.x_m, counted.y_m) < 0.5 * enough_m) continue;
    return wrap_angle(std::atan2(chord.y(), chord.x()) - std::atan2(counted.y_m, counted.x_m));
  }
  return std::nullopt;
}

// What is known at a fix, before its position and after, and how it follows from what was known after the fix
// before.
struct Known {
  State predicted;
  Covariance predicted_covariance;
  Covariance transition;
  State state;
  Covariance covariance;
};

class PositionFilter {
 public:
  PositionFilter(const std::vector<Fix>& fixes, double wheel_base_m, double noise_m)
      : fixes_(fixes), wheel_base_m_(wheel_base_m), noise_m_(noise_m) {}

  // Nothing where the first heading stays unknown.
  std::optional<std::vector<Known>> known() {
    const auto heading = first_heading(fixes_, wheel_base_m_, noise_m_);
    if (!heading) return std::nullopt;
    state_ << fixes_.front().position_m, *heading, 0.0, 0.0;
    covariance_.setZero();
    const double place_variance = noise_m_ * noise_m_ + marker_m * marker_m;
    covariance_.diagonal() << place_variance, place_variance, first_heading_rad * first_heading_rad,
        marker_m * marker_m, marker_m * marker_m;
    std::vector<Known> all;
    all.reserve(fixes_.size());
    for (const Fix& fix : fixes_) {
      Known& now = all.emplace_back();
      now.transition.setIdentity();
      for (const WheelPair& travel_m : fix.counted_m) now.transition = predict(travel_m) * now.transition;
      now.predicted = state_;
      now.predicted_covariance = covariance_;
      update(fix.position_m);
      now.state = state_;
      now.covariance = covariance_;
    }
    return all;
  }
  // Of the positions, but for a constant.
  double log_likelihood() const { return log_likelihood_; }

 private:
  Covariance predict(const WheelPair& travel_m) {
    const Pose before{state_(0), state_(1), state_(2)};
    const Pose after = moved(before, travel_m, wheel_base_m_);
    Covariance transition = Covariance::Identity();
    transition(0, 2) = -(after.y_m - before.y_m);
    transition(1, 2) = after.x_m - before.x_m;
    const double distance_m = std::abs(0.5 * (travel_m.left + travel_m.right));
    const double turn_rad = std::abs(after.theta_rad - before.theta_rad);
    const Direction way = direction_of(0.5 * (before.theta_rad + after.theta_rad));
    Eigen::Matrix2d along;
    along << way.cosine, -way.sine, way.sine, way.cosine;
    const Eigen::Vector2d drift(along_m2_per_m * distance_m, across_m2_per_m * distance_m);
    covariance_ = (transition * covariance_ * transition.transpose()).eval();
    covariance_.topLeftCorner<2, 2>() += along * drift.asDiagonal() * along.transpose();
    covariance_(2, 2) += turn_rad2_per_m * distance_m + turn_rad2_per_rad * turn_rad;
    state_.head<3>() << after.x_m, after.y_m, after.theta_rad;
    return transition;
  }

  void update(const Eigen::Vector2d& position_m) {
    const Direction heading = direction_of(state_(2));
    Eigen::Matrix2d rotation;
    rotation << heading.cosine, -heading.sine, heading.sine, heading.cosine;
    const Eigen::Vector2d marker = rotation * state_.tail<2>();
    Eigen::Matrix<double, 2, 5> seen;
    seen << 1.0, 0.0, -marker.y(), rotation(0, 0), rotation(0, 1), 0.0, 1.0, marker.x(), rotation(1, 0),
        rotation(1, 1);
    const Eigen::Vector2d innovation = position_m - state_.head<2>() - marker;
    Eigen::Matrix2d variance = seen * covariance_ * seen.transpose();
    variance.diagonal().array() += noise_m_ * noise_m_;
    const Eigen::Matrix2d inverse = variance.inverse();
    log_likelihood_ -= 0.5 * (innovation.dot(inverse * innovation) + std::log(variance.determinant()));
    const Eigen::Matrix<double, 5, 2> gain = covariance_ * seen.transpose() * inverse;
    state_ += gain * innovation;
    const Covariance rest = Covariance::Identity() - gain * seen;
    covariance_ =
        (rest * covariance_ * rest.transpose() + noise_m_ * noise_m_ * gain * gain.transpose()).eval();
  }

  const std::vector<Fix>& fixes_;
  double wheel_base_m_;
  double noise_m_;
  State state_;
  Covariance covariance_;
  double log_likelihood_ = 0.0;
};

struct Heading {
  double rad = 0.0;
  double variance = 0.0;
};

std::vector<Heading> smoothed(const std::vector<Known>& known) {
  std::vector<Heading> headings(known.size());
  State state = known.back().state;
  Covariance covariance = known.back().covariance;
  headings.back() = {state(2), covariance(2, 2)};
  for (std::size_t i = known.size() - 1; i-- > 0;) {
    const Known& next = known[i + 1];
    const Covariance gain =
        solve_symmetric_columns(next.predicted_covariance, next.transition * known[i].covariance).transpose();
    state = known[i].state + gain * (state - next.predicted);
    covariance =
        (known[i].covariance + gain * (covariance - next.predicted_covariance) * gain.transpose()).eval();
    headings[i] = {state(2), covariance(2, 2)};
  }
  return headings;
}

// The fix of each two seconds whose heading is known best, but for those of which it is known badly.
std::vector<std::size_t> poses_that_stay(const DriveLog& log, const std::vector<Fix>& fixes,
                                         const std::vector<Heading>& headings) {
  const auto time_s = [&](std::size_t fix) { return log.samples[fixes[fix].row].t_s; };
  const auto variance = [&](std::size_t fix) { return headings[fix].variance; };
  std::vector<std::size_t> stay;
  for (std::size_t first = 0; first < fixes.size();) {
    std::size_t best = first;
    std::size_t end = first;
    for (; end < fixes.size() && time_s(end) < time_s(first) + pose_every_s; ++end) {
      if (variance(end) < variance(best)) best = end;
    }
    if (stay.empty() || time_s(best) >= time_s(stay.back()) + least_apart_s) stay.push_back(best);
    first = end;
  }
  std::vector<double> variances;
  std::ranges::transform(stay, std::back_inserter(variances), variance);
  const double most = worst_variance * median(variances);
  std::erase_if(stay, [&](std::size_t fix) { return variance(fix) > most; });
  return stay;
}

struct Likeliest {
  double noise_m = 0.0;
  std::vector<Known> known;
};

std::optional<Likeliest> likeliest(const std::vector<Fix>& fixes, double wheel_base_m) {
  std::optional<Likeliest> best;
  double most = 0.0;
  for (double noise_m = least_noise_m; noise_m < most_noise_m; noise_m *= std::numbers::sqrt2) {
    PositionFilter filter(fixes, wheel_base_m, noise_m);
    auto known = filter.known();
    if (!known || (best && filter.log_likelihood() <= most)) continue;
    most = filter.log_likelihood();
    best = {noise_m, *std::move(known)};
  }
  return best;
}

}  // namespace

bool has_positions_alone(const DriveLog& log) {
  const auto has_position = [](const DriveSample& sample) {
    return sample.reference_x_m && sample.reference_y_m;
  };
  return std::ranges::any_of(log.samples, has_position) &&
         std::ranges::none_of(
             log.samples, [](const DriveSample& sample) { return sample.reference_theta_rad.has_value(); });
}

std::optional<PoseNoise> find_headings(DriveLog& log) {
  if (!has_positions_alone(log) || !log.metres_per_tick || log.wheel_base_m <= 0.0) return std::nullopt;
  const std::vector<Fix> fixes = fixes_of(log);
  const auto best = likeliest(fixes, log.wheel_base_m);
  if (!best) return std::nullopt;
  const std::vector<Heading> headings = smoothed(best->known);
  const std::vector<std::size_t> stay = poses_that_stay(log, fixes, headings);
  double variance = 0.0;
  for (const std::size_t i : stay) variance += headings[i].variance / static_cast<double>(stay.size());
  const PoseNoise noise{best->noise_m, std::sqrt(variance)};
  if (stay.size() < 2 || !(noise.heading_rad < unknown_rad)) return std::nullopt;
  for (DriveSample& sample : log.samples) {
    sample.reference_x_m.reset();
    sample.reference_y_m.reset();
  }
  for (const std::size_t i : stay) {
    DriveSample& sample = log.samples[fixes[i].row];
    sample.reference_x_m = fixes[i].position_m.x();
    sample.reference_y_m = fixes[i].position_m.y();
    sample.reference_theta_rad = headings[i].rad;
  }
  log.reference_noise = noise;
  return noise;
}

}  // namespace wheelwright
