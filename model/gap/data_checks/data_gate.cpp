#include "model/gap/data_checks/data_gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

#include "model/gap/data_checks/carried_robot.hpp"
#include "model/gap/data_checks/contradictions.hpp"
#include "model/gap/data_checks/encoder_dropout.hpp"
#include "model/gap/data_checks/frozen_reference.hpp"
#include "model/gap/data_checks/gate_state.hpp"
#include "model/gap/data_checks/held_reference.hpp"
#include "model/gap/data_checks/reference_steps.hpp"
#include "model/gap/data_checks/wrong_poses.hpp"
#include "model/gap/data_checks/wrong_reference.hpp"
#include "model/identification/run_scales.hpp"
#include "model/log/anisotropic_scale.hpp"
#include "model/log/heading_offset.hpp"
#include "model/log/reference_response.hpp"
#include "model/prediction/segments.hpp"
#include "model/statistics/order_statistics.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double impossible_command_m_s = 3.0;  // no wheel that is counted in these logs goes that fast
constexpr double garbage_over_usual = 4.0;      // a few commands so far above all others are garbage
constexpr std::size_t few_rows = 3;
constexpr double forgetting_s = 1.0;  // until a command from before is of no consequence

double size_of(const WheelPair& command) {
  return std::max(std::abs(command.left), std::abs(command.right));
}

void remove_garbage_commands(GateState& gate) {
  auto& samples = gate.result.log.samples;
  std::vector<double> sizes;
  sizes.reserve(samples.size());
  for (const auto& sample : samples) sizes.push_back(size_of(sample.command_m_s));
  std::ranges::sort(sizes);
  const double usual = sizes[sizes.size() * 98 / 100];
  const double limit =
      usual > 0.0 ? std::min(impossible_command_m_s, garbage_over_usual * usual) : impossible_command_m_s;
  const auto above =
      static_cast<std::size_t>(std::ranges::count_if(sizes, [&](double size) { return size > limit; }));
  if (above == 0) return;
  if (above > few_rows) {
    if (usual > impossible_command_m_s) {
      gate.fault(
          0,
          "commands are up to " + in_digits(sizes.back(), 3) + " m/s; are they in mm/s? the format wants m/s",
          true);
    }
    return;
  }
  std::vector<DriveSample> kept;
  std::vector<std::size_t> lines;  // not yet gate.lines: faults are still told by the rows as they were
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (size_of(samples[i].command_m_s) > limit) {
      gate.treated_fault(i,
                         "a command of " + in_digits(size_of(samples[i].command_m_s), 4) +
                             " m/s where no other is above " + in_digits(usual, 3) + " m/s",
                         "the row was left out");
      gate.result.faults.back().distorts = true;
    } else {
      kept.push_back(samples[i]);
      lines.push_back(gate.result.log.first_line + i);
    }
  }
  for (auto& column : gate.result.log.extra_columns) column = {column.name, {}, {}};
  samples = std::move(kept);
  gate.lines = std::move(lines);
}

// Whether a counter that was switched off and on meanwhile tells of a way that no command asks for.
bool counter_was_reset(const GateState& gate, const LogHole& hole) {
  constexpr double beyond_what_was_asked = 1.5;
  const DriveLog& log = gate.result.log;
  if (!log.samples[hole.row].ticks || !log.samples[hole.row - 1].ticks) return false;
  double fastest_m_s = 0.0;
  for (const auto& sample : log.samples) fastest_m_s = std::max(fastest_m_s, size_of(sample.command_m_s));
  const double farthest_m = beyond_what_was_asked * fastest_m_s * hole.duration_s + 0.05;
  return std::ranges::any_of(std::array{true, false}, [&](bool left) {
    return std::abs(gate.travel(hole.row, left) - gate.travel(hole.row - 1, left)) > farthest_m;
  });
}

void leave_out_second_behind(GateState& gate, std::size_t row) {
  const auto& samples = gate.result.log.samples;
  const double known_s = samples[row].t_s + forgetting_s;
  for (std::size_t i = row; i < samples.size() && samples[i].t_s < known_s; ++i) {
    gate.result.flags.counts[i] = 1;
    gate.result.flags.restart[i] = 1;
  }
}

// The robot went on, with commands that no row tells: what it does until they are forgotten is no model's
// fault.
void leave_out_holes(GateState& gate) {
  for (const auto& hole : find_holes(gate.result.log)) {
    const bool was_reset = counter_was_reset(gate, hole);
    gate.treated_fault(hole.row,
                       "no rows for " + in_digits(hole.duration_s, 4) + " s" +
                           (was_reset ? ", and the counters were reset in it" : ""),
                       "the first second behind them was left out");
    gate.result.faults.back().distorts = was_reset;
    leave_out_second_behind(gate, hole.row);
  }
}

// Rows that are missing one by one, where the command is another one behind them: when it changed is not
// known, and the way that depends on it is in no model.
void leave_out_lost_changes(GateState& gate) {
  constexpr double visible_m = 0.002;
  constexpr double longest_share = 0.2;  // of a run: with more of it left out, little is left
  const DriveLog& log = gate.result.log;
  const auto holes = find_holes(log);
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < log.samples.size(); ++i)
    steps_s.push_back(log.samples[i].t_s - log.samples[i - 1].t_s);
  if (steps_s.empty()) return;
  const double usual_s = median(std::vector<double>(steps_s));
  std::vector<std::size_t> rows;
  for (std::size_t i = 1; i < log.samples.size(); ++i) {
    const double missing_s = steps_s[i - 1] - usual_s;
    if (missing_s < 0.5 * usual_s || std::ranges::find(holes, i, &LogHole::row) != holes.end()) continue;
    const WheelPair& before = log.samples[i - 1].command_m_s;
    const WheelPair& behind = log.samples[i].command_m_s;
    if (missing_s * size_of({behind.left - before.left, behind.right - before.right}) > visible_m)
      rows.push_back(i);
  }
  const double duration_s = log.samples.back().t_s - log.samples.front().t_s;
  if (rows.empty() || forgetting_s * static_cast<double>(rows.size()) > longest_share * duration_s) return;
  for (const std::size_t row : rows) leave_out_second_behind(gate, row);
  gate.treated_fault(
      rows.front(),
      "a command changed while rows are missing" +
          (rows.size() > 1 ? ", here and " + std::to_string(rows.size() - 1) + " times more" : std::string()),
      "the first second behind was left out");
}

// So that no figure is taken across lost counts.
void mark_counter_reset(GatedLog& gated) {
  auto& samples = gated.log.samples;
  bool lost = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].counter_reset = lost || gated.flags.counts[i] != 0 || gated.flags.restart[i] != 0;
    lost = gated.flags.counts[i] != 0 || !samples[i].ticks;
  }
}

// Without the rows that cannot be true.
GateState cleaned(const DriveLog& log, const CounterEvidence& elsewhere) {
  GateState state{{log, {}, {}, {}, {}}, {}, elsewhere, {}};
  remove_garbage_commands(state);
  const std::size_t rows = state.result.log.samples.size();
  state.result.flags = {std::vector<char>(rows, 0), std::vector<char>(rows, 0)};
  if (state.result.log.has_ticks()) {
    leave_out_holes(state);
    find_jumps(state);
    find_dropouts(state);
    check_sides_and_signs(state);
  }
  leave_out_lost_changes(state);
  remove_frozen_reference(state);
  leave_out_repeated_poses(state);
  leave_out_wrong_poses(state);
  restart_where_carried(state);
  remove_reference_jumps(state);
  return state;
}

void turn_headings_back(std::vector<GateState>& states) {
  std::vector<const DriveLog*> logs;
  logs.reserve(states.size());
  for (const GateState& state : states) logs.push_back(&state.result.log);
  const std::vector<HeadingOffset> offsets = heading_offsets(logs);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!is_turned(offsets[i])) continue;
    turn_headings(states[i].result.log, offsets[i]);
    // Of runs with the same offset the first says it for all.
    const auto same = [&](const HeadingOffset& each) { return each.offset_rad == offsets[i].offset_rad; };
    if (std::ranges::find_if(offsets, same) - offsets.begin() < static_cast<std::ptrdiff_t>(i)) continue;
    const auto runs = std::ranges::count_if(offsets, same);
    states[i].treated_fault(
        0, in_words(offsets[i]),
        "it was turned back" + (runs > 1 ? " in " + std::to_string(runs) + " runs" : std::string()));
  }
}

std::vector<const DriveLog*> logs_of(const std::vector<GatedLog>& gated) {
  std::vector<const DriveLog*> logs;
  logs.reserve(gated.size());
  for (const GatedLog& each : gated) logs.push_back(&each.log);
  return logs;
}

// What is true of the tracker of all runs, the first one says.
void say_for_all(std::vector<GatedLog>& gated, const std::string& what, const std::string& treatment) {
  const DriveLog& first = gated.front().log;
  const std::string where =
      gated.size() > 1 ? " in " + std::to_string(gated.size()) + " runs" : std::string();
  gated.front().faults.push_back(
      {first.name, first.first_line, what, false, false, false, treatment + where});
}

void undo_anisotropic_scale(std::vector<GatedLog>& gated) {
  const auto scale = find_anisotropic_scale(logs_of(gated));
  if (!scale) return;
  for (GatedLog& each : gated) wheelwright::undo_anisotropic_scale(each.log, *scale);
  say_for_all(gated, in_words(*scale), "it was made that of the counts");
}

void note_smoothing(std::vector<GatedLog>& gated) {
  const auto response = find_reference_response(logs_of(gated));
  if (!response) return;
  for (GatedLog& each : gated) each.log.reference_response = *response;
  say_for_all(gated, in_words(*response), "predictions are compared as such a reference shows them");
}

void find_other_scale(std::span<const DriveLog> logs, std::vector<GatedLog>& gated) {
  const auto outlier = find_scale_outlier(logs);
  if (!outlier) return;
  const DriveLog& run = logs[outlier->run];
  gated[outlier->run].faults.push_back({run.name, run.first_line,
                                        "ticks_left and ticks_right go " + in_digits(outlier->factor, 3) +
                                            " times as far for their commands as those of " +
                                            logs[outlier->other].name + " (line " +
                                            std::to_string(logs[outlier->other].first_line) +
                                            "): other firmware, other wheels, or another scale",
                                        false, true, false, ""});
}

}  // namespace

SeenRolling& SeenRolling::operator+=(const SeenRolling& other) {
  lost_m += other.lost_m;
  rolled_m += other.rolled_m;
  return *this;
}

CounterEvidence& CounterEvidence::operator+=(const CounterEvidence& other) {
  surely_frozen += other.surely_frozen;
  frozen += other.frozen;
  thinned += other.thinned;
  return *this;
}

GatedLog gate(const DriveLog& log) {
  return std::move(gate_together({&log, 1}).front());
}

std::vector<GatedLog> gate_together(std::span<const DriveLog> logs) {
  std::vector<GateState> states;
  std::vector<CounterEvidence> counters;
  for (const DriveLog& log : logs) {
    states.push_back(cleaned(log, {}));
    counters.push_back(states.back().result.counters);
  }
  for (std::size_t i = 0; i < logs.size(); ++i) {
    CounterEvidence elsewhere;
    for (std::size_t other = 0; other < logs.size(); ++other) {
      if (other != i) elsewhere += counters[other];
    }
    if (elsewhere.tells_anything()) states[i] = cleaned(logs[i], elsewhere);
  }
  turn_headings_back(states);
  std::vector<GatedLog> gated;
  for (GateState& state : states) {
    check_reference(state);
    check_gyro(state);
    mark_counter_reset(state.result);
    treat_reference_steps(state);
    gated.push_back(std::move(state.result));
  }
  note_smoothing(gated);
  undo_anisotropic_scale(gated);
  if (logs.size() > 1) find_other_scale(logs, gated);
  return gated;
}

}  // namespace wheelwright::gap
