#include "tools/wheelwright/import/inference/assignment.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_names.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;

// Whether the names say that the first is the right one.
bool are_exchanged(const Stream& stream, const Channel* first, const Channel* second) {
  if (first == nullptr || second == nullptr) return false;
  const auto side = [&stream](const Channel& channel) { return meaning_of(stream, channel).side; };
  return side(*first) == NamedSide::right || side(*second) == NamedSide::left;
}

double root_mean_square(const std::vector<double>& values) {
  double squares = 0.0;
  double count = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    squares += value * value;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

// Counted speeds of two wheels have the same step, and two wheels go about as fast; forward and turning speed
// do not.
bool are_of_body(const Assignment& best) {
  constexpr double unlike = 2.5;
  const auto& first = best.wheel[0].channel->values;
  const auto& second = best.wheel[1].channel->values;
  return std::abs(std::log(quantum(first) / quantum(second))) > 0.5 ||
         std::abs(std::log(root_mean_square(first) / root_mean_square(second))) > std::log(unlike);
}

// Forward and turning commands that are large and never negative: numbers about one at which the robot rests.
bool are_of_a_remote_control(const Assignment& best) {
  return std::ranges::all_of(best.command, [](const Channel* channel) {
    return channel != nullptr && largest(channel->values) > fastest_m_s &&
           std::ranges::none_of(channel->values, [](double value) { return value < 0.0; });
  });
}

}  // namespace

std::string column_in_words(const Channel& channel) {
  const bool is_number = channel.name.find_first_not_of("0123456789") == std::string::npos;
  return (is_number ? "column " : "'") + channel.name + (is_number ? "" : "'");
}

void take_assignment(const Stream& stream, const Assignment& best, Mapping& mapping,
                     std::vector<std::string>& findings) {
  const bool one_wheel = best.wheel[1].channel == nullptr;
  const bool is_body = !one_wheel && best.kind == CommandKind::wheels && best.command[1] != nullptr &&
                       !best.wheel[0].cumulative && are_of_body(best);
  const std::string evidence = " (explains " + fixed_number(100.0 * best.explained, 1) +
                               " % of the speed, log-likelihood gain " + fixed_number(best.nats, 0) + ")";
  if (!mapping.command) {
    CommandMapping command;
    const bool exchanged =
        best.kind != CommandKind::twist && are_exchanged(stream, best.command[0], best.command[1]);
    command.kind = best.kind;
    const std::string stated_unit = meaning_of(stream, *best.command[0]).unit;
    if (find_unit(speed_units(), stated_unit)) {
      command.unit = stated_unit;
    } else if (best.kind == CommandKind::wheels && largest(best.command[0]->values) > fastest_m_s &&
               meaning_of(stream, *best.command[0]).quantity != Quantity::speed) {
      command.kind = CommandKind::duty;
    }
    if (is_body) command.kind = CommandKind::twist;
    if (command.kind == CommandKind::twist && are_of_a_remote_control(best))
      command.kind = CommandKind::throttle;
    command.first = {stream.name, best.command[exchanged ? 1 : 0]->name};
    if (best.command[1] != nullptr)
      command.second = ChannelName{stream.name, best.command[exchanged ? 0 : 1]->name};
    mapping.command = command;
    findings.push_back(
        std::string(command.kind == CommandKind::throttle ? "commands are throttle and steering: "
                    : command.kind == CommandKind::twist  ? "commands are forward and turning speed: "
                    : best.command[1] == nullptr          ? "the command is "
                                                          : "commands are left and right: ") +
        column_in_words(*best.command[exchanged ? 1 : 0]) +
        (best.command[1] == nullptr ? "" : " and " + column_in_words(*best.command[exchanged ? 0 : 1])) +
        evidence);
  }
  if (!mapping.wheels) {
    WheelMapping wheels;
    wheels.kind = best.wheel[0].cumulative ? WheelKind::counts : WheelKind::speed;
    if (best.wheel[0].cumulative && !are_whole(best.wheel[0].channel->values)) {
      wheels.kind = WheelKind::distance;  // parts of a count are none
      wheels.unit = "m";
    }
    if (!best.wheel[0].cumulative && largest(best.wheel[0].channel->values) <= fastest_m_s)
      wheels.unit = "m/s";
    wheels.body_motion = is_body;
    const bool exchanged = are_exchanged(stream, best.wheel[0].channel, best.wheel[1].channel);
    wheels.left = {stream.name, best.wheel[exchanged ? 1 : 0].channel->name};
    if (!one_wheel) wheels.right = ChannelName{stream.name, best.wheel[exchanged ? 0 : 1].channel->name};
    wheels.unit_assumed = wheels.kind != WheelKind::counts;
    const std::string stated = meaning_of(stream, *best.wheel[0].channel).unit;
    if (wheels.kind == WheelKind::speed && find_unit(speed_units(), stated)) {
      wheels.unit = stated;
      wheels.unit_assumed = false;
    }
    if (best.reversed != nullptr) {
      wheels.left_reversed = best.reversed->name == wheels.left.channel;
      wheels.right_reversed = !wheels.left_reversed;
      findings.push_back(
          "the " + std::string(wheels.left_reversed ? "left" : "right") +
          " wheel counts backwards: if it did not, the robot would turn where it is told to drive");
    }
    mapping.wheels = wheels;
    findings.push_back(std::string(wheels.kind == WheelKind::counts     ? "counts"
                                   : wheels.kind == WheelKind::distance ? "travel"
                                                                        : "speeds") +
                       (one_wheel ? " of one wheel: "
                        : is_body ? " of the body, forward and turning: "
                                  : " of the left and right wheel: ") +
                       column_in_words(*best.wheel[exchanged ? 1 : 0].channel) +
                       (one_wheel ? "" : " and " + column_in_words(*best.wheel[exchanged ? 0 : 1].channel)) +
                       evidence);
  }
}

}  // namespace wheelwright::import
