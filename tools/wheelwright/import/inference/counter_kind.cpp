#include "tools/wheelwright/import/inference/counter_kind.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/fast_counter.hpp"
#include "tools/wheelwright/import/conversion/wheel_command.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;

constexpr double counter_nats = 50.0;
constexpr double counter_explained = 0.7;

class CounterKind {
 public:
  CounterKind(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
              std::vector<std::string>& findings, std::vector<std::string>& doubts)
      : columns_(columns),
        given_(given),
        mapping_(mapping),
        wheels_(*mapping.wheels),
        findings_(findings),
        doubts_(doubts) {}

  void run() {
    if (wheels_.kind == WheelKind::counts && !given_.says("wheels.bits") && !wheels_.per_row)
      tell_fast_counters();
    if (wheels_.kind != WheelKind::speed && !given_.says("wheels.per_row") && !wheels_.per_row &&
        !wheels_.unwrap_by_command)
      tell_running();
    if (!given_.says("wheels.direction") && !wheels_.unwrap_by_command) tell_direction();
  }

 private:
  struct Fit {
    double explained = 0.0;
    double nats = 0.0;
    double steady =
        0.0;  // swing of the steady speeds by that of the speeds: near 1 of a wheel, 0 of a change

    std::string text() const { return fixed_number(100.0 * explained, 0) + " %"; }
  };

  // Of both wheels; the one that is explained less counts.
  Fit fit(const Mapping& mapping) const {
    const auto rows = response_rows(columns_, mapping);
    const ResponseFit left = fit_response(rows[0]);
    const ResponseFit right = columns_.wheel[1].empty() ? left : fit_response(rows[1]);
    return {
        std::min(left.explained, right.explained), left.nats + right.nats,
        std::max(steady_part(left, rows[0]), steady_part(right, rows[columns_.wheel[1].empty() ? 0 : 1]))};
  }

  void tell_fast_counters() {
    for (const int bits : {8, 16}) {
      const bool is_fast = std::ranges::any_of(columns_.wheel, [bits](const Column& wheel) {
        return !wheel.empty() && !wrapped_bits(wheel) && is_fast_counter(wheel, bits);
      });
      if (!is_fast) continue;
      if (can_be_predicted(bits)) {
        wheels_.bits = bits;
        wheels_.unwrap_by_command = true;
        findings_.push_back("the counters have " + std::to_string(bits) +
                            " bits and go more than half around between rows: of what they may have counted, "
                            "that is taken which the command predicts");
      } else {
        doubts_.push_back("the counters have " + std::to_string(bits) +
                          " bits and go more than half around between rows, and the command does not predict "
                          "how far: what the wheels did is unknown; log more often, or more bits");
      }
      return;
    }
  }

  bool can_be_predicted(int bits) const {
    std::vector<std::size_t> rows(columns_.rows());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const auto commands = wheel_commands(columns_, rows, mapping_);
    for (std::size_t side = 0; side < 2; ++side) {
      const Column& counts = columns_.wheel[side];
      if (counts.empty()) continue;
      if (commands[side].empty()) return false;
      if (!predict_counter(counts, commanded_travel(columns_, rows, commands[side]), bits, std::nullopt)
               .is_sure())
        return false;
    }
    return true;
  }

  static double steady_part(const ResponseFit& fit, const ResponseRows& rows) {
    return std::abs(fit.gain) * swing(rows.command) / std::max(swing(rows.speed), 1e-300);
  }

  static double swing(const std::vector<double>& values) {
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      sum += value;
      squares += value * value;
      count += 1.0;
    }
    return count > 0.0 ? std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count))) : 0.0;
  }

  // Counts whose values, not their steps, stand where the command does. The steps follow a command too, but a
  // steady one leads to none.
  void tell_running() {
    Mapping other = mapping_;
    other.wheels->per_row = true;
    const Fit running = fit(mapping_);
    const Fit per_row = fit(other);
    if (per_row.explained < counter_explained || per_row.nats < running.nats + counter_nats ||
        per_row.steady < 0.6 || running.steady > 0.2)
      return;
    wheels_.per_row = true;
    findings_.push_back(
        "the wheels' columns hold the travel of each row, not its sum: their values go as the "
        "command does (it explains " +
        per_row.text() + " of them), and a steady command leads to no steps");
  }

  // Whether a wheel never goes back though it is asked to.
  bool has_lost_sign(std::size_t side, const std::array<Column, 2>& commands) const {
    const Column& wheel = columns_.wheel[side];
    if (wheel.empty()) return true;
    std::size_t back = 0;
    std::size_t driven = 0;
    for (const double command : commands[side]) {
      if (command != 0.0 && std::isfinite(command)) ++driven;
      if (command < 0.0) ++back;
    }
    if (20 * back < driven || back < 10) return false;
    Column values = wheel;
    if (wheels_.kind == WheelKind::counts && !wheels_.per_row) {
      if (const auto bits = wheels_.bits ? wheels_.bits : wrapped_bits(values)) unwrap(values, *bits);
    }
    const bool are_values = wheels_.kind == WheelKind::speed || wheels_.per_row;
    double last = are_values ? 0.0 : -std::numeric_limits<double>::infinity();
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      if (value < last) return false;
      if (!are_values) last = value;
    }
    return true;
  }

  void tell_direction() {
    if (wheels_.body_motion) return;
    std::vector<std::size_t> rows(columns_.rows());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const auto commands = wheel_commands(columns_, rows, mapping_);
    if (commands[0].empty() || !has_lost_sign(0, commands) || !has_lost_sign(1, commands)) return;
    Mapping other = mapping_;
    other.wheels->by_command_sign = true;
    const Fit without = fit(mapping_);
    const Fit with = fit(other);
    if (with.explained < counter_explained || with.nats < without.nats + counter_nats) {
      doubts_.push_back(
          "the wheels never go back, though commands are negative: they have lost their sign, and the "
          "command "
          "does not give it back (it explains " +
          with.text() + " of the speed with its sign, " + without.text() +
          " without); log the direction, or say --set wheels.direction=command");
      return;
    }
    wheels_.by_command_sign = true;
    findings_.push_back(
        "the wheels hold no direction (they never go back, though commands are negative): it is "
        "taken from the command, which explains " +
        with.text() + " of the speed so, and " + without.text() +
        " without; --set wheels.direction=counted if they never went back");
  }

  const DriveColumns& columns_;
  const GivenMapping& given_;
  Mapping& mapping_;
  WheelMapping& wheels_;
  std::vector<std::string>& findings_;
  std::vector<std::string>& doubts_;
};

}  // namespace

void infer_counters(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  if (!mapping.command || !mapping.wheels) return;
  CounterKind(columns, given, mapping, findings, doubts).run();
}

}  // namespace wheelwright::import
