#include "tests/benchmark/fourth_plant/case_builder.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plants::fourth {

namespace {

double any_quick_look_s(Random& random) {
  constexpr std::array every_s{0.0, 0.02, 0.05, 0.1};
  return every_s[static_cast<std::size_t>(random.integer(0, static_cast<int>(every_s.size()) - 1))];
}

SensorSet random_sensors(const Showing& showing, Random& random) {
  SensorSet sensors = sensor_set(showing.sensing);
  sensors.position_noise_m = random.uniform(0.001, 0.0025);
  sensors.heading_noise_rad = random.uniform(0.002, 0.004);
  const double every_s = any_quick_look_s(random);
  sensors.pose_every_s = showing.pose_every_s < 0.0 ? every_s : showing.pose_every_s;
  return sensors;
}

}  // namespace

void CaseBuilder::begin(CaseKind kind, const std::string& subject, const Showing& showing) {
  random_ = Random(seed_).child(begun_++);
  item_ = {};
  item_.name = subject;
  item_.kind = kind;
  item_.size = kind == CaseKind::clean ? "" : "large";
  item_.sensing = showing.sensing;
  item_.programme = name_of(showing.programme);
  item_.seed = random_.bits();
  experiment_ = {};
  experiment_.seed = item_.seed;
  experiment_.robot = random_robot(showing.loop, random_);
  experiment_.sensors = random_sensors(showing, random_);
  experiment_.programme = showing.programme;
  experiment_.limits = {experiment_.robot.wheel_base_m, experiment_.robot.top_m_s, random_.uniform(1.8, 3.0)};
  innocent_ = experiment_.robot;
}

void CaseBuilder::hide(const Effect& effect, bool large, const std::string& confusable) {
  const std::string how = effect.hide({experiment_, random_, large});
  item_.hidden.push_back({effect.name, how, confusable});
}

ExamCase CaseBuilder::finish() {
  item_.sensors = experiment_.sensors;
  item_.drive = [experiment = experiment_] { return drive(experiment); };
  experiment_.robot = innocent_;
  // No programme looks at the robot, so the innocent one is given the same commands.
  item_.drive_innocent = [experiment = experiment_](const std::vector<Run>& /*driven*/) {
    return drive(experiment);
  };
  return std::exchange(item_, {});
}

ExamCase CaseBuilder::single(const Effect& effect, bool large) {
  const Showing& showing = large ? effect.large : effect.small;
  begin(CaseKind::effects, effect.name, showing);
  if (!large) {
    // Coarse ticks would drown it.
    constexpr double coarsest_m = 4.0e-4;
    item_.size = "small";
    for (Robot* robot : {&experiment_.robot, &innocent_})
      robot->metres_per_tick = std::min(robot->metres_per_tick, coarsest_m);
  }
  hide(effect, large, showing.confusable);
  return finish();
}

ExamCase CaseBuilder::several(const std::vector<const Effect*>& effects, const Showing& showing) {
  std::string subject = "several";
  for (const Effect* effect : effects) subject += "." + effect->name;
  begin(CaseKind::effects, subject, showing);
  for (const Effect* effect : effects) hide(*effect, true, effect->large.confusable);
  return finish();
}

ExamCase CaseBuilder::clean(const Showing& showing) {
  constexpr double battery_share = 0.3;
  begin(CaseKind::clean, "clean", showing);
  experiment_.sensors.battery = random_.chance(battery_share);
  return finish();
}

ExamCase CaseBuilder::cannot_tell(const Effect& effect, const Showing& showing, double pace) {
  begin(CaseKind::cannot_tell, "cannot_tell." + effect.name, showing);
  experiment_.limits.fastest_m_s *= pace;
  hide(effect, true, "");
  return finish();
}

ExamCase CaseBuilder::outside(const Effect& effect) {
  begin(CaseKind::outside, "outside." + effect.name, effect.large);
  hide(effect, true, "");
  item_.hidden.front().name = "outside_" + effect.name;
  return finish();
}

}  // namespace plants::fourth
