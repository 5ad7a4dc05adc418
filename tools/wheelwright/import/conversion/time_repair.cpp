#include "tools/wheelwright/import/conversion/time_repair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/load/text_format.hpp"
#include "model/statistics/order_statistics.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;
using config::plain_number;

constexpr double restart_hole_s = 10.0;
constexpr double restart_below_s = 1.0;
constexpr std::size_t max_out_of_order = 5;  // rows by which one may be late
constexpr std::size_t max_remarks = 5;       // of a kind, with their places

// Says the first few of a kind, and how many there are.
class Kind {
 public:
  void add(const std::string& where) {
    if (count_++ < max_remarks) places_ += (places_.empty() ? "" : ", ") + where;
  }
  void say(std::vector<std::string>& remarks, const std::string& what) const {
    if (count_ == 0) return;
    const std::string more =
        count_ > max_remarks ? ", and " + std::to_string(count_ - max_remarks) + " more" : "";
    remarks.push_back(places_ + more + ": " + what);
  }

 private:
  std::size_t count_ = 0;
  std::string places_;
};

class Repair {
 public:
  Repair(std::span<const double> t_s, const RowQuestions& ask) : stamps_s_(t_s), ask_(ask) {
    pause_s_ = std::max(longest_pause_s, longest_pause_steps * median_step_s(t_s));
    result_.t_s.assign(t_s.begin(), t_s.end());
  }

  TimeRepair run() {
    for (std::size_t row = 0; row < stamps_s_.size(); ++row) {
      if (!std::isfinite(stamps_s_[row])) {
        untimed_.add(ask_.place(row));
        continue;
      }
      add(row);
    }
    finish_run();
    untimed_.say(result_.remarks, "no time, left out");
    twice_.say(result_.remarks, "the stamp of the row before once more, with the same values, left out");
    replaced_.say(result_.remarks, "the stamp of the row before once more; the later row is kept");
    late_.say(result_.remarks, "out of order, sorted by time");
    short_.say(result_.remarks, "a run of a single row, left out");
    return std::move(result_);
  }

 private:
  // On the clock of the run.
  double time_s(std::size_t row) const { return stamps_s_[row] + offset_s_; }

  void add(std::size_t row) {
    result_.t_s[row] = time_s(row);
    if (rows_.empty()) {
      rows_.push_back(row);
      return;
    }
    const double last_s = result_.t_s[rows_.back()];
    const double step_s = time_s(row) - last_s;
    if (step_s > 0.0 && step_s <= pause_s_) {
      rows_.push_back(row);
    } else if (step_s == 0.0) {
      add_same_stamp(row);
    } else if (step_s < 0.0 && is_late(row, last_s)) {
      late_.add(ask_.place(row));
      rows_.insert(first_after(time_s(row)), row);
    } else {
      add_behind_break(row, step_s);
    }
  }

  void add_same_stamp(std::size_t row) {
    (ask_.are_alike(rows_.back(), row) ? twice_ : replaced_).add(ask_.place(row));
    rows_.back() = row;
  }

  RunRows::iterator first_after(double t_s) {
    return std::ranges::upper_bound(rows_, t_s, {}, [this](std::size_t r) { return result_.t_s[r]; });
  }

  // The rows behind it go on where those before it ended.
  bool is_late(std::size_t row, double last_s) {
    if (time_s(row) < result_.t_s[rows_.front()]) return false;
    for (std::size_t next = row + 1; next < stamps_s_.size() && next <= row + max_out_of_order; ++next) {
      if (time_s(next) > last_s) return time_s(next) - last_s <= pause_s_ && is_few(row, last_s);
    }
    return false;
  }

  // A clock that was set back goes through as many rows again as it was set back by.
  bool is_few(std::size_t row, double last_s) {
    const auto repeated = static_cast<std::size_t>(rows_.end() - first_after(time_s(row)));
    std::size_t behind = 0;
    for (std::size_t next = row; next < stamps_s_.size() && time_s(next) <= last_s; ++next) ++behind;
    return repeated <= max_out_of_order && (behind == 1 || behind < repeated);
  }

  void add_behind_break(std::size_t row, double step_s) {
    const std::string by = step_s < 0.0 ? "the clock goes back by " + text(-step_s)
                                        : "no rows for " + text(step_s) + " by the clock";
    if (step_s < 0.0) ++result_.set_back;
    const bool starts_again = step_s < 0.0 && stamps_s_[row] < restart_below_s;
    if (starts_again || (ask_.is_at_rest(rows_.back()) && ask_.is_at_rest(row))) {
      finish_run();
      offset_s_ = 0.0;
      result_.t_s[row] = stamps_s_[row];
      result_.remarks.push_back(ask_.place(row) + ": " + by + "; a new run begins");
    } else {
      offset_s_ = result_.t_s[rows_.back()] + restart_hole_s - stamps_s_[row];
      result_.t_s[row] = time_s(row);
      result_.remarks.push_back(ask_.place(row) + ": " + by +
                                " while the robot drives; taken for a hole of " +
                                fixed_number(restart_hole_s, 0) + " s");
    }
    rows_.push_back(row);
  }

  static std::string text(double duration_s) {
    return duration_s < 1000.0 ? fixed_number(duration_s, 3) + " s"
                               : plain_number(std::round(duration_s)) + " s";
  }

  void finish_run() {
    if (rows_.size() == 1) short_.add(ask_.place(rows_.front()));
    if (rows_.size() > 1) result_.runs.push_back(std::move(rows_));
    rows_.clear();
  }

  std::span<const double> stamps_s_;
  const RowQuestions& ask_;
  double offset_s_ = 0.0;  // of the run's clock beyond that of the file
  double pause_s_ = 0.0;
  RunRows rows_;
  TimeRepair result_;
  Kind untimed_, twice_, replaced_, late_, short_;
};

}  // namespace

double median_step_s(std::span<const double> t_s) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] > t_s[i - 1]) steps_s.push_back(t_s[i] - t_s[i - 1]);
  }
  return steps_s.empty() ? 0.0 : median(std::move(steps_s));
}

std::size_t spread_coarse_stamps(std::vector<double>& t_s) {
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] == t_s[i - 1]) ++repeated;
  }
  if (3 * repeated < t_s.size() || t_s.empty()) return 0;
  std::size_t begin = 0;
  double step_s = 0.0;
  while (begin < t_s.size()) {
    std::size_t end = begin + 1;
    while (end < t_s.size() && t_s[end] == t_s[begin]) ++end;
    const double stamp_s = t_s[begin];
    // The last group has no next step: it goes on as the one before.
    if (end < t_s.size() && t_s[end] > stamp_s)
      step_s = (t_s[end] - stamp_s) / static_cast<double>(end - begin);
    for (std::size_t i = begin; i < end; ++i) t_s[i] = stamp_s + step_s * static_cast<double>(i - begin);
    begin = end;
  }
  return repeated;
}

TimeRepair repair_time(std::span<const double> t_s, const RowQuestions& rows) {
  return Repair(t_s, rows).run();
}

}  // namespace wheelwright::import
