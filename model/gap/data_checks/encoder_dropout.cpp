#include "model/gap/data_checks/encoder_dropout.hpp"

#include <algorithm>
#include <cmath>

#include "model/gap/data_checks/commanded_stillness.hpp"
#include "model/gap/data_checks/held_wheels.hpp"
#include "model/gap/data_checks/missed_encoder_edges.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double shortest_freeze_s = 0.05;
constexpr double expected_counts_in_freeze = 10.0;
constexpr double surely_turning_m_s = 0.05;  // a slower wheel may stick

// Whether no wheel can have turned so far since the row before; both rows hold counts.
bool jumps(const DriveLog& log, std::size_t row, bool left) {
  const DriveSample& before = log.samples[row - 1];
  const DriveSample& now = log.samples[row];
  const double step_m =
      left ? static_cast<double>(now.ticks->left - before.ticks->left) * log.metres_per_tick->left
           : static_cast<double>(now.ticks->right - before.ticks->right) * log.metres_per_tick->right;
  return std::abs(step_m) > impossible_speed_m_s * (now.t_s - before.t_s) + 0.01;
}

// A wheel that was told to stand may have stood.
bool commanded_to_stand(const DriveLog& log, std::size_t first, std::size_t end, bool left,
                        double speed_m_s) {
  for (std::size_t k = first > 20 ? first - 20 : 0; k <= end; ++k) {
    const WheelPair& both = log.samples[k].command_m_s;
    const double command = left ? both.left : both.right;
    if (command * speed_m_s <= 0.0 || std::abs(command) < 0.25 * std::abs(speed_m_s)) return true;
  }
  return false;
}

std::vector<Freeze> freezes_of(const GateState& gate, bool left) {
  const auto& samples = gate.result.log.samples;
  const auto stands = [&](std::size_t k) {
    return samples[k].ticks && samples[k - 1].ticks && gate.travel(k, left) == gate.travel(k - 1, left);
  };
  std::vector<Freeze> freezes;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    if (!stands(i)) continue;
    std::size_t end = i;
    while (end + 1 < samples.size() && stands(end + 1)) ++end;
    const Freeze freeze{i - 1, end, left};
    i = end;
    if (samples[freeze.end].t_s - samples[freeze.first].t_s < shortest_freeze_s || freeze.first < 3 ||
        freeze.end + 4 >= samples.size())
      continue;
    if (samples[freeze.first - 3].ticks && samples[freeze.end + 4].ticks) freezes.push_back(freeze);
  }
  return freezes;
}

// How fast a wheel surely turned at either side of a freeze; nothing where it may have stood. A wheel that
// stops by itself slows down first, and speeds up afterwards; counts that are lost do not.
struct SpeedsAround {
  double before_m_s = 0.0;
  double after_m_s = 0.0;
};

SpeedsAround speeds_around(const GateState& gate, const Freeze& freeze) {
  const auto& samples = gate.result.log.samples;
  const bool left = freeze.left;
  const auto speed = [&](std::size_t from, std::size_t to) {
    return (gate.travel(to, left) - gate.travel(from, left)) / (samples[to].t_s - samples[from].t_s);
  };
  const auto sure = [](double speed_m_s, double beside_the_freeze_m_s) {
    const bool as_fast = std::abs(beside_the_freeze_m_s) >= 0.6 * surely_turning_m_s &&
                         beside_the_freeze_m_s * speed_m_s > 0.0;
    if (!as_fast || std::abs(speed_m_s) < surely_turning_m_s) return 0.0;
    return std::copysign(std::min(std::abs(speed_m_s), std::abs(beside_the_freeze_m_s) / 0.6), speed_m_s);
  };
  const std::size_t first = freeze.first;
  const std::size_t end = freeze.end;
  // What comes with the first reading behind the freeze may be all that was held back.
  return {sure(speed(first - 3, first), speed(first - 1, first)),
          sure(speed(end + 1, end + 4), speed(end + 1, end + 2))};
}

double tick_m(const GateState& gate, bool left) {
  return left ? gate.result.log.metres_per_tick->left : gate.result.log.metres_per_tick->right;
}

double duration_s(const GateState& gate, const Freeze& freeze) {
  return gate.result.log.samples[freeze.end].t_s - gate.result.log.samples[freeze.first].t_s;
}

bool overlap(const Freeze& a, const Freeze& b) {
  return a.left == b.left && a.first < b.end && b.first < a.end;
}

void note_held(GateState& gate, const Freeze& freeze) {
  gate.held.push_back(freeze);
  gate.event(freeze.first + 1, std::string("the ") + (freeze.left ? "left" : "right") +
                                   " wheel was held for " + in_digits(duration_s(gate, freeze), 3) +
                                   " s: its counts and the references agree on that");
}

void leave_out_frozen(GateState& gate, const Freeze& freeze) {
  const double duration = duration_s(gate, freeze);
  for (std::size_t k = freeze.first + 1; k <= freeze.end; ++k) gate.result.flags.counts[k] = 1;
  gate.result.dropouts.push_back({gate.result.log.samples[freeze.first].t_s, duration});
  gate.treated_fault(freeze.first + 1,
                     std::string(freeze.left ? "ticks_left" : "ticks_right") + " stand still for " +
                         in_digits(duration, 3) + " s while the wheel turns",
                     "the rows were left out");
}

// Counts of either wheel that stand still between two moments at which the wheel surely turned.
std::vector<Freeze> frozen_counts(const GateState& gate) {
  std::vector<Freeze> frozen;
  for (const bool left : {true, false}) {
    for (const Freeze& freeze : freezes_of(gate, left)) {
      const auto [before, after] = speeds_around(gate, freeze);
      const double min_m = std::min(std::abs(before), std::abs(after)) * duration_s(gate, freeze);
      if (before * after <= 0.0 || min_m < expected_counts_in_freeze * tick_m(gate, left)) continue;
      if (commanded_to_stand(gate.result.log, freeze.first, freeze.end, left, before)) continue;
      frozen.push_back(freeze);
    }
  }
  return frozen;
}

// Where counts were lost more than once, they are lost at turns and stops, too: from such a speed no wheel
// comes to rest between two rows, nor to it from rest.
void find_frozen_at_turns(GateState& gate, bool left) {
  constexpr double too_fast_to_stop_m_s = 0.1;
  constexpr double surely_on_its_way_s = 0.1;
  for (const Freeze& freeze : freezes_of(gate, left)) {
    if (gate.result.flags.counts[freeze.end] != 0) continue;
    const auto [before, after] = speeds_around(gate, freeze);
    const double fastest = std::max(std::abs(before), std::abs(after));
    const double duration = duration_s(gate, freeze);
    if (fastest < too_fast_to_stop_m_s ||
        fastest * duration < expected_counts_in_freeze * tick_m(gate, left)) {
      continue;
    }
    const double min_lost_m = fastest * std::min(duration, surely_on_its_way_s);
    if (!moved_as_counted(gate, freeze.first, freeze.end, 0.5 * min_lost_m)) leave_out_frozen(gate, freeze);
  }
}

// Where a reference saw that the wheel stood, that is said.
void find_frozen_counts(GateState& gate) {
  const std::vector<Freeze> frozen = frozen_counts(gate);
  if (stand_by_command(gate.result.log, frozen)) return;
  std::vector<SuspectedLoss> suspects;
  for (const Freeze& freeze : frozen) {
    const auto [before, after] = speeds_around(gate, freeze);
    const double slower_m_s = std::min(std::abs(before), std::abs(after));
    suspects.push_back({freeze, std::copysign(slower_m_s, before) * duration_s(gate, freeze)});
  }
  gate.result.counters.frozen = seen_rolling(gate, suspects);
  const bool all_stood = were_held(gate.result.counters.frozen, gate.elsewhere.frozen);
  std::size_t& lost = gate.result.counters.surely_frozen;
  for (const auto& [freeze, lost_m] : suspects) {
    if (all_stood || moved_as_counted(gate, freeze.first, freeze.end, 0.5 * std::abs(lost_m))) {
      note_held(gate, freeze);
      continue;
    }
    leave_out_frozen(gate, freeze);
    ++lost;
  }
  if (all_stood || lost + gate.elsewhere.surely_frozen < more_than_chance) return;
  for (const bool left : {true, false}) find_frozen_at_turns(gate, left);
}

void leave_out_thinned(GateState& gate, const ThinnedCounts& segment, bool left, double duration_s) {
  for (std::size_t k = segment.first_row; k <= segment.last_row; ++k) gate.result.flags.counts[k] = 1;
  gate.result.dropouts.push_back({gate.result.log.samples[segment.first_row - 1].t_s, duration_s});
  gate.treated_fault(segment.first_row,
                     std::string(left ? "ticks_left" : "ticks_right") + " miss " +
                         in_digits(std::round(100.0 * segment.lost), 3) + " % of their edges for " +
                         in_digits(duration_s, 3) + " s",
                     "the rows were left out");
}

// A part of the edges, for a while.
void find_missed_edges(GateState& gate) {
  std::vector<Freeze> segments;
  std::vector<ThinnedCounts> thinned;
  for (const bool left : {true, false}) {
    for (const auto& segment : find_missed_encoder_edges(gate.result.log, gate.result.flags.counts, left)) {
      const Freeze rows{segment.first_row - 1, segment.last_row, left};
      if (std::ranges::any_of(gate.held, [&](const Freeze& held) { return overlap(held, rows); })) continue;
      segments.push_back(rows);
      thinned.push_back(segment);
    }
  }
  if (stand_by_command(gate.result.log, segments)) return;
  std::vector<SuspectedLoss> suspects;
  for (std::size_t i = 0; i < thinned.size(); ++i) suspects.push_back({segments[i], thinned[i].lost_m});
  gate.result.counters.thinned = seen_rolling(gate, suspects);
  const bool all_stood = were_held(gate.result.counters.thinned, gate.elsewhere.thinned);
  std::vector<std::size_t> lost;
  for (std::size_t i = 0; i < thinned.size(); ++i) {
    const auto [first, end, left] = segments[i];
    if (all_stood || moved_as_counted(gate, first, end, 0.5 * std::abs(suspects[i].lost_m))) {
      note_held(gate, segments[i]);
    } else {
      lost.push_back(i);
    }
  }
  if (lost.size() < more_than_chance) return;
  for (const std::size_t i : lost) {
    leave_out_thinned(gate, thinned[i], segments[i].left, duration_s(gate, segments[i]));
  }
}

}  // namespace

void find_jumps(GateState& gate) {
  const auto& samples = gate.result.log.samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!samples[i].ticks || !samples[i - 1].ticks) continue;
    const double duration = samples[i].t_s - samples[i - 1].t_s;
    for (const bool left : {true, false}) {
      if (!jumps(gate.result.log, i, left)) continue;
      gate.result.flags.restart[i] = 1;
      const auto ticks = left ? samples[i].ticks->left - samples[i - 1].ticks->left
                              : samples[i].ticks->right - samples[i - 1].ticks->right;
      gate.treated_fault(i,
                         std::string(left ? "ticks_left" : "ticks_right") + " jumps by " +
                             std::to_string(ticks) + " in " + in_digits(duration, 3) + " s" +
                             (std::abs(std::abs(static_cast<double>(ticks)) - 65536.0) < 2000.0
                                  ? " (a 16-bit counter that was not unwrapped?)"
                                  : ""),
                         "the counts were taken up again behind it");
      gate.result.faults.back().distorts = true;
    }
  }
}

DriveLog with_lost_counts(DriveLog log) {
  for (std::size_t i = 1; i < log.samples.size(); ++i) {
    DriveSample& sample = log.samples[i];
    if (!sample.ticks || !log.samples[i - 1].ticks) continue;
    sample.counter_reset = jumps(log, i, true) || jumps(log, i, false);
  }
  return log;
}

void find_dropouts(GateState& gate) {
  const auto& samples = gate.result.log.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {  // no counts at all
    if (samples[i].ticks) continue;
    std::size_t end = i;
    while (end < samples.size() && !samples[end].ticks) ++end;
    const double duration = samples[std::min(end, samples.size() - 1)].t_s - samples[i].t_s;
    gate.result.dropouts.push_back({samples[i].t_s, duration});
    gate.treated_fault(i, "no counts for " + in_digits(duration, 3) + " s", "the rows were left out");
    i = end;
  }
  find_frozen_counts(gate);
  find_missed_edges(gate);
}

}  // namespace wheelwright::gap
