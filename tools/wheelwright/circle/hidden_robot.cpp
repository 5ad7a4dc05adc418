#include "tools/wheelwright/circle/hidden_robot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

#include "config/load/text_format.hpp"
#include "drivers/simulation/noise.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using simulation::Noise;

// What is put together in the files: keys of sections, one after the other.
struct Parts {
  std::map<std::string, std::string> sections;
  std::string floor = "grip: 0";

  void add(const std::string& section, const std::string& keys) {
    std::string& text = sections[section];
    text += (text.empty() ? "" : ", ") + keys;
  }
};

double between(double low, double high, Noise& chance) {
  return low + (high - low) * chance.uniform();
}

double either_sign(double size, Noise& chance) {
  return chance.uniform() < 0.5 ? -size : size;
}

Imperfection unequal_wheels(Parts& parts, Noise& chance) {
  const double share = either_sign(between(0.005, 0.03, chance), chance);
  parts.add("left", "diameter_m: " + fixed_number(0.072 * (1.0 - 0.5 * share), 5));
  parts.add("right", "diameter_m: " + fixed_number(0.072 * (1.0 + 0.5 * share), 5));
  return {"right wheel " + fixed_number(100.0 * share, 2) + " % larger than the left",
          {"wheel_scale_mismatch"}};
}

Imperfection other_wheel_base(Parts& parts, Noise& chance) {
  const double share = either_sign(between(0.01, 0.04, chance), chance);
  parts.add("chassis", "wheel_base_m: " + fixed_number(0.235 * (1.0 + share), 5));
  // Metres per tick are calibrated by turning on the given wheel base, and so are wrong by the same share.
  return {"wheel base " + fixed_number(100.0 * share, 2) + " % from the given one",
          {"effective_track", "distance_scale"}};
}

Imperfection friction(Parts& parts, Noise& chance) {
  const std::string torque = fixed_number(between(0.04, 0.12, chance), 4);
  parts.add("wheels", "friction: { coulomb_nm: " + torque + ", stiction_nm: " + torque + " }");
  return {"dry friction of " + torque + " Nm per wheel", {"coulomb_friction"}};
}

Imperfection backlash(Parts& parts, Noise& chance) {
  const double play_rad = between(0.03, 0.12, chance);
  parts.add("wheels", "backlash_rad: " + fixed_number(play_rad, 4));
  return {"gear play of " + fixed_number(36.0 * play_rad, 2) + " mm at the wheel's rim", {"backlash"}};
}

Imperfection slow_motors(Parts& parts, Noise& chance) {
  const std::string limit = fixed_number(between(0.15, 0.22, chance), 3);
  parts.add("firmware", "speed_limit_m_s: " + limit);
  return {"no wheel faster than " + limit + " m/s", {"saturation"}};
}

Imperfection coasting(Parts& parts, Noise& /*chance*/) {
  parts.add("wheels", "motor: { bridge_can_brake: false }");
  return {"motors that cannot brake", {"asymmetric_response"}};
}

Imperfection caster(Parts& parts, Noise& chance) {
  const std::string torque = fixed_number(between(0.03, 0.12, chance), 3);
  parts.add("chassis", "caster: { swivel_torque_nm: " + torque + " }");
  return {"a caster that takes " + torque + " Nm to turn over", {"caster_kick"}};
}

Imperfection slope(Parts& parts, Noise& chance) {
  const double angle_rad = 2.0 * std::numbers::pi * chance.uniform();
  const double rise = between(0.02, 0.06, chance);
  parts.floor += ", slope_x: " + fixed_number(rise * std::cos(angle_rad), 4) +
                 ", slope_y: " + fixed_number(rise * std::sin(angle_rad), 4);
  return {"a floor that rises " + fixed_number(100.0 * rise, 1) + " cm per metre", {"floor_slope"}};
}

Imperfection scrubbing(Parts& parts, Noise& chance) {
  const std::string torque = fixed_number(between(0.1, 0.3, chance), 3);
  parts.floor = "grip: 0.6, creep_per_n: 0.006" + parts.floor.substr(std::string("grip: 0").size());
  parts.add("chassis", "yaw_scrub_nm: " + torque);
  return {"wide tyres on carpet: " + torque + " Nm against turning, with slip",
          {"turn_scrub", "effective_track", "coulomb_friction"}};
}

Imperfection speed_steps(Parts& parts, Noise& /*chance*/) {
  parts.add("firmware", "staircase: true, tick_s: 0.015625, command_delay_ticks: 2");
  return {"firmware that knows speeds in steps of 28.5 mm/s only", {"command_quantization"}};
}

struct Pick {
  std::string_view name;
  Imperfection (*put_into)(Parts&, Noise&);
};
constexpr std::array<Pick, 10> picks{{{"unequal_wheels", unequal_wheels},
                                      {"other_wheel_base", other_wheel_base},
                                      {"friction", friction},
                                      {"backlash", backlash},
                                      {"slow_motors", slow_motors},
                                      {"coasting", coasting},
                                      {"caster", caster},
                                      {"slope", slope},
                                      {"scrubbing", scrubbing},
                                      {"speed_steps", speed_steps}}};

constexpr std::string_view nothing = "nothing";

// A robot that no friction holds on a slope rolls away before it drives.
void hold_on_slope(std::vector<Pick>& chosen) {
  const auto has = [&](std::string_view name) {
    return std::ranges::find(chosen, name, &Pick::name) != chosen.end();
  };
  if (has("slope") && !has("friction")) chosen.push_back(*std::ranges::find(picks, "friction", &Pick::name));
}

std::vector<Pick> picked_by_chance(Noise& chance) {
  std::array<Pick, picks.size()> order = picks;
  for (std::size_t i = order.size() - 1; i > 0; --i)
    std::swap(order.at(i), order.at(chance.bits() % (i + 1)));
  constexpr std::size_t most = 3;
  const std::size_t count = 1 + chance.bits() % most;
  std::vector<Pick> chosen(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  hold_on_slope(chosen);
  if (chosen.size() > most)
    chosen.erase(std::ranges::find_if(chosen, [](const Pick& pick) { return pick.name != "slope"; }));
  return chosen;
}

std::vector<Pick> picked_by_name(const std::vector<std::string>& names) {
  std::vector<Pick> chosen;
  for (const auto& name : names) {
    if (name != nothing) chosen.push_back(*std::ranges::find(picks, name, &Pick::name));
  }
  hold_on_slope(chosen);
  return chosen;
}

std::string robot_text(const Parts& parts, const std::vector<Imperfection>& imperfections,
                       const std::filesystem::path& base, const std::string& room_file) {
  std::string text = "# Sealed. What is hidden in this robot:\n";
  for (const auto& imperfection : imperfections) text += "#   " + imperfection.what + "\n";
  text += "based_on: " + base.string() + "\nname: hidden\n";
  for (const auto& [section, keys] : parts.sections) text += section + ": { " + keys + " }\n";
  return text + "room: " + room_file + "\n";
}

// The object behind the start is what the robot sees while it turns to calibrate its encoders.
std::string room_text(const Parts& parts) {
  return "floor: { " + parts.floor +
         " }\n"
         "walls_m: [[-4, -4, 4, -4], [4, -4, 4, 4], [4, 4, -4, 4], [-4, 4, -4, -4]]\n"
         "obstacles:\n"
         "  - { x_m: -0.46, y_m: 0.03, size_x_m: 0.18, size_y_m: 0.26, angle_rad: 0.15 }\n";
}

}  // namespace

std::vector<std::string> imperfection_names() {
  std::vector<std::string> names{std::string(nothing)};
  for (const Pick& pick : picks) names.emplace_back(pick.name);
  return names;
}

HiddenRobot pick_hidden_robot(std::uint64_t seed, const std::vector<std::string>& names,
                              const std::filesystem::path& base, const std::string& room_file) {
  Noise chance(seed);
  const std::vector<Pick> chosen = names.empty() ? picked_by_chance(chance) : picked_by_name(names);
  Parts parts;
  HiddenRobot hidden;
  for (const Pick& pick : chosen) hidden.imperfections.push_back(pick.put_into(parts, chance));
  hidden.robot_yaml = robot_text(parts, hidden.imperfections, base, room_file);
  hidden.room_yaml = room_text(parts);
  return hidden;
}

}  // namespace wheelwright::tools
