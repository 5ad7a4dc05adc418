#include "model/gap/simulation/differences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "model/effects/library/each_wheel_variants.hpp"
#include "model/effects/library/effect_library.hpp"

namespace wheelwright::gap {
namespace {

constexpr double smallest_share = 0.03;  // of a size, by which it has to differ

const Finding* find(const std::vector<Finding>& all, const std::string& effect) {
  const auto found =
      std::ranges::find_if(all, [&](const Finding& one) { return one.setting.name == effect; });
  return found == all.end() ? nullptr : &*found;
}

Known known(const Finding& found, std::size_t parameter) {
  const double value = found.setting.parameters[parameter];
  if (parameter >= found.intervals.size()) return {value, {value, value}};
  return {value, found.intervals[parameter]};
}

bool differ(const Known& simulation, const Known& robot) {
  const double by = robot.value - simulation.value;
  if (std::abs(by) <= smallest_share * std::max(std::abs(robot.value), std::abs(simulation.value)))
    return false;
  // Towards each other.
  const double of_robot = by > 0.0 ? robot.value - robot.interval.lower : robot.interval.upper - robot.value;
  const double of_simulation =
      by > 0.0 ? simulation.interval.upper - simulation.value : simulation.value - simulation.interval.lower;
  return std::abs(by) > std::hypot(of_robot, of_simulation);
}

std::vector<ParameterDifference> parameters_of_one(const Finding& found, bool of_robot) {
  std::vector<ParameterDifference> parameters;
  const auto infos = parameters_of(found.setting);
  for (std::size_t i = 0; i < infos.size(); ++i) {
    ParameterDifference parameter{infos[i].name, infos[i].unit, std::nullopt, std::nullopt, true};
    (of_robot ? parameter.robot : parameter.simulation) = known(found, i);
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

EffectDifference of_one(const Finding& found, bool of_robot, DifferenceKind kind) {
  EffectDifference difference{found.setting.name, kind, "", "", parameters_of_one(found, of_robot)};
  (of_robot ? difference.robot_form : difference.simulation_form) = found.setting.variant;
  return difference;
}

EffectDifference of_both(const Finding& simulation, const Finding& robot) {
  const bool parted = is_of_each_wheel(simulation.setting);
  if (parted != is_of_each_wheel(robot.setting)) {
    return parted ? of_both(simulation, with_size_for_each_wheel(robot))
                  : of_both(with_size_for_each_wheel(simulation), robot);
  }
  EffectDifference difference{simulation.setting.name, DifferenceKind::same, simulation.setting.variant,
                              robot.setting.variant, parameters_of_one(robot, true)};
  const auto of_simulation = parameters_of_one(simulation, false);
  for (ParameterDifference& parameter : difference.parameters) {
    const auto same = std::ranges::find(of_simulation, parameter.name, &ParameterDifference::name);
    if (same == of_simulation.end()) continue;
    parameter.simulation = same->simulation;
    parameter.differs = differ(*parameter.simulation, *parameter.robot);
    if (parameter.differs) difference.kind = DifferenceKind::wrong_size;
  }
  return difference;
}

// Whether the robot's runs would have shown an effect of this size.
bool would_show(const EffectSetting& of_simulation, const GapAnalysis& robot) {
  if (is_of_each_wheel(of_simulation))
    return would_show(as_at(WheelSide::left, of_simulation), robot) ||
           would_show(as_at(WheelSide::right, of_simulation), robot);
  const auto detectable = std::ranges::find(robot.detectable, of_simulation.name, &Detectable::effect);
  if (detectable == robot.detectable.end()) return false;
  const auto infos = parameters_of(of_simulation);
  const auto parameter = std::ranges::find(infos, detectable->parameter, &ParameterInfo::name);
  if (parameter == infos.end()) return false;
  const auto i = static_cast<std::size_t>(parameter - infos.begin());
  const double size = std::abs(of_simulation.parameters[i]);
  const bool grows_with_size = parameter->lower <= 0.0;  // else, as of a limit, the smaller the more of it
  return grows_with_size ? size >= detectable->size : size <= detectable->size;
}

std::string size_text(const ParameterDifference& parameter, const Known& size) {
  std::ostringstream text;
  text << std::setprecision(3) << size.value << (parameter.unit == "1" ? "" : " " + parameter.unit) << " ["
       << size.interval.lower << ", " << size.interval.upper << "]";
  return text.str();
}

// The first that is surely not zero: of a slope across the way, not the part along it.
const ParameterDifference& telling(const EffectDifference& difference) {
  const auto is_sure = [](const ParameterDifference& parameter) {
    const auto& known = parameter.robot ? parameter.robot : parameter.simulation;
    return known && known->interval.lower * known->interval.upper > 0.0;
  };
  const auto sure = std::ranges::find_if(difference.parameters, is_sure);
  return sure == difference.parameters.end() ? difference.parameters.front() : *sure;
}

std::string words_for(const EffectDifference& difference) {
  const ParameterDifference& first = telling(difference);
  switch (difference.kind) {
    case DifferenceKind::missing:
      return "It lacks " + difference.effect + " (" + first.name + " " + size_text(first, *first.robot) +
             ").";
    case DifferenceKind::surplus:
      return "It has " + difference.effect + " (" + first.name + " " + size_text(first, *first.simulation) +
             "), which the robot has not.";
    case DifferenceKind::wrong_size: {
      std::string text = "Its " + difference.effect + " is wrong:";
      for (const auto& parameter : difference.parameters) {
        if (!parameter.differs || !parameter.simulation) continue;
        text += (text.back() == ':' ? " " : "; ") + parameter.name + " " +
                size_text(parameter, *parameter.simulation) + " instead of " +
                size_text(parameter, *parameter.robot);
      }
      return text + ".";
    }
    case DifferenceKind::not_shown:
    case DifferenceKind::same:
      break;
  }
  return "";
}

}  // namespace

std::string_view kind_name(DifferenceKind kind) {
  constexpr std::array<std::string_view, 5> names{"missing", "wrong_size", "surplus", "same", "not_shown"};
  return names.at(static_cast<std::size_t>(kind));
}

namespace {

// Those that the robot's runs do not ask for: what is the same may look like another size of two effects.
void leave_out_needless(std::vector<EffectDifference>& differences, const GapAnalysis& robot) {
  const auto is_needed = [&](const EffectDifference& difference) {
    return std::ranges::find(robot.differing_effects, difference.effect) != robot.differing_effects.end();
  };
  std::erase_if(differences, [&](const EffectDifference& difference) {
    return difference.kind == DifferenceKind::missing && !is_needed(difference);
  });
  for (EffectDifference& difference : differences) {
    if (is_needed(difference)) continue;
    if (difference.kind == DifferenceKind::surplus) difference.kind = DifferenceKind::not_shown;
    if (difference.kind != DifferenceKind::wrong_size) continue;
    difference.kind = DifferenceKind::same;
    for (ParameterDifference& parameter : difference.parameters) parameter.differs = false;
  }
}

}  // namespace

std::vector<EffectDifference> effect_differences(const GapAnalysis& simulation, const GapAnalysis& robot) {
  std::vector<EffectDifference> differences;
  for (const Finding& of_robot : robot.found) {
    const Finding* of_simulation = find(simulation.found, of_robot.setting.name);
    differences.push_back(of_simulation == nullptr ? of_one(of_robot, true, DifferenceKind::missing)
                                                   : of_both(*of_simulation, of_robot));
  }
  for (const Finding& of_simulation : simulation.found) {
    if (find(robot.found, of_simulation.setting.name) != nullptr) continue;
    differences.push_back(of_one(
        of_simulation, false,
        would_show(of_simulation.setting, robot) ? DifferenceKind::surplus : DifferenceKind::not_shown));
  }
  leave_out_needless(differences, robot);
  return differences;
}

std::string in_words(const std::vector<EffectDifference>& differences) {
  std::string text;
  for (const EffectDifference& difference : differences) {
    const std::string words = words_for(difference);
    if (!words.empty()) text += (text.empty() ? "" : " ") + words;
  }
  return text;
}

}  // namespace wheelwright::gap
