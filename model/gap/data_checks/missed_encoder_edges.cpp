#include "model/gap/data_checks/missed_encoder_edges.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/log/command_timeline.hpp"
#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

// Bounds of the segments of past command that a wheel's speed is made of.
constexpr std::array response_s{0.0, 0.02, 0.04, 0.06, 0.08, 0.11, 0.15, 0.2, 0.3, 0.45, 0.7};
constexpr Eigen::Index response_size = response_s.size() - 1;
constexpr double shortest_s = 0.15;
constexpr double min_speed_m_s = 0.05;   // a slower wheel may stick
constexpr double min_edges = 8.0;        // expected in the shortest segment
constexpr double max_counted = 0.65;     // of what is expected
constexpr double no_motor_m_s2 = 1.0;    // that brakes at a steady command
constexpr double edge_closeness = 0.15;  // of the share counted, to that inside and to all of it outside
constexpr double edge_steady = 0.15;     // by which the expected speed may change there
constexpr std::size_t edge_rows = 3;

// Sums over the rows up to one, so that those of any segment are a difference.
struct Sums {
  double expected_m = 0.0;
  double counted_m = 0.0;
  double sum_squares = 0.0;
  double products = 0.0;
  double known = 0.0;
};

Sums operator-(const Sums& to, const Sums& from) {
  return {to.expected_m - from.expected_m, to.counted_m - from.counted_m, to.sum_squares - from.sum_squares,
          to.products - from.products, to.known - from.known};
}

double share_of(const Sums& sums) {
  return sums.counted_m / sums.expected_m;
}

class Finder {
 public:
  Finder(const DriveLog& log, std::span<const char> left_out, bool left)
      : log_(log),
        left_(left),
        tick_m_(left ? log.metres_per_tick->left : log.metres_per_tick->right),
        window_(static_cast<std::size_t>(std::ceil(shortest_s / log.period_s))),
        known_(log.samples.size(), 0) {
    for (std::size_t k = 1; k < known_.size(); ++k) {
      const auto& [before, here] = std::pair(log.samples[k - 1], log.samples[k]);
      const bool close = here.t_s - before.t_s < 2.0 * log.period_s;
      known_[k] = close && here.ticks && before.ticks && left_out[k] == 0 && left_out[k - 1] == 0 ? 1 : 0;
    }
  }

  std::vector<ThinnedCounts> find() {
    if (known_.size() < 10 * window_) return {};
    expect();
    auto found = segments();
    if (found.empty()) return found;
    // What was found has bent the response a little.
    auto known = known_;
    for (const auto& segment : found) {
      for (std::size_t k = segment.first_row; k <= segment.last_row; ++k) known_[k] = 0;
    }
    const auto response = fitted_response();
    known_ = std::move(known);
    sum_up(response);
    return segments();
  }

 private:
  double counted_m(std::size_t row) const {
    const auto of = [&](std::size_t k) {
      return left_ ? log_.samples[k].ticks->left : log_.samples[k].ticks->right;
    };
    return tick_m_ * static_cast<double>(of(row) - of(row - 1));
  }
  void expect();
  Eigen::VectorXd fitted_response() const;
  void sum_up(const Eigen::VectorXd& response);
  Sums over(std::size_t first, std::size_t end) const { return sums_[end] - sums_[first]; }
  bool thin(std::size_t first) const;
  std::vector<ThinnedCounts> segments() const;
  std::optional<ThinnedCounts> sharpened(std::size_t first, std::size_t end) const;
  bool has_sharp_edges(std::size_t first, std::size_t end) const;
  bool sharp(const Sums& outside, const Sums& inside, double share) const;

  const DriveLog& log_;
  bool left_;
  double tick_m_;
  std::size_t window_;
  std::vector<char> known_;  // rows whose counts since the row before are known
  Eigen::MatrixXd commanded_;
  std::vector<Sums> sums_;  // over the rows before each
};

// The commands that each row's travel is made of.
void Finder::expect() {
  const CommandTimeline commands(log_);
  commanded_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(known_.size()), response_size);
  for (std::size_t k = 1; k < known_.size(); ++k) {
    if (known_[k] == 0) continue;
    const double to_s = log_.samples[k].t_s;
    const double duration_s = to_s - log_.samples[k - 1].t_s;
    for (std::size_t i = 0; i + 1 < response_s.size(); ++i) {
      const WheelPair mean = commands.mean_m_s(to_s - response_s[i + 1], to_s - response_s[i]);
      commanded_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
          duration_s * (left_ ? mean.left : mean.right);
    }
  }
  sum_up(fitted_response());
}

Eigen::VectorXd Finder::fitted_response() const {
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(response_size, response_size);
  Eigen::VectorXd travels = Eigen::VectorXd::Zero(response_size);
  for (std::size_t k = 1; k < known_.size(); ++k) {
    if (known_[k] == 0) continue;
    const Eigen::VectorXd row = commanded_.row(static_cast<Eigen::Index>(k)).transpose();
    products += row * row.transpose();
    travels += row * counted_m(k);
  }
  products.diagonal().array() += 1e-6 * products.trace() + 1e-12;
  return solve_symmetric(products, travels);
}

void Finder::sum_up(const Eigen::VectorXd& response) {
  sums_.assign(known_.size() + 1, {});
  for (std::size_t k = 0; k < known_.size(); ++k) {
    sums_[k + 1] = sums_[k];
    if (known_[k] == 0) continue;
    const double expected = commanded_.row(static_cast<Eigen::Index>(k)).dot(response);
    const double counted = counted_m(k);
    Sums& sum = sums_[k + 1];
    sum.expected_m += expected;
    sum.counted_m += counted;
    sum.sum_squares += expected * expected;
    sum.products += expected * counted;
    sum.known += 1.0;
  }
}

bool Finder::thin(std::size_t first) const {
  const Sums sums = over(first, first + window_);
  const double expected = std::abs(sums.expected_m);
  if (sums.known < static_cast<double>(window_) || expected < min_edges * tick_m_ ||
      expected < min_speed_m_s * shortest_s) {
    return false;
  }
  const double share = share_of(sums);
  return share < max_counted && share > -0.1;
}

std::vector<ThinnedCounts> Finder::segments() const {
  std::vector<ThinnedCounts> found;
  for (std::size_t first = 1; first + window_ <= known_.size(); ++first) {
    if (!thin(first)) continue;
    std::size_t last = first;
    while (last + window_ < known_.size() && thin(last + 1)) ++last;
    if (const auto segment = sharpened(first, last + window_)) found.push_back(*segment);
    first = last + window_;
  }
  return found;
}

// The windows reach beyond the segment on both sides: its ends are where one share explains the most.
std::optional<ThinnedCounts> Finder::sharpened(std::size_t first, std::size_t end) const {
  std::size_t best_first = first;
  std::size_t best_end = end;
  double most = 0.0;
  for (std::size_t from = first; from < std::min(first + window_, end); ++from) {
    for (std::size_t to = end; to > std::max(end - window_, from + 1); --to) {
      const Sums sums = over(from, to);
      const double gain = std::pow(sums.sum_squares - sums.products, 2) / std::max(sums.sum_squares, 1e-12);
      if (gain <= most) continue;
      most = gain;
      best_first = from;
      best_end = to;
    }
  }
  const Sums sums = over(best_first, best_end);
  const double duration_s = log_.samples[best_end - 1].t_s - log_.samples[best_first - 1].t_s;
  const double share = share_of(sums);
  if (duration_s < shortest_s || share > max_counted || !has_sharp_edges(best_first, best_end)) return {};
  return ThinnedCounts{best_first, best_end - 1, std::clamp(1.0 - share, 0.0, 1.0),
                       sums.expected_m - sums.counted_m};
}

bool Finder::has_sharp_edges(std::size_t first, std::size_t end) const {
  if (first < edge_rows + 1 || end + edge_rows > known_.size() || end - first < 2 * edge_rows) return false;
  const double share = share_of(over(first, end));
  return sharp(over(first - edge_rows, first), over(first, first + edge_rows), share) &&
         sharp(over(end, end + edge_rows), over(end - edge_rows, end), share);
}

bool Finder::sharp(const Sums& outside, const Sums& inside, double share) const {
  const double rows = edge_rows;
  if (outside.known < rows || inside.known < rows) return false;
  const double change = std::abs(outside.expected_m - inside.expected_m);
  const double lost_m_s = std::abs(outside.counted_m - inside.counted_m) / (rows * log_.period_s);
  return lost_m_s > no_motor_m_s2 * rows * log_.period_s &&
         change < edge_steady * std::abs(inside.expected_m) &&
         std::abs(share_of(outside) - 1.0) < edge_closeness &&
         std::abs(share_of(inside) - share) < edge_closeness;
}

}  // namespace

std::vector<ThinnedCounts> find_missed_encoder_edges(const DriveLog& log, std::span<const char> left_out,
                                                     bool left) {
  return Finder(log, left_out, left).find();
}

}  // namespace wheelwright::gap
