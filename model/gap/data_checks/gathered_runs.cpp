#include "model/gap/data_checks/gathered_runs.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/fit/free_run_errors.hpp"
#include "model/log/near_periods.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_s = 5.0;  // of all runs together
constexpr std::size_t min_rows = 20;
constexpr std::size_t min_to_hold_out_of = 3;  // training runs, where test runs are to stay untouched

std::optional<GapRefusal> mismatch(std::span<const DriveLog> logs) {
  const DriveLog& first = logs.front();
  double all_s = 0.0;
  for (const auto& log : logs) {
    const std::string where = log.name + ":" + std::to_string(log.first_line) + ": ";
    if (log.samples.size() < min_rows) {
      return GapRefusal{where + "the run holds " + std::to_string(log.samples.size()) +
                        " rows, but at least " + std::to_string(min_rows) + " are needed"};
    }
    all_s += log.samples.back().t_s - log.samples.front().t_s;
    if (std::abs(log.wheel_base_m - first.wheel_base_m) > 1e-6) {
      return GapRefusal{where + "its wheel base is " + std::to_string(log.wheel_base_m) + " m, but that of " +
                        first.name + " is " + std::to_string(first.wheel_base_m) +
                        " m; are they of the same robot?"};
    }
    if (log.has_ticks() != first.has_ticks()) {
      return GapRefusal{
          where + (log.has_ticks() ? "it holds encoder counts, but " : "it holds no encoder counts, but ") +
          first.name + (first.has_ticks() ? " does" : " does not") + "; analyse them apart"};
    }
  }
  if (const auto far = find_far_period(logs)) return GapRefusal{*far};
  if (all_s >= min_s) return std::nullopt;
  return GapRefusal{first.name + ":" + std::to_string(first.first_line) + ": " +
                    (logs.size() == 1 ? "the run lasts " : "the runs last ") + std::to_string(all_s) +
                    " s in all, but at least " + std::to_string(static_cast<int>(min_s)) + " s are needed"};
}

bool same_run(const DriveLog& one, const DriveLog& other) {
  const auto same = [](const DriveSample& a, const DriveSample& b) {
    const auto counts = [](const DriveSample& sample) { return sample.ticks.value_or(WheelTicks{}); };
    return a.t_s == b.t_s && a.command_m_s.left == b.command_m_s.left &&
           a.command_m_s.right == b.command_m_s.right && counts(a).left == counts(b).left &&
           counts(a).right == counts(b).right && a.reference_x_m == b.reference_x_m &&
           a.reference_y_m == b.reference_y_m;
  };
  return std::ranges::equal(one.samples, other.samples, same);
}

// A run that is there twice would be held out from itself.
std::optional<GapRefusal> repetition(std::span<const DriveLog> logs) {
  for (std::size_t i = 0; i < logs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_run(logs[j], logs[i])) continue;
      return GapRefusal{logs[i].name + ":" + std::to_string(logs[i].first_line) + ": the same run as " +
                        logs[j].name + ":" + std::to_string(logs[j].first_line) +
                        "; what is held out has to be another run"};
    }
  }
  return std::nullopt;
}

void add_gated(std::span<const GatedLog> logs, double period_s, RunSet& runs, GatheredRuns& gathered) {
  for (const auto& gated : logs) {
    gathered.faults.insert(gathered.faults.end(), gated.faults.begin(), gated.faults.end());
    gathered.dropouts.insert(gathered.dropouts.end(), gated.dropouts.begin(), gated.dropouts.end());
    gathered.watched_s += gated.log.samples.back().t_s - gated.log.samples.front().t_s;
    GapRun run = make_gap_run(gated.log, gated.flags, period_s);
    measure_motion(run);
    runs.add(std::move(run), gated.log);
  }
}

std::optional<GapRefusal> hold_out(GatheredRuns& gathered) {
  RunSet& train = gathered.train;
  RunSet& test = gathered.test;
  const std::size_t count = train.runs.size();
  if (count > 1) {
    const std::size_t kept = count - std::max<std::size_t>(1, count / 3);
    while (train.runs.size() > kept) train.move_to(test, kept);
    return std::nullopt;
  }
  const GapRun whole = train.runs.front();
  if (whole.duration_s() < 3.0 * min_s) {
    return GapRefusal{whole.name + ": a single run of " + std::to_string(whole.duration_s()) +
                      " s is too short to hold a part of it out; give at least " +
                      std::to_string(static_cast<int>(3.0 * min_s)) + " s or a second run"};
  }
  const std::size_t cut = whole.commands_m_s.size() * 2 / 3;
  train.runs.front() = part_of(whole, 0, cut);
  test.add(part_of(whole, cut, whole.commands_m_s.size() + 1), train.logs.front());
  gathered.tail_held_out = true;
  return std::nullopt;
}

}  // namespace

std::optional<GapRefusal> gather_runs(std::span<const DriveLog> train, std::span<const DriveLog> test,
                                      std::optional<double> given_period_s, GatheredRuns& gathered) {
  std::vector<DriveLog> all(train.begin(), train.end());
  all.insert(all.end(), test.begin(), test.end());
  if (auto refusal = mismatch(all)) return refusal;
  if (auto refusal = repetition(all)) return refusal;
  const std::vector<GatedLog> gated = gate_together(all);
  const double period_s = given_period_s.value_or(shortest_period_s(all));
  add_gated(std::span(gated).first(train.size()), period_s, gathered.train, gathered);
  gathered.to_learn_from = gathered.train.logs;
  add_gated(std::span(gated).subspan(train.size()), period_s, gathered.test, gathered);
  const std::size_t given = gathered.train.runs.size();
  if (!test.empty() && given < min_to_hold_out_of) return std::nullopt;
  if (!test.empty()) {
    std::swap(gathered.test, gathered.untouched);
  } else if (given > min_to_hold_out_of) {
    gathered.train.move_to(gathered.untouched, given - 1);
  }
  return hold_out(gathered);
}

}  // namespace wheelwright::gap
