#include "tools/wheelwright/import/conversion/join_streams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/statistics/order_statistics.hpp"
#include "tools/wheelwright/import/conversion/clock_sessions.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {
namespace {

constexpr double hole_s = 0.3;
constexpr double hole_in_steps = 3.0;

struct Sample {
  double t_s;
  double value;
};

std::vector<Sample> samples_of(std::span<const double> t_s, std::span<const double> values,
                               const SessionRows& rows) {
  std::vector<Sample> samples;
  for (const std::size_t row : rows)
    if (std::isfinite(values[row])) samples.push_back({t_s[row], values[row]});
  return samples;
}

// All rows in the order of time.
SessionRows as_one(const std::vector<SessionRows>& sessions, std::span<const double> t_s) {
  SessionRows all;
  for (const SessionRows& rows : sessions) all.insert(all.end(), rows.begin(), rows.end());
  std::ranges::stable_sort(all, {}, [&](std::size_t row) { return t_s[row]; });
  return all;
}

double longest_step(const std::vector<Sample>& samples) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < samples.size(); ++i) steps.push_back(samples[i].t_s - samples[i - 1].t_s);
  if (steps.empty()) return 0.0;
  return std::max(hole_s, hole_in_steps * median(steps));
}

// The row nearest to a time.
std::size_t nearest(std::span<const double> to_s, double t_s) {
  const auto above = std::ranges::lower_bound(to_s, t_s);
  if (above == to_s.begin()) return 0;
  if (above == to_s.end()) return to_s.size() - 1;
  const auto at = static_cast<std::size_t>(above - to_s.begin());
  return t_s - to_s[at - 1] < to_s[at] - t_s ? at - 1 : at;
}

std::vector<double> hold(const std::vector<Sample>& samples, std::span<const double> to_s) {
  std::vector<double> result(to_s.size(), nothing);
  for (const Sample& sample : samples) {
    if (sample.t_s <= to_s.back()) result[nearest(to_s, sample.t_s)] = sample.value;
  }
  double last = nothing;
  for (double& value : result) {
    if (std::isfinite(value)) last = value;
    value = last;
  }
  return result;
}

std::vector<double> interpolate(const std::vector<Sample>& samples, std::span<const double> to_s) {
  std::vector<double> result(to_s.size(), nothing);
  const double longest_s = longest_step(samples);
  std::size_t at = 0;
  for (std::size_t row = 0; row < to_s.size(); ++row) {
    while (at + 1 < samples.size() && samples[at + 1].t_s <= to_s[row]) ++at;
    if (at < samples.size() && samples[at].t_s == to_s[row]) result[row] = samples[at].value;
    if (at + 1 >= samples.size() || samples[at].t_s > to_s[row]) continue;
    const double step_s = samples[at + 1].t_s - samples[at].t_s;
    if (step_s > longest_s || step_s > 1.0) continue;
    const double part = step_s > 0.0 ? (to_s[row] - samples[at].t_s) / step_s : 0.0;
    result[row] = samples[at].value + part * (samples[at + 1].value - samples[at].value);
  }
  // Single ones, as poses at the ends of a run.
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool alone = (i == 0 || samples[i].t_s - samples[i - 1].t_s > longest_s ||
                        samples[i].t_s - samples[i - 1].t_s > 1.0) &&
                       (i + 1 == samples.size() || samples[i + 1].t_s - samples[i].t_s > longest_s ||
                        samples[i + 1].t_s - samples[i].t_s > 1.0);
    if (alone && samples[i].t_s >= to_s.front() && samples[i].t_s <= to_s.back())
      result[nearest(to_s, samples[i].t_s)] = samples[i].value;
  }
  return result;
}

}  // namespace

std::vector<double> join(std::span<const double> from_s, std::span<const double> values,
                         std::span<const double> to_s, Joining joining) {
  std::vector<double> result(to_s.size(), nothing);
  const auto from = clock_sessions(from_s);
  const auto to = clock_sessions(to_s);
  const bool are_pairs = from.size() == to.size();
  const SessionRows all = are_pairs ? SessionRows() : as_one(from, from_s);
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto samples = samples_of(from_s, values, are_pairs ? from[i] : all);
    if (samples.empty()) continue;
    std::vector<double> times;
    for (const std::size_t row : to[i]) times.push_back(to_s[row]);
    const auto joined = joining == Joining::held ? hold(samples, times) : interpolate(samples, times);
    for (std::size_t k = 0; k < joined.size(); ++k) result[to[i][k]] = joined[k];
  }
  return result;
}

UnitedRows unite_rows(std::span<const std::vector<double>> times) {
  constexpr double resolution_s = 2e-6;  // of the times in a drive log, with something to spare
  struct Row {
    double t_s;
    std::size_t stream;
    std::size_t row;
  };
  std::vector<std::vector<SessionRows>> sessions;
  UnitedRows united;
  for (const auto& t_s : times) {
    united.rows.emplace_back(t_s.size(), 0);
    sessions.push_back(clock_sessions(t_s));
  }
  const bool go_together =
      std::ranges::all_of(sessions, [&](const auto& each) { return each.size() == sessions.front().size(); });
  if (!go_together) {
    for (std::size_t s = 0; s < times.size(); ++s) sessions[s] = {as_one(sessions[s], times[s])};
  }
  for (std::size_t i = 0; !sessions.empty() && i < sessions.front().size(); ++i) {
    std::vector<Row> all;
    for (std::size_t s = 0; s < times.size(); ++s)
      for (const std::size_t row : sessions[s][i]) all.push_back({times[s][row], s, row});
    std::ranges::stable_sort(all, {}, &Row::t_s);
    const std::size_t first = united.t_s.size();
    for (const Row& row : all) {
      if (united.t_s.size() == first || row.t_s > united.t_s.back() + resolution_s)
        united.t_s.push_back(row.t_s);
      united.rows[row.stream][row.row] = united.t_s.size() - 1;
    }
  }
  return united;
}

}  // namespace wheelwright::import
