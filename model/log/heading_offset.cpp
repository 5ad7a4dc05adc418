#include "model/log/heading_offset.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "model/statistics/significant_digits.hpp"

namespace wheelwright {
namespace {

constexpr double offset_window_s = 0.5;
constexpr double longest_turn_rad = 0.5;
constexpr double cluster_s = 5.0;
constexpr std::size_t least_clusters = 10;  // of fewer, their scatter says too little
constexpr double fastest_m_s = 2.0;         // a reference that jumps says nothing
constexpr double sure = 5.0;                // standard errors
constexpr double matters_rad = 0.005;       // a centimetre aside on two metres

// Motion of the reference from one pose to another.
struct Window {
  double dx_m;
  double dy_m;
  double heading_rad;  // half-way
  double turn_rad;
  double duration_s;
  double rolled_m;  // by the counts, else as commanded
  std::size_t cluster;
};

// How far the middle of the wheels went before each row.
std::vector<double> way_of_wheels_m(const DriveLog& run) {
  std::vector<double> way{0.0};
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    const DriveSample& before = run.samples[i - 1];
    const DriveSample& now = run.samples[i];
    const double duration_s = now.t_s - before.t_s;
    double step = 0.5 * (before.command_m_s.left + before.command_m_s.right) * duration_s;
    if (run.metres_per_tick && now.ticks && before.ticks) {
      step = 0.5 * (static_cast<double>(now.ticks->left - before.ticks->left) * run.metres_per_tick->left +
                    static_cast<double>(now.ticks->right - before.ticks->right) * run.metres_per_tick->right);
    }
    way.push_back(way.back() + step);
  }
  return way;
}

void add_windows(const DriveLog& run, std::vector<Window>& windows) {
  const std::vector<double> way = way_of_wheels_m(run);
  const std::size_t first_cluster = windows.empty() ? 0 : windows.back().cluster + 1;
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const DriveSample& to = run.samples[i];
    const auto pose = to.reference_pose();
    if (!pose) continue;
    if (from && to.t_s - run.samples[*from].t_s < offset_window_s) continue;
    if (from) {
      const DriveSample& before = run.samples[*from];
      const Pose start = before.reference_pose().value_or(Pose{});
      const double turn = wrap_angle(pose->theta_rad - start.theta_rad);
      const auto cluster =
          first_cluster + static_cast<std::size_t>((to.t_s - run.samples.front().t_s) / cluster_s);
      const double moved_m = std::hypot(pose->x_m - start.x_m, pose->y_m - start.y_m);
      if (std::abs(turn) < longest_turn_rad && moved_m < fastest_m_s * (to.t_s - before.t_s))
        windows.push_back({pose->x_m - start.x_m, pose->y_m - start.y_m, start.theta_rad + 0.5 * turn, turn,
                           to.t_s - before.t_s, way[i] - way[*from], cluster});
    }
    from = i;
  }
}

// The direction of the motion to the heading, as a robot moves that drives backward as well as forward: the
// mean of twice the angle, by squares of the way; forward is where the wheels go. Nothing where the angles
// lie all around.
std::optional<double> coarse_offset(const std::vector<Window>& windows) {
  constexpr double min_concentration = 0.5;
  std::complex<double> sum = 0.0;
  double squares = 0.0;
  for (const Window& window : windows) {
    const std::complex<double> moved(window.dx_m, window.dy_m);
    sum += moved * moved * std::polar(1.0, -2.0 * window.heading_rad);
    squares += std::norm(moved);
  }
  if (!(std::abs(sum) > min_concentration * squares)) return std::nullopt;
  const double offset = 0.5 * std::arg(sum);
  double forward = 0.0;
  for (const Window& window : windows) {
    const double direction = window.heading_rad + offset;
    forward += window.rolled_m * (window.dx_m * std::cos(direction) + window.dy_m * std::sin(direction));
  }
  return forward >= 0.0 ? offset : wrap_angle(offset + std::numbers::pi);
}

using Row = Eigen::Matrix<double, 5, 1>;

struct Motion {
  Row causes;    // of the motion aside
  double aside;  // m
};

Motion motion_of(const Window& window, double offset_rad) {
  const double direction = window.heading_rad + offset_rad;
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  const double forward = window.dx_m * c + window.dy_m * s;
  Row causes;
  causes << forward, window.turn_rad, forward * window.turn_rad / window.duration_s, window.duration_s * c,
      window.duration_s * s;
  return {causes, window.dy_m * c - window.dx_m * s};
}

// What is left of the offset, and its standard error.
std::optional<HeadingOffset> fine_offset(const std::vector<Window>& windows, double coarse_rad) {
  constexpr double ridge = 1e-9;  // of scaled columns: two that go together leave a large error
  using Square = Eigen::Matrix<double, 5, 5>;
  Square normal = Square::Zero();
  Row right = Row::Zero();
  for (const Window& window : windows) {
    const Motion motion = motion_of(window, coarse_rad);
    normal += motion.causes * motion.causes.transpose();
    right += motion.causes * motion.aside;
  }
  if (!(normal(0, 0) > 0.0)) return std::nullopt;
  const Row sizes = (normal.diagonal().array() + 1e-12 * normal(0, 0)).sqrt();
  const Row scales = sizes.cwiseInverse();
  Square scaled = scales.asDiagonal() * normal * scales.asDiagonal();
  scaled.diagonal().array() += ridge;
  const Square inverse = scales.asDiagonal() * scaled.inverse() * scales.asDiagonal();
  const Row factors = inverse * right;
  Square scores = Square::Zero();
  Row score = Row::Zero();
  std::size_t clusters = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Motion motion = motion_of(windows[i], coarse_rad);
    score += motion.causes * (motion.aside - factors.dot(motion.causes));
    if (i + 1 < windows.size() && windows[i + 1].cluster == windows[i].cluster) continue;
    scores += score * score.transpose();
    score.setZero();
    ++clusters;
  }
  if (clusters < least_clusters) return std::nullopt;
  const double freedom = static_cast<double>(clusters) / static_cast<double>(clusters - 5);
  const Square covariance = freedom * inverse * scores * inverse;
  const double per_radian = 1.0 / (1.0 + factors[0] * factors[0]);
  return HeadingOffset{wrap_angle(coarse_rad + std::atan(factors[0])),
                       per_radian * std::sqrt(std::max(covariance(0, 0), 0.0))};
}

}  // namespace

std::optional<HeadingOffset> find_heading_offset(std::span<const DriveLog* const> runs) {
  std::vector<Window> windows;
  for (const DriveLog* run : runs) add_windows(*run, windows);
  const auto coarse = coarse_offset(windows);
  return coarse ? fine_offset(windows, *coarse) : std::nullopt;
}

bool is_turned(const HeadingOffset& offset) {
  constexpr double half_a_turn_rad = 0.75 * std::numbers::pi;
  const double size = std::abs(offset.offset_rad);
  return size > matters_rad && size > sure * offset.standard_error_rad && size < half_a_turn_rad;
}

void turn_headings(DriveLog& run, double by_rad) {
  for (DriveSample& sample : run.samples) {
    if (sample.reference_theta_rad) *sample.reference_theta_rad += by_rad;
  }
}

std::vector<HeadingOffset> heading_offsets(std::span<const DriveLog* const> runs) {
  const auto of_all = find_heading_offset(runs);
  std::vector<HeadingOffset> offsets;
  for (const DriveLog* run : runs) {
    const auto own = runs.size() > 1 ? find_heading_offset({&run, 1}) : of_all;
    const double apart_rad = of_all && own ? std::abs(wrap_angle(own->offset_rad - of_all->offset_rad)) : 0.0;
    const bool contradicts = own && apart_rad > std::max(matters_rad, sure * own->standard_error_rad);
    const auto& used = of_all && !contradicts ? of_all : own;
    offsets.push_back(used && is_turned(*used) ? *used : HeadingOffset{});
  }
  return offsets;
}

std::string in_words(const HeadingOffset& offset) {
  constexpr double degree = std::numbers::pi / 180.0;
  const double half_rad = 1.96 * offset.standard_error_rad;
  return "the heading of the reference is turned by " + in_digits(-offset.offset_rad / degree, 3) +
         " deg against the way that it moves (95 %: " +
         in_digits((-offset.offset_rad - half_rad) / degree, 3) + " to " +
         in_digits((-offset.offset_rad + half_rad) / degree, 3) + ")";
}

}  // namespace wheelwright
