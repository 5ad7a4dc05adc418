#include "tests/benchmark/third_plant/case_builder.hpp"

#include <algorithm>
#include <utility>

#include "tests/benchmark/plants/effect_table.hpp"

namespace plants::third {

namespace {

DriveHabits random_habits(Random& random) {
  DriveHabits habits;
  habits.room_x_m = random.uniform(-1.5, 1.5);
  habits.room_y_m = random.uniform(-1.5, 1.5);
  habits.room_radius_m = random.uniform(1.0, 1.4);
  habits.slow_m_s = random.uniform(0.06, 0.1);
  habits.slow_share = random.uniform(0.12, 0.25);
  return habits;
}

double random_reference_hz(bool beside_ticks, Random& random) {
  const std::vector<double> rates_hz =
      beside_ticks ? std::vector{2.0, 5.0, 10.0, 20.0, 60.0} : std::vector{10.0, 20.0, 60.0};
  return rates_hz[static_cast<std::size_t>(random.integer(0, static_cast<int>(rates_hz.size()) - 1))];
}

}  // namespace

void CaseBuilder::begin(CaseKind kind, const std::string& subject, const Showing& showing,
                        Response response) {
  random_ = Random(seed_).child(begun_++);
  item_ = Case{};
  item_.subject = subject;
  item_.kind = kind;
  item_.size = "large";
  item_.seed = random_.bits();
  item_.robot = random_robot(showing.loop, response, random_);
  item_.innocent = item_.robot;
  item_.sensing = showing.sensing;
  item_.sensors = sensor_set(showing.sensing);
  item_.sensors.position_noise_m = random_.uniform(0.001, 0.002);
  item_.sensors.heading_noise_rad = random_.uniform(0.002, 0.004);
  item_.style = showing.style;
  item_.habits = random_habits(random_);
  item_.limits.wheel_base_m = item_.robot.wheel_base_m;
  item_.limits.fastest_m_s = item_.robot.fastest_m_s;
  item_.limits.fastest_turn_rad_s = item_.robot.fastest_turn_rad_s;
}

void CaseBuilder::hide(const Effect& effect, bool large, bool alone) {
  Setting setting{item_.robot, item_.sensors, item_.habits, random_, large, alone};
  const std::string how = effect.apply(setting);
  item_.hidden.push_back({effect.name, how, (large ? effect.large : effect.small).confusable});
  // How stiff a loop an effect is hidden behind is no part of the effect.
  item_.innocent.controller = item_.robot.controller;
}

Case CaseBuilder::finish(double min_reference_hz) {
  SensorSet& sensors = item_.sensors;
  if (sensors.poses && !sensors.only_end_poses)
    sensors.pose_every_s = 1.0 / std::max(random_reference_hz(sensors.ticks, random_), min_reference_hz);
  return std::exchange(item_, {});
}

Case CaseBuilder::single(const Effect& effect, bool large) {
  begin(CaseKind::effects, effect.name, large ? effect.large : effect.small, effect.response);
  hide(effect, large, true);
  if (!large) {
    // Coarse ticks would drown it.
    constexpr double coarsest_m = 6.0e-4;
    item_.size = "small";
    double& metres_per_tick = item_.robot.encoder.metres_per_tick;
    if (item_.sensors.ticks) metres_per_tick = std::min(metres_per_tick, coarsest_m);
  }
  return finish(effect.min_reference_hz);
}

Case CaseBuilder::several(const std::vector<Effect>& effects, const std::vector<std::string>& names,
                          Sensing sensing, Style style) {
  const std::vector<const Effect*> chosen = find_effects(effects, names);
  Response response = Response::any;
  double min_reference_hz = 0.0;
  for (const Effect* effect : chosen) {
    if (effect->response != Response::any) response = effect->response;
    min_reference_hz = std::max(min_reference_hz, effect->min_reference_hz);
  }
  begin(CaseKind::effects, "several", {sensing, style, Loop::open}, response);
  for (const Effect* effect : chosen) {
    item_.subject += "." + effect->name;
    hide(*effect, true, false);
  }
  return finish(min_reference_hz);
}

Case CaseBuilder::clean(Sensing sensing, Style style) {
  constexpr double battery_share = 0.35;
  begin(CaseKind::clean, "clean", {sensing, style}, Response::any);
  item_.size = "";
  item_.sensors.battery = random_.chance(battery_share);
  return finish(0.0);
}

Case CaseBuilder::cannot_tell(const Effect& effect, Sensing sensing, Style style, Loop loop) {
  begin(CaseKind::cannot_tell, "cannot_tell." + effect.name, {sensing, style, loop}, effect.response);
  hide(effect, true, true);
  item_.hidden.front().confusable = "";
  return finish(effect.min_reference_hz);
}

Case CaseBuilder::outside(const Effect& effect) {
  begin(CaseKind::outside, "outside." + effect.name, effect.large, effect.response);
  hide(effect, true, true);
  item_.hidden.front().name = "outside_" + effect.name;
  return finish(effect.min_reference_hz);
}

}  // namespace plants::third
