#include "tools/wheelwright/import/inference/units/battery_unit.hpp"

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {

void check_battery(std::span<const Recording> recordings, Mapping& mapping,
                   std::vector<std::string>& findings) {
  constexpr double most_v = 60.0;
  constexpr double least_mv = 2500.0;
  if (!mapping.battery || mapping.battery->unit_is_stated) return;
  const FoundChannel found = find_channel(recordings, mapping.battery->column);
  const double most = found.channel == nullptr ? 0.0 : largest(found.channel->values);
  if (most <= most_v) return;
  const std::string name = mapping.battery->column.text();
  if (most >= least_mv && most <= 1000.0 * most_v) {
    mapping.battery->unit = "mV";
    findings.push_back(name + " is taken for millivolts");
    return;
  }
  mapping.battery.reset();
  findings.push_back(name + " goes up to " + config::plain_number(most) +
                     ", which is no voltage in V or mV: not used; if it is one: --set battery.column=" +
                     name + " --set battery.unit=V");
}

}  // namespace wheelwright::import
