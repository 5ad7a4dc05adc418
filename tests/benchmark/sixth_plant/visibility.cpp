#include "tests/benchmark/sixth_plant/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/benchmark/sixth_plant/linear_fit.hpp"

namespace plants::sixth {

namespace {

constexpr std::size_t lags = 8;
constexpr std::array memories_s{0.03, 0.06, 0.12, 0.25, 0.5, 1.0};
constexpr std::size_t regressors = wheel_count * (lags + memories_s.size());
constexpr std::array horizons_s{0.1, 0.3, 1., 3., 10.};

// Commands of the last rows, and before them as they are forgotten at several paces.
class CommandMemory {
 public:
  explicit CommandMemory(double period_s) {
    for (std::size_t index = 0; index < memories_s.size(); ++index)
      fresh_[index] = 1 - std::exp(-period_s / memories_s[index]);
  }

  std::array<double, regressors> step(const std::vector<LogRow>& rows, std::size_t row) {
    std::array<double, regressors> values{};
    std::size_t count = 0;
    const auto command = [&](std::size_t lag, std::size_t side) {
      return row >= lag ? rows[row - lag].command_m_s[side] : 0;
    };
    for (const std::size_t side : {left_side, right_side}) {
      for (std::size_t lag = 0; lag < lags; ++lag) values[count++] = command(lag, side);
      for (std::size_t index = 0; index < memories_s.size(); ++index) {
        double& kept = kept_[side][index];
        kept += (command(lags, side) - kept) * fresh_[index];
        values[count++] = kept;
      }
    }
    const double seconds = rows[row + 1].time_s - rows[row].time_s;
    for (double& value : values) value *= seconds;
    return values;
  }

 private:
  std::array<double, memories_s.size()> fresh_{};
  PerWheel<std::array<double, memories_s.size()>> kept_{};
};

// What was measured of the motion between rows, all runs one behind the other.
class Measured {
 public:
  Measured(const std::vector<Run>& runs, bool ticks, bool poses)
      : ticks_(ticks), poses_(poses), period_s_(runs.front().log.period_s) {
    // What the poses show beside the ticks has no linear part; nor has the way aside.
    if (ticks) fitted_ = {true, true};
    if (poses) fitted_.insert(fitted_.end(), {!ticks, !ticks, false});
    targets_.resize(regressors * fitted_.size());
    for (const Run& run : runs) {
      CommandMemory memory(period_s_);
      for (std::size_t row = 0; row + 1 < run.log.rows.size(); ++row)
        add(memory.step(run.log.rows, row), moved(run.log, row));
      ends_.push_back(rows_);
    }
  }

  std::vector<double> left_over() {
    take_off_the_fit();
    std::vector<double> sizes;
    for (std::size_t quantity = 0; quantity < fitted_.size(); ++quantity)
      for (const double horizon_s : horizons_s) sizes.push_back(size_over(quantity, horizon_s));
    return sizes;
  }

 private:
  using Moved = std::vector<double>;

  [[nodiscard]] Moved moved(const DriveLog& log, std::size_t row) const {
    const LogRow& from = log.rows[row];
    const LogRow& to = log.rows[row + 1];
    PerWheel<double> rolled_m{};
    for (const std::size_t side : {left_side, right_side})
      rolled_m[side] = static_cast<double>(to.ticks[side] - from.ticks[side]) * log.metres_per_tick;
    Moved moved;
    if (ticks_) moved.assign(rolled_m.begin(), rolled_m.end());
    if (!poses_) return moved;
    const double heading_rad = (from.reference->heading_rad + to.reference->heading_rad) / 2;
    const double x_m = to.reference->x_m - from.reference->x_m;
    const double y_m = to.reference->y_m - from.reference->y_m;
    double forward_m = std::cos(heading_rad) * x_m + std::sin(heading_rad) * y_m;
    double turned_rad = to.reference->heading_rad - from.reference->heading_rad;
    if (ticks_) {
      forward_m -= (rolled_m[left_side] + rolled_m[right_side]) / 2;
      turned_rad -= (rolled_m[right_side] - rolled_m[left_side]) / log.wheel_base_m;
    }
    const double aside_m = -std::sin(heading_rad) * x_m + std::cos(heading_rad) * y_m;
    moved.insert(moved.end(), {forward_m, turned_rad, aside_m});
    return moved;
  }

  void add(const std::array<double, regressors>& values, const Moved& moved) {
    const std::size_t quantities = fitted_.size();
    for (std::size_t row = 0; row < regressors; ++row) {
      for (std::size_t column = 0; column <= row; ++column)
        gram_[row * regressors + column] += values[row] * values[column];
      for (std::size_t quantity = 0; quantity < quantities; ++quantity)
        targets_[row * quantities + quantity] += values[row] * moved[quantity];
    }
    // Single precision halves what the longest runs take of memory.
    for (const double value : values) values_.push_back(static_cast<float>(value));
    moved_.insert(moved_.end(), moved.begin(), moved.end());
    ++rows_;
  }

  void take_off_the_fit() {
    const std::size_t quantities = fitted_.size();
    const std::vector<double> weights = solved(gram_, targets_, regressors, quantities);
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t quantity = 0; quantity < quantities; ++quantity) {
        if (!fitted_[quantity]) continue;
        for (std::size_t index = 0; index < regressors; ++index)
          moved_[row * quantities + quantity] -=
              static_cast<double>(values_[row * regressors + index]) * weights[index * quantities + quantity];
      }
  }

  [[nodiscard]] double size_over(std::size_t quantity, double horizon_s) const {
    const auto span = static_cast<std::size_t>(std::max(1L, std::lround(horizon_s / period_s_)));
    double squares = 0;
    long count = 0;
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
      std::vector<double> sums{0};
      for (std::size_t row = begin; row < end; ++row)
        sums.push_back(sums.back() + moved_[row * fitted_.size() + quantity]);
      for (std::size_t row = span; row < sums.size(); row += std::max<std::size_t>(1, span / 4)) {
        const double difference = sums[row] - sums[row - span];
        squares += difference * difference;
        ++count;
      }
      begin = end;
    }
    return std::sqrt(squares / static_cast<double>(std::max(1L, count)));
  }

  bool ticks_;
  bool poses_;
  double period_s_;
  std::vector<bool> fitted_;
  std::vector<double> gram_ = std::vector<double>(regressors * regressors);
  std::vector<double> targets_;
  std::vector<float> values_;
  std::vector<double> moved_;
  std::vector<std::size_t> ends_;
  std::size_t rows_ = 0;
};

}  // namespace

std::vector<double> residuals(const std::vector<Run>& runs, bool ticks, bool poses) {
  return Measured(runs, ticks, poses).left_over();
}

double visibility(const std::vector<double>& hidden, const std::vector<double>& clean) {
  double most = 0;
  for (std::size_t index = 0; index < hidden.size(); ++index) {
    const double more = hidden[index] * hidden[index] - clean[index] * clean[index];
    most = std::max(most, std::sqrt(std::max(0., more)) / clean[index]);
  }
  return most;
}

}  // namespace plants::sixth
