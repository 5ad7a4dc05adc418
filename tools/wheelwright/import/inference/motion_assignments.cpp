#include "tools/wheelwright/import/inference/motion_assignments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/inference/response_fit.hpp"

namespace wheelwright::import {
namespace {

constexpr double motion_explained = 0.6;
constexpr std::size_t max_motion_rows = 20'000;

// Never negative, and no measured number that hardly changes, as a voltage in mV.
bool may_have_neutral(const std::vector<double>& command) {
  constexpr double least_range = 0.05;  // of the largest
  const ValueRange range = range_of(command);
  return range.least >= 0.0 && range.size() > least_range * range.most;
}

ResponseFit fit(const std::vector<double>& speed, const Channel& command) {
  ResponseRows rows;
  const std::size_t count = std::min(speed.size(), max_motion_rows);
  rows.speed.assign(speed.begin(), speed.begin() + static_cast<std::ptrdiff_t>(count));
  rows.command.assign(count, std::numeric_limits<double>::quiet_NaN());
  double last = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i) {
    rows.command[i] = last;
    if (std::isfinite(command.values[i])) last = command.values[i];
  }
  rows.run_ends = {count};
  return fit_response(rows, may_have_neutral(command.values) ? Baseline::any : Baseline::zero);
}

std::vector<double> speed_of(const Candidate& candidate, const std::vector<double>& t_s) {
  std::vector<double> values = candidate.channel->values;
  if (!candidate.cumulative) return values;
  if (const auto bits = wrapped_bits(values)) unwrap(values, *bits);
  std::vector<double> speed(values.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 1; i < values.size(); ++i)
    speed[i] = (values[i] - values[i - 1]) / (t_s[i] - t_s[i - 1]);
  return speed;
}

// Way and turn of the body, by a left and a right wheel: their mean and their difference.
std::array<std::vector<double>, 2> of_body(const std::vector<double>& left,
                                           const std::vector<double>& right) {
  std::array<std::vector<double>, 2> motion{left, right};
  for (std::size_t i = 0; i < left.size(); ++i) {
    motion[0][i] = 0.5 * (left[i] + right[i]);
    motion[1][i] = right[i] - left[i];
  }
  return motion;
}

// The sum and the difference of wheels, one of which counts backwards, are exchanged, and so are the commands
// that explain them. The gains of the turn and of the way are then as 4 to the wheel base, not as the wheel
// base to 1.
bool turns_for_driving(double way_gain, double turn_gain, std::optional<double> wheel_base_m) {
  constexpr double shortest_m = 0.1;
  constexpr double longest_m = 1.5;
  const double base_m = std::abs(turn_gain / way_gain);
  const double exchanged_m = 4.0 / base_m;
  if (!wheel_base_m) return exchanged_m > shortest_m && exchanged_m < longest_m;
  const auto is_near = [&wheel_base_m](double found_m) {
    return std::abs(std::log(found_m / *wheel_base_m)) < std::log(2.0);
  };
  return is_near(exchanged_m) && !is_near(base_m);
}

void take_reversed(double way_gain, double turn_gain, Assignment& assignment) {
  std::swap(assignment.command[0], assignment.command[1]);
  const bool second_is_reversed = turn_gain < 0.0;
  assignment.reversed = assignment.wheel[second_is_reversed ? 1 : 0].channel;
  if ((way_gain < 0.0) != second_is_reversed) std::swap(assignment.wheel[0], assignment.wheel[1]);
}

// Size of the correlation of a speed with what was commanded so many rows before.
double correlation(const std::vector<double>& speed, const std::vector<double>& command, int rows_before) {
  double count = 0.0, sum_s = 0.0, sum_c = 0.0, squares_s = 0.0, squares_c = 0.0, products = 0.0;
  const std::ptrdiff_t size = std::ssize(speed);
  for (std::ptrdiff_t i = std::max(0, rows_before); i < size && i - rows_before < size; ++i) {
    const double s = speed[static_cast<std::size_t>(i)];
    const double c = command[static_cast<std::size_t>(i - rows_before)];
    if (!std::isfinite(s) || !std::isfinite(c)) continue;
    count += 1.0;
    sum_s += s;
    sum_c += c;
    squares_s += s * s;
    squares_c += c * c;
    products += s * c;
  }
  const double variances = (squares_s - sum_s * sum_s / count) * (squares_c - sum_c * sum_c / count);
  return variances > 0.0 ? std::abs(products - sum_s * sum_c / count) / std::sqrt(variances) : 0.0;
}

class Assignments {
 public:
  Assignments(const std::vector<const Channel*>& commands, const std::vector<Candidate>& wheels,
              const std::vector<double>& t_s, std::optional<double> wheel_base_m)
      : commands_(commands), wheels_(wheels), wheel_base_m_(wheel_base_m) {
    for (const auto& wheel : wheels) {
      whole_.push_back(are_whole(wheel.channel->values));
      speeds_.push_back(speed_of(wheel, t_s));
      auto& fits = fits_.emplace_back();
      for (const Channel* command : commands)
        fits.push_back(command == wheel.channel ? ResponseFit{} : fit(speeds_.back(), *command));
    }
  }

  std::vector<Assignment> possible() && {
    for (std::size_t w = 0; w < wheels_.size(); ++w) {
      for (std::size_t c = 0; c < commands_.size(); ++c) {
        const ResponseFit& fit = fits_[w][c];
        offer({CommandKind::wheels, {commands_[c], nullptr}, {wheels_[w], {}}, fit.nats, fit.explained});
      }
    }
    for (std::size_t a = 0; a < wheels_.size(); ++a) {
      for (std::size_t b = a + 1; b < wheels_.size(); ++b) {
        if (wheels_[a].channel == wheels_[b].channel || !are_alike(a, b)) continue;
        offer_pairs(a, b);
        if (commands_.size() > 1) offer_twists(a, b);
      }
    }
    return std::move(possible_);
  }

 private:
  void offer(const Assignment& assignment) {
    if (assignment.explained >= motion_explained) possible_.push_back(assignment);
  }

  // Two counters, or two speeds, in the same unit. A place is as good as a counter where a robot drives
  // straight, but has parts.
  bool are_alike(std::size_t a, std::size_t b) const {
    const auto unit = [](const Channel& channel) {
      return channel.unit.empty() ? NameWords(channel.name).take_unit() : channel.unit;
    };
    return unit(*wheels_[a].channel) == unit(*wheels_[b].channel) &&
           wheels_[a].cumulative == wheels_[b].cumulative &&
           (!wheels_[a].cumulative || whole_[a] == whole_[b]);
  }

  void offer_pairs(std::size_t a, std::size_t b) {
    for (std::size_t c = 0; c < commands_.size(); ++c) {
      for (std::size_t d = 0; d < commands_.size(); ++d) {
        const auto is_wheel = [&](const Channel* command) {
          return command == wheels_[a].channel || command == wheels_[b].channel;
        };
        if (is_wheel(commands_[c]) || is_wheel(commands_[d]) || (c == d && commands_.size() > 1)) continue;
        offer({CommandKind::wheels,
               {commands_[c], c == d ? nullptr : commands_[d]},
               {wheels_[a], wheels_[b]},
               fits_[a][c].nats + fits_[b][d].nats,
               std::min(fits_[a][c].explained, fits_[b][d].explained)});
      }
    }
  }

  void offer_twists(std::size_t a, std::size_t b) {
    const auto [way, turn] = of_body(speeds_[a], speeds_[b]);
    std::vector<ResponseFit> way_fits;
    std::vector<ResponseFit> turn_fits;
    for (const Channel* command : commands_) {
      way_fits.push_back(fit(way, *command));
      turn_fits.push_back(fit(turn, *command));
    }
    const auto is_wheel = [&](const Channel* command) {
      return command == wheels_[a].channel || command == wheels_[b].channel;
    };
    for (std::size_t c = 0; c < commands_.size(); ++c) {
      for (std::size_t d = 0; d < commands_.size(); ++d) {
        if (c != d && !is_wheel(commands_[c]) && !is_wheel(commands_[d]))
          offer_twist({CommandKind::twist, {commands_[c], commands_[d]}, {wheels_[a], wheels_[b]}},
                      way_fits[c], turn_fits[d]);
      }
    }
  }

  void offer_twist(Assignment assignment, const ResponseFit& way, const ResponseFit& turn) {
    assignment.nats = way.nats + turn.nats;
    assignment.explained = std::min(way.explained, turn.explained);
    if (turns_for_driving(way.gain, turn.gain, wheel_base_m_)) {
      take_reversed(way.gain, turn.gain, assignment);
    } else if (turn.gain < 0.0) {
      std::swap(assignment.wheel[0], assignment.wheel[1]);
    }
    offer(assignment);
  }

  const std::vector<const Channel*>& commands_;
  const std::vector<Candidate>& wheels_;
  std::optional<double> wheel_base_m_;
  std::vector<bool> whole_;                     // of each wheel: its channel has no parts of one
  std::vector<std::vector<double>> speeds_;     // of each wheel
  std::vector<std::vector<ResponseFit>> fits_;  // of each wheel, by each command
  std::vector<Assignment> possible_;
};

}  // namespace

double rows_behind(const std::vector<double>& speed, const std::vector<double>& command) {
  constexpr int most = 20;
  std::vector<double> at;
  for (int rows = -2; rows <= most; ++rows) at.push_back(correlation(speed, command, rows));
  const auto peak = std::ranges::max_element(at);
  const double rows = static_cast<double>(peak - at.begin()) - 2.0;
  if (peak == at.begin() || peak + 1 == at.end()) return rows;
  const double bend = peak[-1] - 2.0 * peak[0] + peak[1];
  return bend < 0.0 ? rows + 0.5 * (peak[-1] - peak[1]) / bend : rows;
}

std::vector<Assignment> possible_assignments(const std::vector<const Channel*>& commands,
                                             const std::vector<Candidate>& wheels,
                                             const std::vector<double>& t_s,
                                             std::optional<double> wheel_base_m) {
  return Assignments(commands, wheels, t_s, wheel_base_m).possible();
}

bool commands_lead(const Assignment& assignment, const std::vector<double>& t_s, double least_rows) {
  std::array<std::vector<double>, 2> motion;
  for (std::size_t k = 0; k < 2; ++k) {
    const Candidate& wheel = assignment.wheel[k];
    if (wheel.channel == nullptr) continue;
    motion[k] = speed_of(wheel, t_s);
    if (wheel.channel != assignment.reversed) continue;
    for (double& speed : motion[k]) speed = -speed;
  }
  if (assignment.kind == CommandKind::twist) motion = of_body(motion[0], motion[1]);
  for (std::size_t k = 0; k < 2; ++k) {
    const Channel* command = assignment.command[k] != nullptr ? assignment.command[k] : assignment.command[0];
    if (command != nullptr && !motion[k].empty() && rows_behind(motion[k], command->values) < least_rows)
      return false;
  }
  return true;
}

}  // namespace wheelwright::import
