#include "model/log/heading_offset.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

#include "model/statistics/dense_solve.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright {
namespace {

constexpr double offset_window_s = 0.5;
constexpr double longest_turn_rad = 0.5;
constexpr double cluster_s = 5.0;
constexpr std::size_t least_clusters = 10;  // of fewer, their scatter says too little
constexpr double fastest_m_s = 2.0;         // a reference that jumps says nothing
constexpr double sure = 5.0;                // standard errors
constexpr double contradicting = 3.0;       // likewise
constexpr double matters_rad = 0.005;       // a centimetre aside on two metres

// Motion of the reference from one pose to another.
struct Window {
  double dx_m;
  double dy_m;
  double heading_rad;  // half-way
  double turn_rad;
  double duration_s;
  double rolled_m;    // by the counts, else as commanded
  double t_s;         // since the run began, half-way
  double turned_rad;  // since then, half-way
  std::size_t run;
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
  const std::size_t run_index = windows.empty() ? 0 : windows.back().run + 1;
  const std::size_t first_cluster = windows.empty() ? 0 : windows.back().cluster + 1;
  std::optional<std::size_t> from;
  double turned = 0.0;
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
                           to.t_s - before.t_s, way[i] - way[*from],
                           0.5 * (to.t_s + before.t_s) - run.samples.front().t_s, turned + 0.5 * turn,
                           run_index, cluster});
      turned += turn;
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

constexpr Eigen::Index cause_count = 7;
constexpr Eigen::Index without_trend = 5;  // causes
constexpr Eigen::Index of_drift = 5;
constexpr Eigen::Index of_scale = 6;
using Row = Eigen::Matrix<double, cause_count, 1>;

struct Means {
  double t_s = 0.0;
  double turned_rad = 0.0;
};

Means means_of(std::span<const Window> windows) {
  Means sum;
  for (const Window& window : windows) {
    sum.t_s += window.t_s;
    sum.turned_rad += window.turned_rad;
  }
  const auto count = static_cast<double>(windows.size());
  return {sum.t_s / count, sum.turned_rad / count};
}

// About the means of each run: offsets of its own are no trend.
std::vector<Window> centred_by_run(std::vector<Window> windows) {
  for (auto begin = windows.begin(); begin != windows.end();) {
    const auto end =
        std::find_if(begin, windows.end(), [&](const Window& each) { return each.run != begin->run; });
    const Means means = means_of(std::span(begin, end));
    for (; begin != end; ++begin) {
      begin->t_s -= means.t_s;
      begin->turned_rad -= means.turned_rad;
    }
  }
  return windows;
}

struct Motion {
  Row causes;    // of the motion aside
  double aside;  // m
};

Motion motion_of(const Window& window, const Means& means, double offset_rad) {
  const double direction = window.heading_rad + offset_rad;
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  const double forward = window.dx_m * c + window.dy_m * s;
  Row causes;
  causes << forward, window.turn_rad, forward * window.turn_rad / window.duration_s, window.duration_s * c,
      window.duration_s * s, forward * (window.t_s - means.t_s),
      forward * (window.turned_rad - means.turned_rad);
  return {causes, window.dy_m * c - window.dx_m * s};
}

// The standard error of a factor by which it is as sure as it is by Student's t of so many degrees of freedom
// (D. L. Wallace, Annals of Mathematical Statistics 30, 1959).
double as_of_many(double factor, double standard_error, double freedom) {
  const double t = std::abs(factor) / standard_error;
  if (!(t > 0.0) || !std::isfinite(t)) return standard_error;
  const double normal =
      (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) * std::sqrt(freedom * std::log1p(t * t / freedom));
  return std::abs(factor) / normal;
}

struct Fit {
  Row factors;
  Row standard_errors;
};

// By the first causes alone where `with_trend` is false.
std::optional<Fit> fit_aside(const std::vector<Window>& windows, const Means& means, double coarse_rad,
                             bool with_trend) {
  constexpr double ridge = 1e-9;  // of scaled columns: two that go together leave a large error
  using Square = Eigen::Matrix<double, cause_count, cause_count>;
  const auto motion_in = [&](const Window& window) {
    Motion motion = motion_of(window, means, coarse_rad);
    if (!with_trend) motion.causes.tail(cause_count - without_trend).setZero();
    return motion;
  };
  Square normal = Square::Zero();
  Row right = Row::Zero();
  for (const Window& window : windows) {
    const Motion motion = motion_in(window);
    normal += motion.causes * motion.causes.transpose();
    right += motion.causes * motion.aside;
  }
  if (!(normal(0, 0) > 0.0)) return std::nullopt;
  const Row scales = (normal.diagonal().array() + 1e-12 * normal(0, 0)).sqrt().inverse();
  Square scaled = scales.asDiagonal() * normal * scales.asDiagonal();
  scaled.diagonal().array() += ridge;
  const Square inverse =
      scales.asDiagonal() * solve_symmetric_columns(scaled, scales.asDiagonal().toDenseMatrix());
  Fit fit;
  fit.factors = inverse * right;
  Square scores = Square::Zero();
  Row score = Row::Zero();
  std::size_t clusters = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Motion motion = motion_in(windows[i]);
    score += motion.causes * (motion.aside - fit.factors.dot(motion.causes));
    if (i + 1 < windows.size() && windows[i + 1].cluster == windows[i].cluster) continue;
    scores += score * score.transpose();
    score.setZero();
    ++clusters;
  }
  if (clusters < least_clusters) return std::nullopt;
  const auto causes = static_cast<std::size_t>(with_trend ? cause_count : without_trend);
  const double freedom = static_cast<double>(clusters) / static_cast<double>(clusters - causes);
  const Square covariance = freedom * inverse * scores * inverse;
  for (Eigen::Index cause = 0; cause < cause_count; ++cause)
    fit.standard_errors[cause] =
        as_of_many(fit.factors[cause], std::sqrt(std::max(covariance(cause, cause), 0.0)),
                   static_cast<double>(clusters - causes));
  return fit;
}

// Whether a trend over `values` of the windows is sure and makes a difference.
bool is_trend(const Fit& fit, Eigen::Index cause, const std::vector<Window>& windows, double Window::*value) {
  const auto [least, most] = std::ranges::minmax(windows, {}, value);
  const double size = std::abs(fit.factors[cause]);
  return size > sure * fit.standard_errors[cause] && size * (most.*value - least.*value) > 2.0 * matters_rad;
}

// Whether the runs by themselves show a trend that all of them together have: offsets of their own may look
// like one over all.
bool is_within_runs(const Fit& fit, const Fit& within_runs, Eigen::Index cause) {
  constexpr double likely = 2.0;  // standard errors
  const double within = within_runs.factors[cause];
  const double error = within_runs.standard_errors[cause];
  return within * fit.factors[cause] > 0.0 && std::abs(within) > likely * error &&
         std::abs(within - fit.factors[cause]) < contradicting * error;
}

std::optional<HeadingOffset> fine_offset(const std::vector<Window>& windows, double coarse_rad) {
  const Means means = means_of(windows);
  auto fit = fit_aside(windows, means, coarse_rad, true);
  const auto within_runs = fit_aside(centred_by_run(windows), {}, coarse_rad, true);
  if (!fit || !within_runs) return std::nullopt;
  const bool drifts =
      is_trend(*fit, of_drift, windows, &Window::t_s) && is_within_runs(*fit, *within_runs, of_drift);
  const bool is_scaled =
      is_trend(*fit, of_scale, windows, &Window::turned_rad) && is_within_runs(*fit, *within_runs, of_scale);
  if (!drifts && !is_scaled) fit = fit_aside(windows, means, coarse_rad, false);
  const double slope = fit->factors[0];
  const double per_slope = 1.0 / (1.0 + slope * slope);
  return HeadingOffset{wrap_angle(coarse_rad + std::atan(slope)),
                       per_slope * fit->standard_errors[0],
                       drifts ? per_slope * fit->factors[of_drift] : 0.0,
                       is_scaled ? per_slope * fit->factors[of_scale] : 0.0,
                       means.t_s,
                       means.turned_rad};
}

// Between the two at the means of the first, less what does not matter.
double apart_rad(const HeadingOffset& own, const HeadingOffset& of_all) {
  const double expected = of_all.offset_rad + of_all.drift_rad_per_s * (own.mean_t_s - of_all.mean_t_s) +
                          of_all.per_radian * (own.mean_turned_rad - of_all.mean_turned_rad);
  return std::abs(wrap_angle(own.offset_rad - expected)) - matters_rad;
}

bool has_trend(const HeadingOffset& offset) {
  return offset.drift_rad_per_s != 0.0 || offset.per_radian != 0.0;
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
  const bool is_off = size > matters_rad && size > sure * offset.standard_error_rad;
  return size < half_a_turn_rad && (is_off || has_trend(offset));
}

void turn_headings(DriveLog& run, const HeadingOffset& offset) {
  double turned = 0.0;
  double before = 0.0;
  bool is_first = true;
  for (DriveSample& sample : run.samples) {
    if (!sample.reference_theta_rad) continue;
    double& theta = *sample.reference_theta_rad;
    if (!is_first) turned += wrap_angle(theta - before);
    is_first = false;
    before = theta;
    theta += offset.offset_rad +
             offset.drift_rad_per_s * (sample.t_s - run.samples.front().t_s - offset.mean_t_s) +
             offset.per_radian * (turned - offset.mean_turned_rad);
  }
}

std::vector<HeadingOffset> heading_offsets(std::span<const DriveLog* const> runs) {
  const auto of_all = find_heading_offset(runs);
  std::vector<HeadingOffset> offsets;
  for (const DriveLog* run : runs) {
    const auto own = runs.size() > 1 ? find_heading_offset({&run, 1}) : of_all;
    const bool contradicts =
        of_all && own && apart_rad(*own, *of_all) > contradicting * own->standard_error_rad;
    const auto& used = of_all && !contradicts ? of_all : own;
    offsets.push_back(used && is_turned(*used) ? *used : HeadingOffset{});
  }
  return offsets;
}

std::string in_words(const HeadingOffset& offset) {
  constexpr double degree = std::numbers::pi / 180.0;
  constexpr double minute_s = 60.0;
  const double half_rad = 1.96 * offset.standard_error_rad;
  std::string text =
      "the heading of the reference is turned by " + in_digits(-offset.offset_rad / degree, 3) +
      " deg against the way that it moves (95 %: " + in_digits((-offset.offset_rad - half_rad) / degree, 3) +
      " to " + in_digits((-offset.offset_rad + half_rad) / degree, 3) + ")";
  if (offset.drift_rad_per_s != 0.0)
    text += ", drifts by " + in_digits(-minute_s * offset.drift_rad_per_s / degree, 3) + " deg a minute";
  if (offset.per_radian != 0.0)
    text += ", turns " + in_digits(1.0 / (1.0 + offset.per_radian), 5) + " times as far";
  return text;
}

}  // namespace wheelwright
