#include "tools/wheelwright/import/inference/leading_speeds.hpp"

#include <algorithm>
#include <array>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/motion_assignments.hpp"
#include "tools/wheelwright/import/inference/named_channels.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {

namespace {

bool may_be_replaced(const GivenMapping& given, const Mapping& mapping) {
  if (!mapping.command) return true;
  return mapping.command->kind == CommandKind::duty && !given.says("command.left") &&
         !given.says("command.kind") && !given.says("command.full_scale") &&
         !given.says("command.full_scale_m_s");
}

// How much of way and turn is explained; 0 where they do not come behind the command. Commands stand at the
// row behind them: a speed that was measured over a row would be one ahead, or half of one.
double explained_behind(const std::array<ResponseRows, 2>& rows) {
  constexpr double least_rows = -0.1;
  double explained = 1.0;
  for (const ResponseRows& side : rows) {
    explained = std::min(explained, fit_response(side).explained);
    if (rows_behind(side.speed, side.command) < least_rows) return 0.0;
  }
  return explained;
}

}  // namespace

void find_leading_speeds(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                         std::vector<std::string>& findings) {
  if (!mapping.wheels || !mapping.wheels->right || !may_be_replaced(given, mapping)) return;
  const NamedChannels named(recordings, mapping);
  std::vector<std::string> others;
  const auto found = NamedChannels::pair(named.all(Quantity::linear_speed, NamedSide::none),
                                         named.all(Quantity::angular_speed, NamedSide::none), others);
  if (!found) return;
  CommandMapping command;
  command.kind = CommandKind::twist;
  command.first = found->first.name();
  command.second = found->second.name();
  if (find_unit(speed_units(), found->first.meaning.unit)) command.unit = found->first.meaning.unit;
  if (find_unit(angular_units(), found->second.meaning.unit))
    command.angular_unit = found->second.meaning.unit;
  Mapping tried = mapping;
  tried.command = command;
  const auto columns = gather_sample(recordings, tried);
  if (!columns) return;
  const double explained = explained_behind(response_rows(*columns, tried));
  const bool is_held_pair = is_held(found->first.channel->values);
  if (explained < (mapping.command ? 0.9 : is_held_pair ? 0.3 : 0.7)) return;
  mapping.command = command;
  findings.push_back(command.first.text() + " and " + command.second->text() +
                     " are taken for commands: the wheels follow them (they explain " +
                     config::fixed_number(100.0 * explained, 0) + " % of way and turn)");
}

}  // namespace wheelwright::import
