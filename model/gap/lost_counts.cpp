#include "model/gap/lost_counts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/gap/thinned_counts.hpp"

namespace wheelwright::gap {
namespace {

constexpr double shortest_freeze_s = 0.05;
constexpr double expected_counts_in_freeze = 10.0;
constexpr double surely_turning_m_s = 0.05;  // a slower wheel may stick

// Counts of one wheel that stand still between two moments at which the wheel surely turned.
void find_frozen_counts(GateState& gate, bool left) {
  const auto& samples = gate.result.log.samples;
  const double tick = left ? gate.result.log.metres_per_tick->left : gate.result.log.metres_per_tick->right;
  const auto speed = [&](std::size_t from, std::size_t to) {
    return (gate.travel(to, left) - gate.travel(from, left)) / (samples[to].t_s - samples[from].t_s);
  };
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    if (!samples[i].ticks || !samples[i - 1].ticks || gate.travel(i, left) != gate.travel(i - 1, left))
      continue;
    std::size_t end = i;
    while (end + 1 < samples.size() && samples[end + 1].ticks &&
           gate.travel(end + 1, left) == gate.travel(i, left))
      ++end;
    const std::size_t first = i - 1;
    i = end;
    const double duration = samples[end].t_s - samples[first].t_s;
    if (duration < shortest_freeze_s || first < 3 || end + 4 >= samples.size()) continue;
    if (!samples[first - 3].ticks || !samples[end + 4].ticks) continue;
    const double before = speed(first - 3, first);
    // What comes with the first reading behind the freeze may be all that was held back.
    const double after = speed(end + 1, end + 4);
    // A wheel that stops by itself slows down first, and speeds up afterwards; counts that are lost do not.
    const double last = speed(first - 1, first);
    const double next = speed(end + 1, end + 2);
    const double least =
        std::min({std::abs(before), std::abs(after), std::abs(last) / 0.6, std::abs(next) / 0.6});
    if (last * before <= 0.0 || next * before <= 0.0) continue;
    if (before * after <= 0.0 || least < surely_turning_m_s ||
        least * duration < expected_counts_in_freeze * tick)
      continue;
    // A wheel that was told to stand may have stood.
    bool told_to_stand = false;
    for (std::size_t k = first > 20 ? first - 20 : 0; k <= end; ++k) {
      const double command = left ? samples[k].command_m_s.left : samples[k].command_m_s.right;
      if (command * before <= 0.0 || std::abs(command) < 0.25 * std::abs(before)) told_to_stand = true;
    }
    if (told_to_stand) continue;
    for (std::size_t k = first + 1; k <= end; ++k) gate.result.flags.counts[k] = 1;
    gate.result.dropouts.push_back({samples[first].t_s, duration});
    gate.fault(first + 1, std::string(left ? "ticks_left" : "ticks_right") + " stand still for " +
                              in_digits(duration, 3) + " s while the wheel turns; the rows were left out");
  }
}

// Once in a run may be a wheel that something held.
void find_missed_edges(GateState& gate) {
  constexpr std::size_t more_than_chance = 2;
  std::vector<std::pair<ThinnedCounts, bool>> thinned;
  for (const bool left : {true, false}) {
    for (const auto& stretch : find_thinned_counts(gate.result.log, gate.result.flags.counts, left)) {
      thinned.emplace_back(stretch, left);
    }
  }
  if (thinned.size() < more_than_chance) return;
  const auto& samples = gate.result.log.samples;
  for (const auto& [stretch, left] : thinned) {
    const double start_s = samples[stretch.first_row - 1].t_s;
    const double duration = samples[stretch.last_row].t_s - start_s;
    for (std::size_t k = stretch.first_row; k <= stretch.last_row; ++k) gate.result.flags.counts[k] = 1;
    gate.result.dropouts.push_back({start_s, duration});
    gate.fault(stretch.first_row, std::string(left ? "ticks_left" : "ticks_right") + " miss " +
                                      in_digits(std::round(100.0 * stretch.lost), 3) +
                                      " % of their edges for " + in_digits(duration, 3) +
                                      " s; the rows were left out");
  }
}

}  // namespace

void find_jumps(GateState& gate) {
  const auto& samples = gate.result.log.samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!samples[i].ticks || !samples[i - 1].ticks) continue;
    const double duration = samples[i].t_s - samples[i - 1].t_s;
    for (const bool left : {true, false}) {
      const double jump = gate.travel(i, left) - gate.travel(i - 1, left);
      if (std::abs(jump) <= impossible_speed_m_s * duration + 0.01) continue;
      gate.result.flags.restart[i] = 1;
      const auto ticks = left ? samples[i].ticks->left - samples[i - 1].ticks->left
                              : samples[i].ticks->right - samples[i - 1].ticks->right;
      gate.fault(i, std::string(left ? "ticks_left" : "ticks_right") + " jumps by " + std::to_string(ticks) +
                        " in " + in_digits(duration, 3) + " s" +
                        (std::abs(std::abs(static_cast<double>(ticks)) - 65536.0) < 2000.0
                             ? " (a 16-bit counter that was not unwrapped?)"
                             : "") +
                        "; the counts were taken up again behind it");
    }
  }
}

void find_dropouts(GateState& gate) {
  const auto& samples = gate.result.log.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {  // no counts at all
    if (samples[i].ticks) continue;
    std::size_t end = i;
    while (end < samples.size() && !samples[end].ticks) ++end;
    const double duration = samples[std::min(end, samples.size() - 1)].t_s - samples[i].t_s;
    gate.result.dropouts.push_back({samples[i].t_s, duration});
    gate.fault(i, "no counts for " + in_digits(duration, 3) + " s; the rows were left out");
    i = end;
  }
  find_frozen_counts(gate, true);
  find_frozen_counts(gate, false);
  find_missed_edges(gate);
}

}  // namespace wheelwright::gap
