#include "tools/wheelwright/export/ranges.hpp"

#include <algorithm>

#include "config/load/text_format.hpp"
#include "model/effects/library/effect_library.hpp"
#include "tools/wheelwright/export/c/placed_effects.hpp"

namespace wheelwright::tools {
namespace {

std::string name_of(Part part) {
  switch (part) {
    case Part::left_joint:
      return "joint left_wheel_joint";
    case Part::right_joint:
      return "joint right_wheel_joint";
    case Part::left_actuator:
      return "actuator left_wheel";
    case Part::right_actuator:
      return "actuator right_wheel";
    case Part::left_wheel:
      return "left wheel";
    case Part::right_wheel:
      return "right wheel";
    case Part::drive_plugin:
      return "DiffDrive";
    case Part::controller:
      return "diff_drive_controller";
    case Part::smoother:
      return "velocity_smoother";
  }
  return "";
}

std::string unit_of(const PlacedNumber& number, std::size_t element) {
  std::string unit = number.unit;
  for (std::size_t i = 0; i < element && unit.find(',') != std::string::npos; ++i)
    unit.erase(0, unit.find(',') + 1);
  return unit.substr(0, unit.find(','));
}

std::string line(const ParameterRange& range) {
  const auto& interval = *range.figure.interval;
  return "  - {place: " + config::quoted(range.place) +
         ", value: " + config::plain_number(range.figure.value) +
         ", lower: " + config::plain_number(std::min(interval.lower, interval.upper)) +
         ", upper: " + config::plain_number(std::max(interval.lower, interval.upper)) +
         ", unit: " + config::quoted(range.unit) + ", from: " + config::quoted(range.figure.from) + "}\n";
}

}  // namespace

std::vector<ParameterRange> ranges_of(const std::vector<PlacedNumber>& numbers) {
  std::vector<ParameterRange> ranges;
  for (const PlacedNumber& number : numbers) {
    for (std::size_t i = 0; i < number.figures.size(); ++i) {
      if (!number.figures[i].interval) continue;
      std::string place = name_of(number.part) + " " + number.key;
      if (number.at || number.figures.size() > 1) place += "[" + std::to_string(number.at.value_or(i)) + "]";
      ranges.push_back({std::move(place), number.figures[i], unit_of(number, i)});
    }
  }
  return ranges;
}

std::vector<ParameterRange> c_ranges(const RobotModel& model) {
  std::vector<ParameterRange> ranges;
  for (const PlacedEffect& placed : place_effects(model).placed) {
    const AddedEffect* effect = placed.effect;
    const auto parameters = parameters_of(effect->setting);
    for (std::size_t i = 0; i < placed.places.size(); ++i) {
      const std::size_t place = placed.places[i];
      if (place >= effect->intervals.size()) continue;
      ranges.push_back({placed.numbers + "[" + std::to_string(i) + "]",
                        {effect->setting.parameters[place], effect->intervals[place],
                         source_of(model, *effect) + ", " + parameters[place].name},
                        parameters[place].unit});
    }
  }
  return ranges;
}

std::string ranges_to_yaml(const RobotModel& model, const std::string& format,
                           const std::vector<ParameterRange>& ranges, const std::vector<Unsaid>& unsaid) {
  std::string text = "# " + origin_of(model) +
                     "\n# 95 % intervals of the numbers that `wheelwright export --to " + format +
                     "` writes, to draw from. Numbers of one effect\n"
                     "# change together: draw once for each text in `from`.\n";
  for (const auto& [effect, reason] : unsaid)
    text += "# " + effect + ": cannot be said in this format: " + reason + "\n";
  text += "wheelwright_ranges: 1\nformat: " + format + "\nparameters:" + (ranges.empty() ? " []" : "") + "\n";
  for (const ParameterRange& range : ranges) text += line(range);
  return text;
}

}  // namespace wheelwright::tools
