#include "model/log/lost_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "model/statistics/significant_digits.hpp"

namespace wheelwright {
namespace {

constexpr double times_usual = 5.0;
constexpr std::size_t rows_at_an_end = 3;
constexpr std::size_t longest_outlier = 3;
constexpr std::size_t shortest_hold = 4;
constexpr double times_beside_outlier = 3.0;

// What nine of ten changes between neighbouring rows are; those without a change are left out. Infinite where
// nothing changes.
double usual_change(std::span<const double> values) {
  std::vector<double> changes;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = std::abs(values[i] - values[i - 1]);
    if (std::isfinite(change) && change > 0.0) changes.push_back(change);
  }
  if (changes.empty()) return std::numeric_limits<double>::infinity();
  const auto at = changes.begin() + static_cast<std::ptrdiff_t>(9 * (changes.size() - 1) / 10);
  std::ranges::nth_element(changes, at);
  return *at;
}

class Jumps {
 public:
  explicit Jumps(std::span<const double> values)
      : values_(values), least_(times_usual * usual_change(values)) {}

  // Into the stretch and out of it, or at the only end that lies within.
  bool are_around(const RowStretch& stretch) const {
    const bool is_first = stretch.begin == 0;
    const bool is_last = stretch.end == values_.size();
    if (is_first && is_last) return false;
    if (is_first) return stretch.end - stretch.begin >= rows_at_an_end && is_jump(stretch.end);
    if (is_last) return stretch.end - stretch.begin >= rows_at_an_end && is_jump(stretch.begin);
    const double in = change(stretch.begin);
    const double out = change(stretch.end);
    return is_jump(stretch.begin) && is_jump(stretch.end) &&
           std::abs(in + out) < 0.5 * std::min(std::abs(in), std::abs(out));
  }

  bool is_jump(std::size_t row) const { return std::abs(change(row)) > least_; }

  // From the row before.
  double change(std::size_t row) const { return values_[row] - values_[row - 1]; }

 private:
  std::span<const double> values_;
  double least_;
};

}  // namespace

std::vector<RowStretch> lost_stretches(std::span<const double> x, std::span<const double> y) {
  // A pose is not in each row where its tracker is slower.
  std::vector<std::size_t> rows;
  std::vector<double> placed_x;
  std::vector<double> placed_y;
  bool are_equal = false;
  for (std::size_t row = 0; row < std::min(x.size(), y.size()); ++row) {
    if (!std::isfinite(x[row]) || !std::isfinite(y[row])) continue;
    rows.push_back(row);
    placed_x.push_back(x[row]);
    placed_y.push_back(y[row]);
    are_equal = are_equal || x[row] == y[row];
  }
  std::vector<RowStretch> lost;
  if (!are_equal) return lost;
  const Jumps of_x(placed_x);
  const Jumps of_y(placed_y);
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin + 1;
    while (end < rows.size() && placed_x[end] == placed_x[begin] && placed_y[end] == placed_y[begin]) ++end;
    const RowStretch stretch{begin, end};
    if (placed_x[begin] == placed_y[begin] && (of_x.are_around(stretch) || of_y.are_around(stretch)))
      lost.push_back({rows[begin], end < rows.size() ? rows[end] : x.size()});
    begin = end;
  }
  return lost;
}

std::vector<RowStretch> outlier_stretches(std::span<const double> values) {
  std::vector<RowStretch> outliers;
  if (values.size() < 4) return outliers;
  const Jumps jumps(values);
  for (std::size_t begin = 2; begin < values.size(); ++begin) {
    if (!jumps.is_jump(begin)) continue;
    for (std::size_t end = begin + 1; end <= begin + longest_outlier && end + 1 < values.size(); ++end) {
      const double beside = std::max(std::abs(jumps.change(begin - 1)), std::abs(jumps.change(end + 1)));
      const double least = std::min(std::abs(jumps.change(begin)), std::abs(jumps.change(end)));
      if (!jumps.are_around({begin, end}) || least < times_beside_outlier * beside) continue;
      outliers.push_back({begin, end});
      begin = end;
      break;
    }
  }
  return outliers;
}

std::vector<RowStretch> held_stretches(std::span<const double> x, std::span<const double> y,
                                       std::span<const double> heading) {
  std::vector<RowStretch> held;
  const std::array<Jumps, 3> jumps{Jumps(x), Jumps(y), Jumps(heading)};
  for (std::size_t begin = 0; begin < x.size();) {
    std::size_t end = begin + 1;
    while (end < x.size() && x[end] == x[begin] && y[end] == y[begin] && heading[end] == heading[begin])
      ++end;
    const bool jumps_on =
        end < x.size() && std::ranges::any_of(jumps, [end](const Jumps& each) { return each.is_jump(end); });
    if (end - begin >= shortest_hold && jumps_on) held.push_back({begin + 1, end});
    begin = end;
  }
  return held;
}

void blank(std::span<const RowStretch> stretches, std::vector<double>& values) {
  for (const RowStretch& stretch : stretches) {
    for (std::size_t row = stretch.begin; row < std::min(stretch.end, values.size()); ++row)
      values[row] = std::numeric_limits<double>::quiet_NaN();
  }
}

std::string in_words(std::span<const RowStretch> stretches, std::span<const double> x) {
  std::size_t rows = 0;
  std::set<double> numbers;
  for (const RowStretch& stretch : stretches) {
    rows += stretch.end - stretch.begin;
    numbers.insert(x[stretch.begin]);
  }
  std::string text = "the pose is lost in " + std::to_string(rows) + (rows == 1 ? " row" : " rows");
  if (stretches.size() > 1) text += " (" + std::to_string(stretches.size()) + " times)";
  text += ", where x and y are both ";
  for (const double number : numbers) {
    if (number != *numbers.begin()) text += " or ";
    text += in_digits(number, 4);
  }
  return text;
}

}  // namespace wheelwright
