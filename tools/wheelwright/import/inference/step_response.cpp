#include "tools/wheelwright/import/inference/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/assignment.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"

namespace wheelwright::import {
namespace {

using config::plain_number;

constexpr std::size_t min_rows = 30;
constexpr double max_m_s = 3.0;
constexpr double sure_step = 0.6;  // share of the variance that a step of first order explains
constexpr double sure_rate = 0.9;  // share of the variance of a speed that the steps of a travel explain
constexpr std::size_t window = 8;  // rows over which a travel is differenced

double constant_of(const std::vector<double>& values) {
  double result = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (std::isfinite(result) && value != result) return std::numeric_limits<double>::quiet_NaN();
    result = value;
  }
  return result;
}

double variance(const std::vector<double>& values) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(values.size());
  return squares / n - sum * sum / (n * n);
}

// How much of a speed a step of first order from rest explains, at the best time constant.
double explained_by_step(const std::vector<double>& speed, const std::vector<double>& t_s) {
  const double all = variance(speed);
  const double length_s = t_s.back() - t_s.front();
  if (!(all > 0.0) || !(length_s > 0.0)) return 0.0;
  double best = 0.0;
  for (double part = 0.01; part < 0.35; part *= 1.2) {
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < speed.size(); ++i) {
      const double rise = 1.0 - std::exp(-(t_s[i] - t_s.front()) / (part * length_s));
      products += rise * speed[i];
      squares += rise * rise;
    }
    const double gain = products / squares;
    double rest = 0.0;
    for (std::size_t i = 0; i < speed.size(); ++i) {
      const double rise = 1.0 - std::exp(-(t_s[i] - t_s.front()) / (part * length_s));
      rest += (speed[i] - gain * rise) * (speed[i] - gain * rise);
    }
    best = std::max(best, 1.0 - rest / static_cast<double>(speed.size()) / all);
  }
  return best;
}

// How well the rate of a travel is another column.
double explained_by_rate(const std::vector<double>& travel, const std::vector<double>& speed,
                         const std::vector<double>& t_s) {
  std::vector<double> rates;
  std::vector<double> speeds;
  for (std::size_t i = window; i < travel.size(); i += window / 2) {
    rates.push_back((travel[i] - travel[i - window]) / (t_s[i] - t_s[i - window]));
    double sum = 0.0;
    for (std::size_t k = i - window + 1; k <= i; ++k) sum += speed[k];
    speeds.push_back(sum / static_cast<double>(window));
  }
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    products += rates[i] * speeds[i];
    squares += rates[i] * rates[i];
  }
  if (!(squares > 0.0) || !(variance(speeds) > 0.0)) return 0.0;
  double rest = 0.0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const double off = speeds[i] - products / squares * rates[i];
    rest += off * off;
  }
  return 1.0 - rest / static_cast<double>(rates.size()) / variance(speeds);
}

bool is_complete(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

struct Step {
  const Channel* speed = nullptr;
  const Channel* travel = nullptr;
  double explained = 0.0;
};

// The one that begins at rest and settles; nothing where two columns that do not belong together do so.
std::optional<Step> step_of(const std::vector<const Channel*>& columns, const std::vector<double>& t_s) {
  std::optional<Step> best;
  std::size_t count = 0;
  for (const Channel* channel : columns) {
    const auto& values = channel->values;
    if (!is_complete(values) || std::abs(values.front()) > 0.1 * largest(values)) continue;
    const double explained = explained_by_step(values, t_s);
    if (explained < sure_step) continue;
    ++count;
    if (!best || explained > best->explained) best = Step{channel, nullptr, explained};
  }
  if (!best) return std::nullopt;
  double rate = sure_rate;
  for (const Channel* channel : columns) {
    if (channel == best->speed || !is_complete(channel->values)) continue;
    const double explained = explained_by_rate(channel->values, best->speed->values, t_s);
    if (explained < rate) continue;
    rate = explained;
    best->travel = channel;
  }
  return count == 1 || best->travel != nullptr ? best : std::nullopt;
}

}  // namespace

void find_step(const Stream& stream, const std::vector<double>& t_s,
               const std::vector<const Channel*>& unused, const GivenMapping& given, Mapping& mapping,
               std::vector<std::string>& findings) {
  if (mapping.wheels || stream.rows < min_rows || !stream.run_starts.empty()) return;
  if (!is_complete(t_s) || !std::ranges::is_sorted(t_s) || !(t_s.back() > t_s.front())) return;
  std::vector<const Channel*> moving;
  std::vector<const Channel*> standing;
  for (const Channel* channel : unused) {
    const double constant = constant_of(channel->values);
    if (!std::isfinite(constant)) moving.push_back(channel);
    if (std::abs(constant) > 0.0) standing.push_back(channel);
  }
  const auto step = step_of(moving, t_s);
  if (!step) return;
  WheelMapping wheels;
  wheels.kind = WheelKind::speed;
  wheels.left = {stream.name, step->speed->name};
  wheels.unit_assumed = !given.says("wheels.unit");
  mapping.wheels = wheels;
  findings.push_back(
      "one step of one wheel: its speed is " + column_in_words(*step->speed) +
      ", which starts at rest and settles" +
      (step->travel == nullptr ? "" : " and is the rate of " + column_in_words(*step->travel)));
  // A travel that never moved stands at a number as the command does; the one that is nearest to a duty is
  // first.
  const auto is_duty = [](const Channel* channel) { return std::abs(constant_of(channel->values)) <= 255.0; };
  if (mapping.command || std::ranges::count_if(standing, is_duty) != 1) return;
  const Channel* command = *std::ranges::find_if(standing, is_duty);
  mapping.command = CommandMapping{};
  mapping.command->kind = CommandKind::duty;
  mapping.command->first = {stream.name, command->name};
  findings.push_back("the command is " + column_in_words(*command) + ", which is at " +
                     plain_number(constant_of(command->values)));
}

void set_step_scale(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
                    std::vector<std::string>& findings) {
  if (!mapping.command || !mapping.wheels || mapping.command->is_of_body() || given.says("command.unit"))
    return;
  CommandMapping& command = *mapping.command;
  const double constant = constant_of(columns.command[0]);
  if (!(std::abs(constant) > 0.0) || given.says("command.full_scale_m_s")) return;
  if (!given.says("command.kind") && std::abs(constant) > max_m_s) command.kind = CommandKind::duty;
  set_full_scale(columns, given, command);
  const auto scale = wheel_scale(*mapping.wheels);
  if (command.kind != CommandKind::duty || !scale) return;
  const auto rows = response_rows(columns, mapping)[0];
  std::vector<double> speeds;
  for (const double speed : rows.speed) {
    if (std::isfinite(speed)) speeds.push_back(speed);
  }
  if (speeds.size() < min_rows) return;
  const auto mean = [&](std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t i = from; i < to; ++i) sum += speeds[i];
    return sum / static_cast<double>(to - from);
  };
  const std::size_t n = speeds.size();
  const double settled = mean(3 * n / 4, n);
  constexpr double max_change = 0.1;
  if (std::abs(mean(n / 2, 3 * n / 4) / settled - 1.0) > max_change) return;
  const double full_m_s = rounded_gain(std::abs(settled * *scale / constant) * command.full_scale);
  if (full_m_s < 0.001 || full_m_s > 100.0) return;
  command.full_scale_m_s = full_m_s;
  findings.push_back("a duty of " + plain_number(constant) + " of " + plain_number(command.full_scale) +
                     " leads to " + plain_number(rounded_gain(settled * *scale)) +
                     " m/s, at which the wheel settles: " + plain_number(full_m_s) +
                     " m/s for all of it, in proportion; one level shows no dead zone");
}

}  // namespace wheelwright::import
