#include "tools/wheelwright/import/inference/infer_mapping.hpp"
#include "tools/wheelwright/import/inference/units/heading_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/command_forms.hpp"
#include "tools/wheelwright/import/inference/command_rivals.hpp"
#include "tools/wheelwright/import/inference/counter_kind.hpp"
#include "tools/wheelwright/import/inference/gyro_scale.hpp"
#include "tools/wheelwright/import/inference/idle_settings.hpp"
#include "tools/wheelwright/import/inference/leading_speeds.hpp"
#include "tools/wheelwright/import/inference/metadata_roles.hpp"
#include "tools/wheelwright/import/inference/mirrored_side.hpp"
#include "tools/wheelwright/import/inference/named_roles.hpp"
#include "tools/wheelwright/import/inference/neutral_command.hpp"
#include "tools/wheelwright/import/inference/numbered_roles.hpp"
#include "tools/wheelwright/import/inference/one_wheel_doubt.hpp"
#include "tools/wheelwright/import/inference/pixel_scale.hpp"
#include "tools/wheelwright/import/inference/reference_frame.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/step_response.hpp"
#include "tools/wheelwright/import/inference/stick_commands.hpp"
#include "tools/wheelwright/import/inference/turning_unit.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/units/time_unit.hpp"
#include "tools/wheelwright/import/inference/units/units_by_motion.hpp"
#include "tools/wheelwright/import/inference/unknown_units.hpp"
#include "tools/wheelwright/import/inference/unused_columns.hpp"
#include "tools/wheelwright/import/inference/watchdog.hpp"
#include "tools/wheelwright/import/mapping/mapping_file.hpp"

namespace wheelwright::import {
namespace {

// Signs and sides that cannot be as the file says. They are reported, and changed by whoever knows the robot.
void add_doubts(const DriveColumns& columns, const Mapping& mapping, std::vector<std::string>& doubts) {
  if (!mapping.command || !mapping.wheels || !mapping.wheels->right || mapping.command->is_of_body()) return;
  auto rows = response_rows(columns, mapping);
  const std::array<ResponseFit, 2> own{fit_response(rows[0]), fit_response(rows[1])};
  std::swap(rows[0].command, rows[1].command);
  const std::array<ResponseFit, 2> other{fit_response(rows[0]), fit_response(rows[1])};
  const double gained = other[0].nats + other[1].nats - own[0].nats - own[1].nats;
  if (!columns.command[1].empty() && gained > 20.0 && other[0].explained > 0.5 && other[1].explained > 0.5) {
    doubts.push_back(
        "the sides are swapped: each wheel follows the command of the other (log-likelihood gain " +
        config::fixed_number(gained, 0) + "); exchange wheels.left and wheels.right");
    return;
  }
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const bool is_reversed = k == 0 ? mapping.wheels->left_reversed : mapping.wheels->right_reversed;
    if ((own[k].gain < 0.0) == is_reversed || own[k].explained < 0.5) continue;
    const std::string side = k == 0 ? "left" : "right";
    doubts.push_back(
        "the " + side +
        " wheel counts backwards against its command; if the encoder is mounted so: --set wheels.reversed=" +
        side + ", if the motor is: --set command.reversed=" + side);
  }
}

// What was found, with what is given in its place.
std::vector<MappingEntry> overlaid(const Mapping& mapping, const GivenMapping& given) {
  std::vector<MappingEntry> entries = mapping_entries(mapping);
  for (const auto& entry : given.entries()) {
    const auto at = std::ranges::find(entries, entry.key, &MappingEntry::key);
    if (at == entries.end()) {
      entries.push_back(entry);
    } else {
      *at = entry;
    }
  }
  return entries;
}

// Positions without a unit, of wheels of which a person says how far a count goes, are counts.
void count_positions(const GivenMapping& given, Mapping& mapping) {
  const bool are_counted = given.says("wheels.metres_per_count") || given.says("wheels.counts_per_turn");
  if (!mapping.wheels || !are_counted || given.says("wheels.kind") || given.says("wheels.unit") ||
      mapping.wheels->kind != WheelKind::angle || !mapping.wheels->unit_assumed)
    return;
  mapping.wheels->kind = WheelKind::counts;
  mapping.wheels->unit.clear();
  mapping.wheels->unit_assumed = false;
}

// Who states the speed of the largest duty states that commands are one. What number stands for it does not
// depend on that.
void set_duty(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping) {
  if (!mapping.command) return;
  CommandMapping& command = *mapping.command;
  const bool implied = given.says("command.full_scale_m_s") && !given.says("command.kind");
  if (implied && !command.is_of_body()) command.kind = CommandKind::duty;
  // And who states the unit of a speed, that they are none.
  if (given.says("command.unit") && !given.says("command.kind") && command.kind == CommandKind::duty)
    command.kind = CommandKind::wheels;
  set_full_scale(columns, given, command);
}

// A drive log says by its format that y points left and headings are counter-clockwise: if they are not, it
// is wrong.
bool states_its_frame(std::span<const Recording> recordings) {
  return std::ranges::any_of(recordings, [](const Recording& recording) {
    return std::ranges::any_of(recording.metadata,
                               [](const auto& entry) { return entry.first == "wheelwright_drive_log"; });
  });
}

}  // namespace

Inference infer_mapping(std::span<const Recording> recordings, const GivenMapping& given) {
  Inference inference;
  const std::string name = recordings.empty() ? std::string("the log") : recordings.front().name;
  Mapping mapping = to_mapping(given.entries(), name);
  set_kind_of_stated_wheels(recordings, given, mapping);
  map_by_names(recordings, mapping, inference.findings);
  choose_among_commands(recordings, given, mapping, inference.findings);
  map_metadata(recordings, mapping, inference.doubts);
  set_time_unit(recordings, given, mapping, inference.findings);
  find_leading_speeds(recordings, given, mapping, inference.findings);
  find_stick_commands(recordings, mapping, inference.findings, inference.doubts);
  const bool had_wheels = mapping.wheels.has_value();
  map_by_numbers(recordings, given, mapping, inference.findings);
  if (!had_wheels) choose_among_commands(recordings, given, mapping, inference.findings);
  map_metadata(recordings, mapping, inference.doubts);
  count_positions(given, mapping);
  const bool unit_assumed = mapping.wheels && mapping.wheels->unit_assumed && !given.says("wheels.unit");
  const bool gyro_is_stated = !mapping.gyro || mapping.gyro->unit_is_stated;
  mapping = to_mapping(overlaid(mapping, given), name);
  if (mapping.wheels) mapping.wheels->unit_assumed = unit_assumed;
  if (mapping.gyro) mapping.gyro->unit_is_stated = gyro_is_stated;
  infer_forward_bit(recordings, given, mapping, inference.findings, inference.doubts);
  infer_unit_of_time(recordings, given, mapping, inference.findings, inference.doubts);
  infer_turning_unit(recordings, given, mapping, inference.findings);
  if (mapping.command || mapping.wheels) {
    if (auto columns = gather_sample(recordings, mapping)) {
      infer_neutral(*columns, given, mapping, inference.findings);
      infer_watchdog(*columns, given, mapping, inference.findings);
      infer_counters(*columns, given, mapping, inference.findings, inference.doubts);
      infer_steering(*columns, given, mapping, inference.findings, inference.doubts);
      set_duty(*columns, given, mapping);
      const auto gather_again = [&] {
        if (auto again = gather_sample(recordings, mapping)) columns = std::move(again);
      };
      if (infer_heading_unit(*columns, given, mapping, inference.findings)) gather_again();
      if (infer_mirrored_side(*columns, given, mapping, inference.findings)) {
        gather_again();
        if (infer_heading_unit(*columns, given, mapping, inference.findings)) gather_again();
      }
      if (!states_its_frame(recordings) &&
          infer_reference_frame(recordings, *columns, given, mapping, inference.findings, inference.doubts))
        gather_again();
      set_units(*columns, given, mapping, inference.findings, inference.doubts);
      if (mapping.wheels && mapping.wheels->body_motion) gather_again();  // in the unit that was found
      infer_pixel_scale(recordings, *columns, given, mapping, inference.findings, inference.doubts);
      set_step_scale(*columns, given, mapping, inference.findings);
      set_gyro_unit(*columns, given, mapping, inference.findings, inference.doubts);
      add_doubts(*columns, mapping, inference.doubts);
      doubt_mirrored_side(*columns, mapping, inference.doubts);
    }
  }
  doubt_unknown_units(recordings, mapping, inference.doubts);
  doubt_idle_settings(given, mapping, inference.doubts);
  if (!had_wheels) doubt_one_wheel(recordings, given, mapping, inference.doubts);
  if (auto unused = unused_columns(recordings, mapping)) inference.findings.push_back(*std::move(unused));
  inference.entries = overlaid(mapping, given);
  // Each of several roles may have been looked for in the same streams.
  std::vector<std::string> once;
  for (auto& finding : inference.findings) {
    if (std::ranges::find(once, finding) == once.end()) once.push_back(std::move(finding));
  }
  inference.findings = std::move(once);
  return inference;
}

}  // namespace wheelwright::import
