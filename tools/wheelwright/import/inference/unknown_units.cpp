#include "tools/wheelwright/import/inference/unknown_units.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "config/load/ascii_text.hpp"
#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/conversion/time_units.hpp"
#include "tools/wheelwright/import/inference/unused_columns.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

// What stands in the place of a unit and scales nothing, an inch, and letters, which may be names.
bool is_no_unknown(const std::string& unit) {
  constexpr std::array<std::string_view, 16> words{"pct",    "in",    "count", "counts", "tick", "ticks",
                                                   "pulses", "pulse", "steps", "step",   "pwm",  "raw",
                                                   "duty",   "hms",   "iso",   "bool"};
  return unit.size() < 2 ||
         std::ranges::find(words, std::string_view(config::lower_case(unit))) != words.end();
}

}  // namespace

void doubt_unknown_units(std::span<const Recording> recordings, const Mapping& mapping,
                         std::vector<std::string>& doubts) {
  for (const Recording& recording : recordings) {
    for (const Stream& stream : recording.streams) {
      for (const Channel& channel : stream.channels) {
        if (is_no_unknown(channel.unit) || !unit_by_spelling(channel.unit).empty() ||
            stated_time_unit(channel.unit) || !is_used(mapping, stream, channel))
          continue;
        doubts.push_back(
            "'" + config::excerpt(channel.name) + "' is said to be in '" + config::excerpt(channel.unit) +
            "', which is not known here: convert it, or state the unit that is meant (command.unit, "
            "wheels.unit, reference.unit, reference.angle_unit, gyro.unit, battery.unit)");
      }
    }
  }
}

}  // namespace wheelwright::import
