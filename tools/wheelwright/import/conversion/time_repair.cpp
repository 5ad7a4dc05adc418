#include "tools/wheelwright/import/conversion/time_repair.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;
using config::plain_number;

constexpr double longest_pause_s = 60.0;
constexpr double longest_pause_steps = 50.0;
constexpr std::size_t most_out_of_order = 5;  // rows by which one may be late
constexpr std::size_t most_remarks = 5;       // of a kind, with their places

double median_step(std::span<const double> t_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    if (t_s[i] > t_s[i - 1]) steps.push_back(t_s[i] - t_s[i - 1]);
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

// Says the first few of a kind, and how many there are.
class Kind {
 public:
  void add(const std::string& where) {
    if (count_++ < most_remarks) places_ += (places_.empty() ? "" : ", ") + where;
  }
  void say(std::vector<std::string>& remarks, const std::string& what) const {
    if (count_ == 0) return;
    const std::string more =
        count_ > most_remarks ? ", and " + std::to_string(count_ - most_remarks) + " more" : "";
    remarks.push_back(places_ + more + ": " + what);
  }

 private:
  std::size_t count_ = 0;
  std::string places_;
};

class Repair {
 public:
  Repair(std::span<const double> t_s, const std::function<std::string(std::size_t)>& place,
         const std::function<bool(std::size_t, std::size_t)>& same)
      : t_s_(t_s), place_(place), same_(same) {
    const double step_s = median_step(t_s);
    pause_s_ = std::max(longest_pause_s, longest_pause_steps * step_s);
  }

  TimeRepair run() {
    for (std::size_t row = 0; row < t_s_.size(); ++row) {
      if (!std::isfinite(t_s_[row])) {
        untimed_.add(place_(row));
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
  void add(std::size_t row) {
    if (rows_.empty()) {
      rows_.push_back(row);
      return;
    }
    const double last_s = t_s_[rows_.back()];
    const double step_s = t_s_[row] - last_s;
    if (step_s > 0.0 && step_s <= pause_s_) {
      rows_.push_back(row);
    } else if (step_s == 0.0) {
      add_same_stamp(row);
    } else if (step_s < 0.0 && is_late(row, last_s)) {
      late_.add(place_(row));
      rows_.insert(std::ranges::upper_bound(rows_, t_s_[row], {}, [this](std::size_t r) { return t_s_[r]; }),
                   row);
    } else {
      begin_run(row, step_s);
    }
  }

  void add_same_stamp(std::size_t row) {
    const std::size_t before = rows_.back();
    (same_(before, row) ? twice_ : replaced_).add(place_(row));
    rows_.back() = row;
  }

  // The rows behind it go on where those before it ended.
  bool is_late(std::size_t row, double last_s) const {
    if (t_s_[row] < t_s_[rows_.front()]) return false;
    for (std::size_t next = row + 1; next < t_s_.size() && next <= row + most_out_of_order; ++next) {
      if (t_s_[next] > last_s)
        return t_s_[next] - last_s <= pause_s_ && next - row <= most_out_of_order && is_few(row, last_s);
    }
    return false;
  }

  // A clock that was set back goes through as many rows again as it was set back by.
  bool is_few(std::size_t row, double last_s) const {
    const auto first_above =
        std::ranges::upper_bound(rows_, t_s_[row], {}, [this](std::size_t r) { return t_s_[r]; });
    const auto repeated = static_cast<std::size_t>(rows_.end() - first_above);
    std::size_t behind = 0;
    for (std::size_t next = row; next < t_s_.size() && t_s_[next] <= last_s; ++next) ++behind;
    return repeated <= most_out_of_order && (behind == 1 || behind < repeated);
  }

  void begin_run(std::size_t row, double step_s) {
    finish_run();
    rows_.push_back(row);
    const std::string by = step_s < 0.0 ? "the clock goes back by " + text(-step_s)
                                        : "no rows for " + text(step_s) + " by the clock";
    result_.remarks.push_back(place_(row) + ": " + by + "; a new run begins");
  }

  static std::string text(double duration_s) {
    return duration_s < 1000.0 ? fixed_number(duration_s, 3) + " s"
                               : plain_number(std::round(duration_s)) + " s";
  }

  void finish_run() {
    if (rows_.size() == 1) short_.add(place_(rows_.front()));
    if (rows_.size() > 1) result_.runs.push_back(std::move(rows_));
    rows_.clear();
  }

  std::span<const double> t_s_;
  const std::function<std::string(std::size_t)>& place_;
  const std::function<bool(std::size_t, std::size_t)>& same_;
  double pause_s_ = 0.0;
  RunRows rows_;
  TimeRepair result_;
  Kind untimed_, twice_, replaced_, late_, short_;
};

}  // namespace

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

TimeRepair repair_time(std::span<const double> t_s, const std::function<std::string(std::size_t)>& place,
                       const std::function<bool(std::size_t, std::size_t)>& same) {
  return Repair(t_s, place, same).run();
}

}  // namespace wheelwright::import
