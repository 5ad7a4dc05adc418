#include "model/prediction/segments.hpp"

#include <vector>

#include "model/log/run_periods.hpp"

namespace wheelwright {
namespace {

constexpr double forgetting_periods = 60.0;

}  // namespace

std::vector<LogHole> find_holes(const DriveLog& log) {
  std::vector<LogHole> holes;
  if (!log.metres_per_tick) return holes;
  for (std::size_t row = 1; row < log.samples.size(); ++row) {
    const double step_s = log.samples[row].t_s - log.samples[row - 1].t_s;
    if (step_s > longest_step_periods * log.period_s) holes.push_back({row, step_s});
  }
  return holes;
}

void add_segments(Prediction predicted, const DriveLog& log, double model_period_s, ScoreSums& sums) {
  add_segments({&predicted, 1}, log, model_period_s, sums);
}

void add_segments(std::span<const Prediction> runs, const DriveLog& log, double model_period_s,
                  ScoreSums& sums) {
  const auto holes = find_holes(log);
  if (holes.empty()) return sums.add(runs, log);
  DriveLog segment = log;
  segment.extra_columns.clear();
  const auto add = [&](std::size_t from, std::size_t to) {
    segment.samples.assign(log.samples.begin() + static_cast<std::ptrdiff_t>(from),
                           log.samples.begin() + static_cast<std::ptrdiff_t>(to));
    std::vector<Prediction> parts;
    for (const Prediction& run : runs) parts.push_back(run.subspan(from, to - from));
    sums.add(parts, segment);
  };
  std::size_t from = 0;
  for (const auto& hole : holes) {
    if (from < hole.row) add(from, hole.row);
    from = hole.row;
    const double known_s = log.samples[hole.row].t_s + forgetting_periods * model_period_s;
    while (from < log.samples.size() && log.samples[from].t_s < known_s) ++from;
  }
  if (from < log.samples.size()) add(from, log.samples.size());
}

}  // namespace wheelwright
