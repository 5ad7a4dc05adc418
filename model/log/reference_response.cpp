#include "model/log/reference_response.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/log/counted_windows.hpp"
#include "model/log/response_windows.hpp"
#include "model/statistics/dense_solve.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright {
namespace {

using Windows = std::vector<WindowProducts>;
constexpr Eigen::Index taps = response_taps::count;

constexpr double sure_smoothing = 5.0;  // standard errors, by the scatter of the windows
constexpr double much = 0.9;            // of the squares are left at most: what a robot does moves less
constexpr double matters_s = 0.06;      // of a smoothing: less looks like a yielding tyre
constexpr double apart_s = 0.04;        // delays of place and heading
constexpr double narrowest_s = 0.03;
constexpr double widest_s = 0.4;
constexpr double width_ratio = 1.2;          // of two that are tried
constexpr double tried_delay_step_s = 0.02;  // of the delays that are tried

// Forms of a smoothing, each of a delay and a width.
enum class Form {
  normal,       // of a filter of high order, or one that runs in both directions; width: standard deviation
  moving_mean,  // likewise
  low_pass,     // width: time constant
  tracking      // alpha-beta or Kalman filter of place and speed, critically damped: not late at steady speed
};
constexpr std::array forms{Form::normal, Form::moving_mean, Form::low_pass, Form::tracking};

bool is_symmetric(Form form) {
  return form == Form::normal || form == Form::moving_mean;
}

// At a time so many widths after the delay.
double height(Form form, double late) {
  switch (form) {
    case Form::normal:
      return std::exp(-0.5 * late * late);
    case Form::moving_mean:
      return late * late <= 3.0 ? 1.0 : 0.0;
    case Form::low_pass:
      return late < 0.0 ? 0.0 : std::exp(-late);
    case Form::tracking:
      break;
  }
  return late < 0.0 ? 0.0 : (2.0 - late) * std::exp(-late);
}

// Shared out to the taps on either side of each moment.
Eigen::VectorXd curve(Form form, double delay_s, double width_s) {
  constexpr int parts = 8;  // of the time between two taps
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(taps);
  for (Eigen::Index j = 0; j + 1 < taps; ++j) {
    for (int part = 0; part < parts; ++part) {
      const double share = (part + 0.5) / parts;
      const double late_s = response_taps::delay_s(j) + share * response_taps::step_s - delay_s;
      const double value = height(form, late_s / width_s);
      weights(j) += (1.0 - share) * value;
      weights(j + 1) += share * value;
    }
  }
  return weights / weights.sum();
}

Eigen::VectorXd pure_delay(double delay_s) {
  Eigen::VectorXd weights(taps);
  for (Eigen::Index j = 0; j < taps; ++j)
    weights(j) = std::max(0.0, 1.0 - std::abs(response_taps::delay_s(j) - delay_s) / response_taps::step_s);
  return weights;
}

double sum_squares(const WindowProducts& products, const Eigen::VectorXd& response) {
  return products(taps, taps) - 2.0 * response.dot(products.col(taps).head(taps)) +
         response.dot(products.topLeftCorner(taps, taps) * response);
}

// Times the gain that suits best.
Eigen::VectorXd with_gain(const WindowProducts& products, const Eigen::VectorXd& weights) {
  const double power = weights.dot(products.topLeftCorner(taps, taps) * weights);
  return power > 0.0 ? Eigen::VectorXd(weights * (weights.dot(products.col(taps).head(taps)) / power))
                     : weights;
}

struct Curve {
  Form form = Form::normal;
  double delay_s = 0.0;
  double width_s = 0.0;  // 0: a delay alone
  double sum_squares = 0.0;
  Eigen::VectorXd response;
};

void keep_better(const WindowProducts& products, Form form, double delay_s, double width_s,
                 std::optional<Curve>& best) {
  // What lies beyond the taps would be cut off.
  const double first_s = response_taps::first_s + (is_symmetric(form) ? 2.0 * width_s : 0.0);
  const double last_s = response_taps::delay_s(taps - 1) - (is_symmetric(form) ? 2.0 : 3.0) * width_s;
  if (delay_s < first_s || delay_s > last_s) return;
  const Eigen::VectorXd weights = width_s > 0.0 ? curve(form, delay_s, width_s) : pure_delay(delay_s);
  Curve each{form, delay_s, width_s, 0.0, with_gain(products, weights)};
  each.sum_squares = sum_squares(products, each.response);
  if (!best || each.sum_squares < best->sum_squares) best = std::move(each);
}

Curve best_delay(const WindowProducts& products) {
  std::optional<Curve> best;
  for (double delay_s = response_taps::first_s; delay_s <= response_taps::delay_s(taps - 1);
       delay_s += 0.5 * tried_delay_step_s)
    keep_better(products, Form::normal, delay_s, 0.0, best);
  return *best;
}

Curve best_smoothing(const WindowProducts& products) {
  std::optional<Curve> best;
  for (const Form form : forms) {
    for (double width_s = narrowest_s; width_s <= widest_s; width_s *= width_ratio) {
      for (double delay_s = response_taps::first_s; delay_s <= response_taps::delay_s(taps - 1);
           delay_s += tried_delay_step_s)
        keep_better(products, form, delay_s, width_s, best);
    }
  }
  const Curve coarse = *best;
  for (int wider = -3; wider <= 3; ++wider) {
    for (int later = -3; later <= 3; ++later) {
      keep_better(products, coarse.form, coarse.delay_s + 0.25 * later * tried_delay_step_s,
                  coarse.width_s * std::pow(width_ratio, 0.25 * wider), best);
    }
  }
  return *best;
}

// Whether one response leaves less than another, by how the windows differ, and much less.
bool is_surely_better(const Windows& windows, const Eigen::VectorXd& better, const Eigen::VectorXd& worse) {
  double gained = 0.0;
  double gained_squares = 0.0;
  double left = 0.0;
  for (const WindowProducts& window : windows) {
    const double before = sum_squares(window, worse);
    const double gain = before - sum_squares(window, better);
    gained += gain;
    gained_squares += gain * gain;
    left += before - gain;
  }
  const auto count = static_cast<double>(windows.size());
  const double variance = (gained_squares - gained * gained / count) * count / (count - 1.0);
  return gained >= sure_smoothing * std::sqrt(std::max(0.0, variance)) && left <= much * (left + gained);
}

WindowProducts sum_of(const Windows& windows, auto taken) {
  WindowProducts sum = WindowProducts::Zero(taps + 1, taps + 1);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (taken(i)) sum += windows[i];
  }
  return sum;
}

WindowProducts sum_of(const Windows& windows) {
  return sum_of(windows, [](std::size_t) { return true; });
}

Eigen::VectorXd smooth_response(const WindowProducts& products, double penalty) {
  Eigen::MatrixXd second_difference = Eigen::MatrixXd::Zero(taps, taps);
  for (Eigen::Index j = 0; j < taps; ++j) {
    second_difference(j, j) = 2.0;
    if (j > 0) second_difference(j, j - 1) = -1.0;
    if (j + 1 < taps) second_difference(j, j + 1) = -1.0;
  }
  const Eigen::MatrixXd powers = products.topLeftCorner(taps, taps);
  const double scale = penalty * powers.trace() / static_cast<double>(taps);
  const Eigen::MatrixXd penalised = powers + scale * second_difference.transpose() * second_difference;
  return solve_symmetric(penalised, products.col(taps).head(taps));
}

DelayKernel kernel_of(const Eigen::VectorXd& response) {
  const Eigen::VectorXd weights = response / response.sum();
  return {response_taps::first_s, response_taps::step_s, {weights.begin(), weights.end()}};
}

// As it comes: the smoothest of those that predict the other half of the windows about as well as any; or a
// form that does.
DelayKernel kernel_of(const Windows& windows, const Curve& form) {
  constexpr double about = 1.01;
  const auto half = [&](std::size_t which) {
    return sum_of(windows, [which](std::size_t i) { return i % 2 == which; });
  };
  const std::array<WindowProducts, 2> halves{half(0), half(1)};
  std::vector<std::pair<double, double>> tried;  // penalty, sum of squares
  for (double penalty = 1e-7; penalty < 1.0; penalty *= 10.0) {
    tried.emplace_back(penalty, sum_squares(halves[1], smooth_response(halves[0], penalty)) +
                                    sum_squares(halves[0], smooth_response(halves[1], penalty)));
  }
  const double least = std::ranges::min_element(tried, {}, &std::pair<double, double>::second)->second;
  if (form.sum_squares <= about * least) return kernel_of(form.response);
  const auto smoothest = std::find_if(tried.rbegin(), tried.rend(),
                                      [&](const auto& each) { return each.second <= about * least; });
  return kernel_of(smooth_response(halves[0] + halves[1], smoothest->first));
}

struct Smoothing {
  Curve delayed;
  Curve smoothed;
  DelayKernel kernel;
  bool is_smoothed = false;
};

Smoothing smoothing_of(const Windows& windows) {
  const WindowProducts all = sum_of(windows);
  Smoothing found{best_delay(all), best_smoothing(all), {}};
  const bool is_wider = found.smoothed.sum_squares < found.delayed.sum_squares;
  found.kernel = kernel_of(windows, is_wider ? found.smoothed : found.delayed);
  found.is_smoothed = is_wider && found.smoothed.width_s >= matters_s &&
                      is_surely_better(windows, found.smoothed.response, found.delayed.response);
  return found;
}

// Whether a reference's heading turns about as far as the wheels turn the robot, by the scale of its way.
// Where commands turn the robot hardly, unequal wheels and a floor do, and no delay relates that to the
// counts.
bool shows_the_counted_turns(const Curve& heading, double gain_of_way) {
  constexpr double most_ratio = 1.5;
  const double ratio = heading.response.sum() / gain_of_way;
  return ratio > 1.0 / most_ratio && ratio < most_ratio;
}

// Whether the heading comes at another time than the place.
bool heading_is_apart(const Windows& windows, const Curve& heading, const Curve& position) {
  if (std::abs(heading.delay_s - position.delay_s) < apart_s) return false;
  return is_surely_better(windows, heading.response,
                          with_gain(sum_of(windows), pure_delay(position.delay_s)));
}

std::string in_words(const DelayKernel& kernel) {
  const auto rounded = [](double time_s) { return in_digits(std::round(100.0 * time_s) / 100.0, 3); };
  return "with a rise time of " + rounded(kernel.rise_time_s()) + " s (10 to 90 %), " +
         rounded(std::abs(kernel.mean_s())) + (kernel.mean_s() < 0.0 ? " s early" : " s late");
}

}  // namespace

std::optional<ReferenceResponse> find_reference_response(std::span<const DriveLog* const> runs) {
  const ResponseWindows windows = response_windows(runs);
  if (windows.heading.size() < least_counted_windows) return std::nullopt;
  const Smoothing heading = smoothing_of(windows.heading);
  if (windows.position.size() < least_counted_windows) {
    if (!heading.is_smoothed || !shows_the_counted_turns(heading.smoothed, 1.0)) return std::nullopt;
    return ReferenceResponse{{}, heading.kernel};
  }
  const Smoothing position = smoothing_of(windows.position);
  if (!shows_the_counted_turns(heading.delayed, position.delayed.response.sum())) {
    if (!position.is_smoothed) return std::nullopt;
    return ReferenceResponse{position.kernel, {}};
  }
  if (!heading.is_smoothed && !position.is_smoothed &&
      !heading_is_apart(windows.heading, heading.delayed, position.delayed))
    return std::nullopt;
  return ReferenceResponse{position.kernel, heading.kernel};
}

std::string in_words(const ReferenceResponse& response) {
  std::string text = "the reference does not show the robot at once: ";
  const bool both = !response.position.weights.empty() && !response.heading.weights.empty();
  if (!response.position.weights.empty()) text += "x and y " + in_words(response.position);
  if (both) text += "; ";
  if (!response.heading.weights.empty()) text += "its heading " + in_words(response.heading);
  return text;
}

}  // namespace wheelwright
