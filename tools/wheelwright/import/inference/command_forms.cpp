#include "tools/wheelwright/import/inference/command_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {
namespace {

using config::plain_number;

constexpr double form_explained = 0.5;

std::array<ResponseFit, 2> fit_both(const DriveColumns& columns, const Mapping& mapping) {
  const auto rows = response_rows(columns, mapping);
  return {fit_response(rows[0]), fit_response(rows[1])};
}

// The values of the bits that are not `forward`; it itself where there are none.
double other_value(const DriveColumns& columns, double forward) {
  for (const Column& bits : columns.direction) {
    if (std::ranges::find(bits, -forward) != bits.end()) return -forward;
    for (const double bit : bits) {
      if (std::isfinite(bit) && bit != forward) return bit;
    }
  }
  return forward;
}

}  // namespace

void infer_forward_bit(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                       std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  if (!mapping.command || !mapping.command->direction[0] || given.says("command.forward")) return;
  const auto columns = gather_sample(recordings, mapping);
  if (!columns) return;
  const auto fits = mapping.wheels ? fit_both(*columns, mapping) : std::array<ResponseFit, 2>{};
  if (std::ranges::any_of(fits, [](const ResponseFit& fit) { return fit.explained < form_explained; })) {
    doubts.push_back("which value of the direction bits is forward is not shown by the wheels; " +
                     plain_number(mapping.command->forward) + " is taken: --set command.forward");
    return;
  }
  if (fits[0].gain > 0.0 || fits[1].gain > 0.0) return;
  mapping.command->forward = other_value(*columns, mapping.command->forward);
  findings.push_back("forward is the direction bit " + plain_number(mapping.command->forward) +
                     ": both wheels count up with it");
}

void infer_steering(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  if (!mapping.command || mapping.command->kind != CommandKind::throttle ||
      given.says("command.steering_gain"))
    return;
  CommandMapping& command = *mapping.command;
  const bool has_both = mapping.wheels && mapping.wheels->right;
  const auto fits = has_both ? fit_both(columns, mapping) : std::array<ResponseFit, 2>{};
  if (fits[0].explained < form_explained || fits[1].explained < form_explained) {
    doubts.push_back(
        "how steering is mixed with throttle is not shown by the wheels; left = throttle - steering is "
        "taken: --set command.steering_gain=-1 where positive steering turns right");
    return;
  }
  // Of the difference of the wheels, by the speed of both.
  command.steering_gain = rounded_gain(0.5 * fits[1].gain / fits[0].gain);
  findings.push_back("steering is mixed as left = throttle " +
                     std::string(command.steering_gain < 0.0 ? "+ " : "- ") +
                     plain_number(std::abs(command.steering_gain)) +
                     " * steering, by the wheels; --set "
                     "command.steering_gain if you know it");
}

}  // namespace wheelwright::import
