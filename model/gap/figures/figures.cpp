#include "model/gap/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/gap/figures/visible_error.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::size_t figure_count = 4;
constexpr std::array<std::string_view, figure_count> names{"wheel speed", "distance", "position", "heading"};
constexpr std::size_t first_integrated = 1;  // of wheel speed, most is noise of single ticks
constexpr std::size_t position = 2;          // and heading behind it

// m/s, m, m, rad: off by so little, a run is as good as right, whatever its noise.
constexpr std::array<double, figure_count> negligible{0.0, visible_travel_m, visible_position_m,
                                                      visible_heading_rad};

using Values = std::array<std::optional<double>, figure_count>;

Values values_of(const Score& score) {
  const auto value = [](const std::optional<AtHorizon>& figure) -> std::optional<double> {
    return figure ? std::optional(figure->value) : std::nullopt;
  };
  return {score.wheel_speed_rms_m_s, score.distance_rms_m, value(score.position_rms_m),
          value(score.heading_rms_rad)};
}

// Where a run has a first and a last pose only, how far the robot drifts in between is assumed, not
// measured: one may drift more.
double allowance_for(const GapFigures& figures, std::size_t which) {
  constexpr double longest_window_s = 15.0;
  constexpr double default_spread = 1.5;
  const auto& horizon = which == position ? figures.floor.position_rms_m : figures.floor.heading_rms_rad;
  const bool assumed = which >= position && horizon && horizon->horizon_s > longest_window_s;
  return assumed ? default_spread : 1.0;
}

double excess(const GapFigures& figures, std::size_t which) {
  const auto after = values_of(figures.after).at(which);
  const auto floor = values_of(figures.floor).at(which);
  if (!after || !floor || !(*floor > 0.0) || *after <= negligible.at(which)) return 0.0;
  return *after / (*floor * allowance_for(figures, which));
}

std::optional<double> share_gone(const GapFigures& figures, std::size_t which) {
  const auto before = values_of(figures.before).at(which);
  const auto after = values_of(figures.after).at(which);
  if (!before || !after || !(*before > 0.0)) return std::nullopt;
  return 1.0 - std::pow(*after / *before, 2);
}

double closed(const GapFigures& figures, std::size_t which) {
  const auto before = values_of(figures.before).at(which);
  const auto after = values_of(figures.after).at(which);
  const auto floor = values_of(figures.floor).at(which);
  return before && after && floor && *before > *floor ? (*before - *after) / (*before - *floor) : 1.0;
}

}  // namespace

Excess largest_excess(const GapFigures& train, const GapFigures& test) {
  Excess largest{names[first_integrated]};
  for (std::size_t i = first_integrated; i < figure_count; ++i) {
    const double times = std::min(excess(train, i), excess(test, i));
    if (times > largest.times) {
      largest = {names.at(i), times, std::min(closed(train, i), closed(test, i))};
    }
  }
  return largest;
}

std::optional<Excess> held_out_alone(const GapFigures& train, const GapFigures& test) {
  constexpr double far_above_floor = 3.0;  // in 155 clean cases 1.7 at most of travel, 2.0 of pose
  constexpr double above_training = 2.0;
  std::optional<Excess> largest;
  for (std::size_t i = first_integrated; i < figure_count; ++i) {
    const double times = excess(test, i);
    if (times < std::max(far_above_floor, above_training * excess(train, i))) continue;
    if (!largest || times > largest->times) largest = {names.at(i), times, closed(test, i)};
  }
  return largest;
}

bool some_figure_above_noise(const GapFigures& figures) {
  constexpr double scatter = 1.05;  // of the floor itself, from one draw of noise to the next
  const Values before = values_of(figures.before);
  const Values floor = values_of(figures.floor);
  for (std::size_t i = 0; i < figure_count; ++i) {
    if (before.at(i) && floor.at(i) && *before.at(i) > scatter * *floor.at(i)) return true;
  }
  return false;
}

bool all_figures_negligible(const GapFigures& figures) {
  const Values before = values_of(figures.before);
  bool any = false;
  for (std::size_t i = first_integrated; i < figure_count; ++i) {
    if (!before.at(i)) continue;
    if (*before.at(i) > negligible.at(i)) return false;
    any = true;
  }
  return any;
}

double largest_share_gone(const GapFigures& figures) {
  std::optional<double> largest;
  for (std::size_t i = first_integrated; i < figure_count; ++i) {
    if (const auto share = share_gone(figures, i)) largest = std::max(largest.value_or(*share), *share);
  }
  return largest.value_or(1.0);
}

bool goes_further_astray(const GapFigures& figures) {
  const Values before = values_of(figures.before);
  const Values after = values_of(figures.after);
  const Values floor = values_of(figures.floor);
  bool any = false;
  for (std::size_t i = first_integrated; i < figure_count; ++i) {
    if (!before.at(i) || !after.at(i) || !floor.at(i)) continue;
    if (std::max(*before.at(i), *after.at(i)) <= more_than_noise * *floor.at(i)) continue;
    if (*after.at(i) <= *before.at(i)) return false;
    any = true;
  }
  return any && common_fall(figures).value_or(0.0) <= 0.0;
}

Score bounded_floor(const Score& floor, const Score& after) {
  Score bounded = floor;
  const auto bound = [](std::optional<double>& value, const std::optional<double>& by) {
    if (value && by) value = std::min(*value, *by);
  };
  const auto bound_at_horizon = [](std::optional<AtHorizon>& value, const std::optional<AtHorizon>& by) {
    if (value && by) value->value = std::min(value->value, by->value);
  };
  bound(bounded.wheel_speed_rms_m_s, after.wheel_speed_rms_m_s);
  bound(bounded.distance_rms_m, after.distance_rms_m);
  bound_at_horizon(bounded.position_rms_m, after.position_rms_m);
  bound_at_horizon(bounded.heading_rms_rad, after.heading_rms_rad);
  return bounded;
}

bool some_figure_falls(const GapFigures& figures, double min_share, double above_floor) {
  const Values before = values_of(figures.before);
  const Values after = values_of(figures.after);
  const Values floor = values_of(figures.floor);
  for (std::size_t i = 0; i < figure_count; ++i) {
    if (!before.at(i) || !after.at(i)) continue;
    if (floor.at(i) && *before.at(i) < above_floor * *floor.at(i)) continue;
    if (*after.at(i) < (1.0 - min_share) * *before.at(i)) return true;
  }
  return false;
}

std::optional<double> common_fall(const GapFigures& figures) {
  const Values before = values_of(figures.before);
  const Values after = values_of(figures.after);
  double logarithms = 0.0;
  int count = 0;
  for (std::size_t i = first_integrated; i < figure_count; ++i) {
    if (!before.at(i) || !after.at(i) || *before.at(i) <= 0.0 || *after.at(i) <= 0.0) continue;
    logarithms += std::log(*after.at(i) / *before.at(i));
    ++count;
  }
  if (count == 0) return std::nullopt;
  return 1.0 - std::exp(logarithms / count);
}

bool shows(const GapFigures& figures) {
  constexpr double above_noise = 1.15;
  return some_figure_falls(figures, min_fall, above_noise);
}

}  // namespace wheelwright::gap
