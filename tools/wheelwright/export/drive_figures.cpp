#include "tools/wheelwright/export/drive_figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "config/load/printable_text.hpp"
#include "model/effects/library/each_wheel_variants.hpp"
#include "model/effects/library/effect_library.hpp"
#include "model/statistics/confidence.hpp"

namespace wheelwright::tools {
namespace {

using Map = std::function<double(double)>;

// One parameter of an effect, through a monotonic map.
Figure figure_of(const RobotModel& model, const AddedEffect& effect, std::size_t parameter, const Map& map) {
  Figure figure{map(effect.setting.parameters[parameter]), {}, source_of(model, effect)};
  if (parameter < effect.intervals.size()) {
    const auto [lower, upper] =
        std::minmax({map(effect.intervals[parameter].lower), map(effect.intervals[parameter].upper)});
    figure.interval = {lower, upper};
  }
  return figure;
}

// Intervals are added as those of independent errors.
Figure product(const Figure& one, const Figure& other) {
  Figure both{one.value * other.value,
              {},
              one.from + (one.from.empty() || other.from.empty() ? "" : ", ") + other.from};
  if (!one.interval && !other.interval) return both;
  const auto relative = [](const Figure& figure, bool upper) {
    if (!figure.interval) return 0.0;
    return (upper ? figure.interval->upper : figure.interval->lower) / figure.value - 1.0;
  };
  both.interval = {both.value * (1.0 - std::hypot(relative(one, false), relative(other, false))),
                   both.value * (1.0 + std::hypot(relative(one, true), relative(other, true)))};
  return both;
}

// A fit's standard error as an interval.
Figure gain_figure(double gain, const std::optional<WheelFit>& fit, double DcGain::*own,
                   const std::string& from) {
  Figure figure{gain, {}, from};
  const double error = fit ? fit->gain_standard_error.*own : 0.0;
  if (error > 0.0) figure.interval = {gain - deviations_in_ci95 * error, gain + deviations_in_ci95 * error};
  return figure;
}

// Of two that limit, the tighter one.
void take(std::optional<Figure>& kept, Figure figure, bool smaller) {
  if (!kept || (smaller ? figure.value < kept->value : figure.value > kept->value)) kept = std::move(figure);
}

void add_scale(const RobotModel& model, const AddedEffect& effect, DriveFigures& figures) {
  const auto times = [&](Figure& multiplier, const Map& map) {
    multiplier = product(multiplier, figure_of(model, effect, 0, map));
  };
  if (effect.setting.name == "distance_scale") {
    times(figures.left_radius_multiplier, [](double change) { return 1.0 + change; });
    times(figures.right_radius_multiplier, [](double change) { return 1.0 + change; });
    if (effect.setting.variant == "turns_as_counted")
      times(figures.separation_multiplier, [](double change) { return 1.0 + change; });
  } else if (effect.setting.name == "wheel_scale_mismatch") {
    const double of_left = effect.setting.variant == "left_wheel"    ? 1.0
                           : effect.setting.variant == "right_wheel" ? 0.0
                                                                     : 0.5;
    times(figures.left_radius_multiplier, [of_left](double mismatch) { return 1.0 - of_left * mismatch; });
    times(figures.right_radius_multiplier,
          [of_left](double mismatch) { return 1.0 + (1.0 - of_left) * mismatch; });
  } else if (effect.setting.name == "effective_track") {
    const double base = figures.wheel_separation_m;
    times(figures.separation_multiplier, [base](double excess) { return (base + excess) / base; });
  }
}

// What a controller of the wheels' speed makes up for costs no speed in the end, and no command is too small.
bool is_made_up_for(const AddedEffect& friction) {
  return as_at(WheelSide::left, friction.setting).variant == "controlled";
}

// Of one wheel; of both together the tighter limit.
void add_limit(const RobotModel& model, const AddedEffect& effect, WheelSide wheel, DriveFigures& figures) {
  const EffectSetting own = as_at(wheel, effect.setting);
  const std::vector<std::size_t> places = places_at(wheel, effect.setting);
  WheelLimits& limits = wheel == WheelSide::left ? figures.left_limits : figures.right_limits;
  const double gain = 0.5 * (figures.gain.left + figures.gain.right);
  const double of_speed = own.variant == "command" ? gain : 1.0;
  const auto same = [](double value) { return value; };
  const auto to_speed = [of_speed](double value) { return of_speed * value; };
  const auto to_command = [gain](double value) { return value / gain; };
  const auto figure = [&](std::size_t parameter, const Map& map) {
    return figure_of(model, effect, places[parameter], map);
  };
  if (own.name == "transport_delay") figures.delay_s = figure(0, same);
  if (own.name == "saturation") {
    take(limits.largest_speed_m_s, figure(0, to_speed), true);
    take(figures.largest_speed_m_s, figure(0, to_speed), true);
  }
  if (own.name == "rate_limit") take(figures.largest_change_m_s2, figure(0, to_speed), true);
  if (own.name == "dead_zone") take(figures.smallest_command_m_s, figure(0, same), false);
  if (is_made_up_for(effect)) return;
  if (own.name == "coulomb_friction") {
    take(figures.smallest_command_m_s, figure(0, to_command), false);
    take(limits.friction_loss_m_s, figure(0, same), false);
  }
  if (own.name == "stiction") {
    const double sliding = own.parameters[1];
    take(figures.smallest_command_m_s, figure(0, [&](double excess) { return to_command(excess + sliding); }),
         false);
    take(limits.friction_loss_m_s, figure(1, same), false);
  }
}

}  // namespace

std::string source_of(const RobotModel& model, const AddedEffect& effect) {
  const std::string& date = effect.created.empty() ? model.created : effect.created;
  return full_name(effect.setting) + (date.empty() ? "" : " of " + config::printable(date));
}

std::string linear_part(const RobotModel& model) {
  return "the linear part" + (model.created.empty() ? "" : " of " + config::printable(model.created));
}

DriveFigures drive_figures(const RobotModel& model) {
  DriveFigures figures;
  figures.wheel_separation_m = model.linear_part.wheel_base_m;
  figures.separation_multiplier.value = 1.0;
  figures.left_radius_multiplier.value = 1.0;
  figures.right_radius_multiplier.value = 1.0;
  figures.gain = {dc_gain(model.linear_part.left).from_left, dc_gain(model.linear_part.right).from_right};
  figures.left_gain = gain_figure(figures.gain.left, model.left_fit, &DcGain::from_left,
                                  "left gain of " + linear_part(model));
  figures.right_gain = gain_figure(figures.gain.right, model.right_fit, &DcGain::from_right,
                                   "right gain of " + linear_part(model));
  figures.left_response = first_order_response(model.linear_part, true);
  figures.right_response = first_order_response(model.linear_part, false);
  for (const AddedEffect& effect : model.effects) {
    add_scale(model, effect, figures);
    for (const WheelSide wheel : {WheelSide::left, WheelSide::right})
      add_limit(model, effect, wheel, figures);
  }
  return figures;
}

std::string value_of(const Figure& figure) {
  return nine_digits(figure.value);
}

std::string remark_of(const Figure& figure) {
  if (figure.from.empty()) return "no effect of the model changes it";
  if (!figure.interval) return "no interval; " + figure.from;
  return "95 % interval " + nine_digits(figure.interval->lower) + " to " +
         nine_digits(figure.interval->upper) + "; " + figure.from;
}

Figure shifted(Figure figure, double by) {
  figure.value += by;
  if (figure.interval) figure.interval = {figure.interval->lower + by, figure.interval->upper + by};
  return figure;
}

Figure mean_of(const Figure& one, const Figure& other) {
  Figure mean{0.5 * (one.value + other.value), {}, one.from};
  if (other.from != one.from) mean.from += (one.from.empty() || other.from.empty() ? "" : ", ") + other.from;
  if (!one.interval && !other.interval) return mean;
  const ParameterInterval first = one.interval.value_or(ParameterInterval{one.value, one.value});
  const ParameterInterval second = other.interval.value_or(ParameterInterval{other.value, other.value});
  mean.interval = {0.5 * (first.lower + second.lower), 0.5 * (first.upper + second.upper)};
  return mean;
}

Figure scaled(const Figure& figure, double factor) {
  Figure result{figure.value * factor, {}, figure.from};
  if (figure.interval) {
    const auto [lower, upper] =
        std::minmax({figure.interval->lower * factor, figure.interval->upper * factor});
    result.interval = {lower, upper};
  }
  return result;
}

Figure divided_by(double constant, const Figure& figure) {
  Figure result{constant / figure.value, {}, figure.from};
  if (figure.interval)
    result.interval = {constant / figure.interval->upper, constant / figure.interval->lower};
  return result;
}

std::vector<Unsaid> unsaid_of(const RobotModel& model, std::span<const std::string_view> put,
                              std::span<const UnsaidReason> reasons) {
  std::vector<Unsaid> unsaid;
  for (const AddedEffect& effect : model.effects) {
    const std::string& name = effect.setting.name;
    if (is_made_up_for(effect)) {
      unsaid.push_back(
          {full_name(effect.setting),
           "a controller of the wheels' speed makes up for it; there is no such controller there"});
      continue;
    }
    if (std::ranges::find(put, name) != put.end()) continue;
    const auto known = std::ranges::find(reasons, name, &UnsaidReason::effect);
    unsaid.push_back({full_name(effect.setting), known == reasons.end()
                                                     ? "nobody has found a place for it there yet"
                                                     : std::string(known->reason)});
  }
  return unsaid;
}

}  // namespace wheelwright::tools
