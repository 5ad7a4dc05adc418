#include "tests/benchmark/second_plant/case_builder.hpp"

#include <algorithm>

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::second {

namespace {

SensorSet random_sensors(Sensing sensing, bool dense_poses, Random& random) {
  SensorSet sensors = sensor_set(sensing);
  sensors.battery = random.chance(0.4);
  const double sparse_s = random.uniform(0.1, sensors.ticks ? 0.5 : 0.15);
  sensors.pose_every_s = dense_poses || random.chance(0.4) ? 0.0 : sparse_s;
  sensors.position_noise_m = random.uniform(0.001, 0.003);
  sensors.heading_noise_rad = random.uniform(0.001, 0.004);
  return sensors;
}

// A mixture runs on soft wheels if one member needs loads to show.
Drive common_drive(const std::vector<const Effect*>& effects) {
  Drive drive = Drive::any;
  for (const Effect* effect : effects) {
    if (effect->drive == Drive::soft) return Drive::soft;
    if (effect->drive == Drive::stiff) drive = Drive::stiff;
  }
  return drive;
}

bool logs_volts(const std::string& effect) {
  return effect == "voltage_sag";
}

}  // namespace

Case CaseBuilder::draw(CaseKind kind, Drive drive, Sensing sensing, bool dense_poses) {
  random_ = Random(seed_).child(drawn_++);
  Case item;
  item.kind = kind;
  item.seed = random_.bits();
  item.robot = random_robot(drive, random_);
  item.innocent = item.robot;
  item.sensors = random_sensors(sensing, dense_poses, random_);
  item.sensing = sensing;
  item.duration_s = random_.uniform(62.0, 88.0);
  return item;
}

// Takes turns over the seeds.
Sensing CaseBuilder::choose(const std::vector<Sensing>& possible) const {
  return possible[seed_ % possible.size()];
}

Case CaseBuilder::single(const Effect& effect, double level) {
  const bool large = level >= large_level;
  const Sensing sensing = choose(large ? effect.large_sensing : effect.small_sensing);
  Case item = draw(CaseKind::effects, effect.drive, sensing, effect.needs_dense_poses);
  item.name = effect.name;
  item.hidden = {effect.name};
  item.size = large ? "large" : "small";
  item.note = effect.physics;
  effect.apply(item.robot, level, random_);
  item.sensors.battery |= logs_volts(effect.name);
  return item;
}

Case CaseBuilder::several(const std::vector<Effect>& effects, const std::vector<std::string>& names,
                          Sensing sensing) {
  const std::vector<const Effect*> chosen = find_effects(effects, names);
  const bool dense = std::any_of(chosen.begin(), chosen.end(),
                                 [](const Effect* effect) { return effect->needs_dense_poses; });
  Case item = draw(CaseKind::effects, common_drive(chosen), sensing, dense);
  item.hidden = names;
  item.name = "several";
  for (const Effect* effect : chosen) {
    effect->apply(item.robot, medium_level, random_);
    item.sensors.battery |= logs_volts(effect->name);
    item.name += "." + effect->name;
    item.note += (item.note.empty() ? "" : "; ") + effect->physics;
  }
  return item;
}

Case CaseBuilder::clean(Sensing sensing) {
  Case item = draw(CaseKind::clean, Drive::any, sensing, false);
  item.name = "clean";
  // Endless voltage must change nothing, or the robot would not be linear.
  item.innocent.motor.supply_v *= 10.0;
  item.note = "linear motor, controller, gear and tyre; quantised ticks, noise, jitter, delay";
  return item;
}

Case CaseBuilder::cannot_tell(const Effect& effect, Sensing sensing, Style style, const std::string& why) {
  Case item = draw(CaseKind::cannot_tell, effect.drive, sensing, effect.needs_dense_poses);
  item.name = "cannot_tell." + effect.name;
  item.hidden = {effect.name};
  item.note = why;
  item.style = style;
  effect.apply(item.robot, large_level, random_);
  item.sensors.battery = false;
  return item;
}

Case CaseBuilder::outside(const Effect& effect) {
  Case item = draw(CaseKind::outside, effect.drive, effect.large_sensing.front(), true);
  item.name = "outside." + effect.name;
  item.hidden = {"outside_" + effect.name};
  item.note = effect.physics;
  effect.apply(item.robot, large_level, random_);
  return item;
}

}  // namespace plants::second
