#include "tools/wheelwright/import/conversion/lost_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "config/load/text_format.hpp"

namespace wheelwright::import {
namespace {

constexpr double times_usual = 5.0;
constexpr std::size_t rows_at_an_end = 3;

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

  bool are_around(const LostStretch& stretch) const {
    const bool is_first = stretch.begin == 0;
    const bool is_last = stretch.end == values_.size();
    if (is_first && is_last) return false;
    const double in = is_first ? 0.0 : values_[stretch.begin] - values_[stretch.begin - 1];
    const double out = is_last ? 0.0 : values_[stretch.end] - values_[stretch.end - 1];
    if (is_first || is_last)
      return stretch.end - stretch.begin >= rows_at_an_end && std::abs(in + out) > least_;
    return std::min(std::abs(in), std::abs(out)) > least_ &&
           std::abs(in + out) < 0.5 * std::min(std::abs(in), std::abs(out));
  }

 private:
  std::span<const double> values_;
  double least_;
};

}  // namespace

std::vector<LostStretch> lost_stretches(std::span<const double> x, std::span<const double> y) {
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
  std::vector<LostStretch> lost;
  if (!are_equal) return lost;
  const Jumps of_x(placed_x);
  const Jumps of_y(placed_y);
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin + 1;
    while (end < rows.size() && placed_x[end] == placed_x[begin] && placed_y[end] == placed_y[begin]) ++end;
    const LostStretch stretch{begin, end};
    if (placed_x[begin] == placed_y[begin] && (of_x.are_around(stretch) || of_y.are_around(stretch)))
      lost.push_back({rows[begin], end < rows.size() ? rows[end] : x.size()});
    begin = end;
  }
  return lost;
}

void blank(std::span<const LostStretch> stretches, std::vector<double>& values) {
  for (const LostStretch& stretch : stretches) {
    for (std::size_t row = stretch.begin; row < std::min(stretch.end, values.size()); ++row)
      values[row] = std::numeric_limits<double>::quiet_NaN();
  }
}

std::string in_words(std::span<const LostStretch> stretches, std::span<const double> x) {
  std::size_t rows = 0;
  std::set<double> numbers;
  for (const LostStretch& stretch : stretches) {
    rows += stretch.end - stretch.begin;
    numbers.insert(x[stretch.begin]);
  }
  std::string text = "the pose is lost in " + std::to_string(rows) + (rows == 1 ? " row" : " rows");
  if (stretches.size() > 1) text += " (" + std::to_string(stretches.size()) + " times)";
  text += ", where x and y are both ";
  for (const double number : numbers) {
    if (number != *numbers.begin()) text += " or ";
    text += config::plain_number(number);
  }
  return text;
}

}  // namespace wheelwright::import
