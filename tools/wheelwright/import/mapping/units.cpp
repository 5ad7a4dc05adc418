#include "tools/wheelwright/import/mapping/units.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "config/load/ascii_text.hpp"

namespace wheelwright::import {
namespace {

using std::numbers::pi;
using Spelling = std::pair<std::string_view, std::string_view>;

constexpr double inch_m = 0.0254;
constexpr double foot_m = 0.3048;

// So near to another that motion does not show which it is, or of another system of units.
constexpr Unit stated(std::string_view name, double in_si) {
  return {name, in_si, false, false, true};
}

constexpr Unit raw_speed(std::string_view name, double in_si) {
  return {name, in_si, true, false, false, true};
}

constexpr std::array speed_table{Unit{"m/s", 1.0},
                                 Unit{"mm/s", 1e-3},
                                 Unit{"cm/s", 1e-2},
                                 Unit{"km/h", 1.0 / 3.6},
                                 stated("ft/s", foot_m),
                                 stated("inch/s", inch_m),
                                 stated("mph", 1609.344 / 3600.0),
                                 stated("dm/s", 0.1),
                                 stated("m/min", 1.0 / 60.0),
                                 Unit{"rad/s", 1.0, true},
                                 Unit{"deg/s", pi / 180.0, true},
                                 Unit{"rpm", pi / 30.0, true},
                                 Unit{"turn/s", 2.0 * pi, true},
                                 Unit{"counts/s", 1.0, false, true},
                                 raw_speed("0.229rpm", 0.229 * pi / 30.0)};
constexpr std::array angular_table{Unit{"rad/s", 1.0}, Unit{"deg/s", pi / 180.0}, Unit{"rpm", pi / 30.0},
                                   Unit{"mrad/s", 1e-3}};
constexpr std::array distance_table{Unit{"m", 1.0},    Unit{"mm", 1e-3},          Unit{"cm", 1e-2},
                                    Unit{"km", 1e3},   stated("ft", foot_m),      stated("inch", inch_m),
                                    stated("dm", 0.1), stated("yd", 3.0 * foot_m)};
constexpr std::array angle_table{
    Unit{"rad", 1.0},   Unit{"deg", pi / 180.0},     Unit{"turn", 2.0 * pi},
    Unit{"mrad", 1e-3}, Unit{"0.1deg", pi / 1800.0}, Unit{"0.01deg", pi / 18000.0}};
constexpr std::array voltage_table{Unit{"V", 1.0}, Unit{"mV", 1e-3}};

// Lower case, without blanks; how a unit is written beside its standard form.
constexpr std::array<Spelling, 137> spellings{{{"m/s", "m/s"},
                                               {"rotation", "turn"},
                                               {"rotations", "turn"},
                                               {"revs", "turn"},
                                               {"rotation/s", "turn/s"},
                                               {"rotations/s", "turn/s"},
                                               {"turns/s", "turn/s"},
                                               {"revs/s", "turn/s"},
                                               {"rev_s", "turn/s"},
                                               {"turn_s", "turn/s"},
                                               {"turns_s", "turn/s"},
                                               {"rotations_s", "turn/s"},
                                               {"rotationspersecond", "turn/s"},
                                               {"rotations_per_second", "turn/s"},
                                               {"rev_per_s", "turn/s"},
                                               {"turns_per_s", "turn/s"},
                                               {"ips", "inch/s"},
                                               {"in_s", "inch/s"},
                                               {"tps", "counts/s"},
                                               {"sps", "counts/s"},
                                               {"steps/s", "counts/s"},
                                               {"0.1deg", "0.1deg"},
                                               {"ddeg", "0.1deg"},
                                               {"decideg", "0.1deg"},
                                               {"decidegrees", "0.1deg"},
                                               {"0.01deg", "0.01deg"},
                                               {"cdeg", "0.01deg"},
                                               {"centideg", "0.01deg"},
                                               {"centidegrees", "0.01deg"},
                                               {"mph", "mph"},
                                               {"mi/h", "mph"},
                                               {"dm/s", "dm/s"},
                                               {"m/min", "m/min"},
                                               {"dm", "dm"},
                                               {"yd", "yd"},
                                               {"yards", "yd"},
                                               {"feetpersecond", "ft/s"},
                                               {"meterspersecond", "m/s"},
                                               {"degreespersecond", "deg/s"},
                                               {"counts/s", "counts/s"},
                                               {"count/s", "counts/s"},
                                               {"counts_per_s", "counts/s"},
                                               {"counts_per_sec", "counts/s"},
                                               {"counts_s", "counts/s"},
                                               {"cps", "counts/s"},
                                               {"ticks/s", "counts/s"},
                                               {"tick/s", "counts/s"},
                                               {"ticks_per_s", "counts/s"},
                                               {"ticks_per_sec", "counts/s"},
                                               {"ticks_s", "counts/s"},
                                               {"pulses/s", "counts/s"},
                                               {"qpps", "counts/s"},
                                               {"mps", "m/s"},
                                               {"m_s", "m/s"},
                                               {"m_per_s", "m/s"},
                                               {"ms-1", "m/s"},
                                               {"m*s^-1", "m/s"},
                                               {"mm/s", "mm/s"},
                                               {"mmps", "mm/s"},
                                               {"mm_s", "mm/s"},
                                               {"mm_per_s", "mm/s"},
                                               {"cm/s", "cm/s"},
                                               {"cmps", "cm/s"},
                                               {"cm_s", "cm/s"},
                                               {"cm_per_s", "cm/s"},
                                               {"km/h", "km/h"},
                                               {"kmh", "km/h"},
                                               {"kph", "km/h"},
                                               {"rad/s", "rad/s"},
                                               {"radps", "rad/s"},
                                               {"rad_s", "rad/s"},
                                               {"rad_per_s", "rad/s"},
                                               {"rad/sec", "rad/s"},
                                               {"m/sec", "m/s"},
                                               {"deg/s", "deg/s"},
                                               {"degps", "deg/s"},
                                               {"dps", "deg/s"},
                                               {"deg_s", "deg/s"},
                                               {"deg_per_s", "deg/s"},
                                               {"°/s", "deg/s"},
                                               {"mrad/s", "mrad/s"},
                                               {"rpm", "rpm"},
                                               {"rev/min", "rpm"},
                                               {"rps", "turn/s"},
                                               {"rev/s", "turn/s"},
                                               {"turn/s", "turn/s"},
                                               {"m", "m"},
                                               {"meter", "m"},
                                               {"meters", "m"},
                                               {"metre", "m"},
                                               {"metres", "m"},
                                               {"mm", "mm"},
                                               {"millimeters", "mm"},
                                               {"cm", "cm"},
                                               {"km", "km"},
                                               {"ft", "ft"},
                                               {"foot", "ft"},
                                               {"feet", "ft"},
                                               {"inch", "inch"},
                                               {"inches", "inch"},
                                               {"ft/s", "ft/s"},
                                               {"ft/sec", "ft/s"},
                                               {"ft_s", "ft/s"},
                                               {"ft_per_s", "ft/s"},
                                               {"ft_per_sec", "ft/s"},
                                               {"feet/s", "ft/s"},
                                               {"feet_per_second", "ft/s"},
                                               {"inch/s", "inch/s"},
                                               {"in/s", "inch/s"},
                                               {"inches/s", "inch/s"},
                                               {"in_per_s", "inch/s"},
                                               {"inches_per_second", "inch/s"},
                                               {"rad", "rad"},
                                               {"radian", "rad"},
                                               {"radians", "rad"},
                                               {"mrad", "mrad"},
                                               {"deg", "deg"},
                                               {"degree", "deg"},
                                               {"degrees", "deg"},
                                               {"°", "deg"},
                                               {"rev", "turn"},
                                               {"turn", "turn"},
                                               {"turns", "turn"},
                                               {"revolutions", "turn"},
                                               {"v", "V"},
                                               {"volt", "V"},
                                               {"volts", "V"},
                                               {"mv", "mV"},
                                               {"millivolts", "mV"},
                                               {"km/hr", "km/h"},
                                               {"millimetres", "mm"},
                                               {"centimeters", "cm"},
                                               {"centimetres", "cm"},
                                               {"px", "px"},
                                               {"pixel", "px"},
                                               {"pixels", "px"},
                                               {"0.229rpm", "0.229rpm"}}};

std::string lower_without_blanks(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ') result += config::to_lower(c);
  }
  return result;
}

}  // namespace

std::span<const Unit> speed_units() {
  return speed_table;
}
std::span<const Unit> angular_units() {
  return angular_table;
}
std::span<const Unit> distance_units() {
  return distance_table;
}
std::span<const Unit> angle_units() {
  return angle_table;
}
std::span<const Unit> voltage_units() {
  return voltage_table;
}

std::string_view unit_by_spelling(std::string_view spelling) {
  std::string wanted = lower_without_blanks(spelling);
  for (const std::string_view second : {"/seconds", "/second", "/sec"}) {
    if (wanted.ends_with(second)) wanted.replace(wanted.size() - second.size(), second.size(), "/s");
  }
  const auto* at = std::ranges::find(spellings, wanted, &Spelling::first);
  return at == spellings.end() ? std::string_view() : at->second;
}

std::optional<Unit> find_unit(std::span<const Unit> units, std::string_view name) {
  const std::string_view standard = unit_by_spelling(name);
  const auto at = std::ranges::find_if(
      units, [&](const Unit& unit) { return unit.name == standard && !standard.empty(); });
  return at == units.end() ? std::nullopt : std::optional(*at);
}

double in_si(std::span<const Unit> units, std::string_view name) {
  const auto unit = find_unit(units, name);
  return unit ? unit->in_si : 1.0;
}

}  // namespace wheelwright::import
