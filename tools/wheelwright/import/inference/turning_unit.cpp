#include "tools/wheelwright/import/inference/turning_unit.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/wheel_directions.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using Fits = std::array<ResponseFit, 2>;

std::string degrees_of(const WheelMapping& wheels) {
  return wheels.kind == WheelKind::speed ? "deg/s" : "deg";
}

std::optional<Fits> fits_in(std::span<const Recording> recordings, Mapping mapping, const std::string& unit) {
  mapping.wheels->angular_unit = unit;
  const auto columns = gather_sample(recordings, mapping);
  if (!columns || columns->command[1].empty()) return std::nullopt;
  const auto rows = response_rows(*columns, mapping);
  return Fits{fit_response(rows[0]), fit_response(rows[1])};
}

// Of forward and turning commands the fit is as good in any unit; by how far the robot turns.
bool turns_57_times_too_far(const Mapping& mapping, const ResponseFit& turning) {
  const WheelMapping& wheels = *mapping.wheels;
  const double metres =
      in_si(wheels.kind == WheelKind::speed ? speed_units() : distance_units(), wheels.unit);
  const double commanded = in_si(angular_units(), mapping.command->angular_unit);
  const double gain = turning.gain * metres / *mapping.wheel_base_m / commanded;
  return turning.explained >= unit_explained && is_near(std::abs(gain), 180.0 / std::numbers::pi);
}

bool is_stated(std::span<const Recording> recordings, const ChannelName& name) {
  const FoundChannel found = find_channel(recordings, name);
  return found.channel == nullptr || !meaning_of(*found.stream, *found.channel).unit.empty();
}

}  // namespace

void infer_turning_unit(std::span<const Recording> recordings, const GivenMapping& given, Mapping& mapping,
                        std::vector<std::string>& findings) {
  constexpr double sure_nats = 20.0;
  if (!mapping.command || mapping.command->kind == CommandKind::throttle || !mapping.wheel_base_m) return;
  if (!mapping.wheels || !mapping.wheels->body_motion || !mapping.wheels->right ||
      !mapping.wheels->angular_unit.empty() || given.says("wheels.angular_unit") ||
      is_stated(recordings, *mapping.wheels->right))
    return;
  const auto radians = fits_in(recordings, mapping, "");
  if (!radians) return;
  if (mapping.command->kind == CommandKind::twist) {
    if (!turns_57_times_too_far(mapping, (*radians)[1])) return;
  } else {
    const auto degrees = fits_in(recordings, mapping, degrees_of(*mapping.wheels));
    const auto nats = [](const Fits& fits) { return fits[0].nats + fits[1].nats; };
    if (!degrees || nats(*degrees) < nats(*radians) + sure_nats) return;
  }
  mapping.wheels->angular_unit = degrees_of(*mapping.wheels);
  findings.push_back(mapping.wheels->right->text() +
                     " is in degrees: so the robot turns as commanded, and in radians it does not");
}

}  // namespace wheelwright::import
