#include "model/log/run_periods.hpp"

#include <algorithm>

#include "model/log/command_timeline.hpp"

namespace wheelwright {
namespace {

constexpr double time_tolerance = 1e-4;  // of a period; times in files are printed with microseconds

// Travel of the wheels since the first row at rising times.
class TravelReader {
 public:
  explicit TravelReader(const DriveLog& log) : log_(log) { move_to_next_reading(); }

  // Nothing in a hole, before the first reading and after the last. Times must not fall.
  std::optional<WheelPair> at(double t_s) {
    const auto& rows = log_.samples;
    const double tolerance_s = time_tolerance * log_.period_s;
    while (next_ < rows.size() && rows[next_].t_s < t_s - tolerance_s) move_to_next_reading();
    if (next_ >= rows.size()) return std::nullopt;
    const WheelPair after = travel(next_);
    const double step_s = rows[next_].t_s - rows[last_].t_s;
    if (rows[next_].t_s <= t_s + tolerance_s && last_ == next_) return after;
    if (last_ == next_) return std::nullopt;
    const double share = std::min(1.0, (t_s - rows[last_].t_s) / step_s);
    if (step_s > longest_step_periods * log_.period_s && share < 1.0 - time_tolerance) return std::nullopt;
    const WheelPair before = travel(last_);
    return WheelPair{before.left + share * (after.left - before.left),
                     before.right + share * (after.right - before.right)};
  }

 private:
  void move_to_next_reading() {
    const auto& rows = log_.samples;
    std::size_t row = found_ ? next_ + 1 : 0;
    while (row < rows.size() && !rows[row].ticks) ++row;
    last_ = found_ ? next_ : row;
    next_ = row;
    found_ = true;
  }

  WheelPair travel(std::size_t row) const {
    const WheelTicks& now = *log_.samples[row].ticks;
    const WheelTicks& start = *log_.samples.front().ticks;
    return {static_cast<double>(now.left - start.left) * log_.metres_per_tick->left,
            static_cast<double>(now.right - start.right) * log_.metres_per_tick->right};
  }

  const DriveLog& log_;
  std::size_t last_ = 0;  // the readings on both sides of the time asked for
  std::size_t next_ = 0;
  bool found_ = false;
};

// Tells which periods touch a hole between rows.
class HoleFinder {
 public:
  explicit HoleFinder(const DriveLog& log) : log_(log) {}

  bool touches(double from_s, double to_s) {
    const auto& rows = log_.samples;
    const double tolerance_s = time_tolerance * log_.period_s;
    while (row_ + 1 < rows.size() && rows[row_ + 1].t_s <= from_s + tolerance_s) ++row_;
    for (std::size_t k = row_; k + 1 < rows.size() && rows[k].t_s < to_s - tolerance_s; ++k) {
      if (rows[k + 1].t_s - rows[k].t_s > longest_step_periods * log_.period_s) return true;
    }
    return false;
  }

 private:
  const DriveLog& log_;
  std::size_t row_ = 0;
};

}  // namespace

void for_each_period(const DriveLog& log, double period_s,
                     const std::function<void(const RunPeriod&)>& visitor) {
  if (!log.has_ticks()) return;
  const CommandTimeline timeline(log);
  TravelReader travel(log);
  HoleFinder holes(log);
  const double start_s = log.samples.front().t_s;
  const double end_s = log.samples.back().t_s + time_tolerance * period_s;
  auto before = travel.at(start_s);
  double from_s = start_s;
  for (std::size_t k = 1;; ++k) {
    const double to_s = start_s + period_s * static_cast<double>(k);
    if (to_s > end_s) return;
    const auto after = travel.at(to_s);
    RunPeriod period{holes.touches(from_s, to_s), timeline.mean_m_s(from_s, to_s), std::nullopt};
    if (before && after) {
      period.speed_m_s =
          WheelPair{(after->left - before->left) / period_s, (after->right - before->right) / period_s};
    }
    visitor(period);
    before = after;
    from_s = to_s;
  }
}

}  // namespace wheelwright
