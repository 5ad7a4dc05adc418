#include "tests/benchmark/fifth_plant/case_builder.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plants::fifth {

namespace {

SensorSet random_sensors(const Showing& showing, const Robot& robot, Random& random) {
  constexpr std::array quick_s{0.0, 0.0, 0.05, 0.1};
  SensorSet sensors = sensor_set(showing.sensing);
  // Smoothing leaves less of the white noise.
  const double white = robot.tracker.smoothing_s > 0.0 ? 0.5 : 1.0;
  sensors.position_noise_m = white * random.uniform(0.0008, 0.002);
  sensors.heading_noise_rad = white * random.uniform(0.0015, 0.004);
  const double every_s =
      quick_s[static_cast<std::size_t>(random.integer(0, static_cast<int>(quick_s.size()) - 1))];
  sensors.pose_every_s = showing.pose_every_s < 0.0 ? every_s : showing.pose_every_s;
  return sensors;
}

}  // namespace

void CaseBuilder::begin(CaseKind kind, const std::string& subject, const Showing& showing) {
  random_ = Random(seed_).child(begun_++);
  built_ = {};
  ExamCase& exam = built_.exam;
  exam.name = subject;
  exam.kind = kind;
  exam.size = kind == CaseKind::clean ? "" : "large";
  exam.sensing = showing.sensing;
  exam.programme = name_of(showing.programme);
  exam.seed = random_.bits();
  Experiment& experiment = built_.hidden;
  experiment.seed = experiment.noise_seed = exam.seed;
  experiment.robot = random_robot(showing.drive, random_);
  if (showing.prepare != nullptr) showing.prepare(experiment.robot);
  experiment.sensors = random_sensors(showing, experiment.robot, random_);
  experiment.programme = showing.programme;
  experiment.style = {experiment.robot.wheel_base_m, experiment.robot.top_m_s, random_.uniform(0.9, 1.6),
                      random_.uniform(0.6, 1.3)};
  built_.innocent = experiment;
}

void CaseBuilder::hide(const Effect& effect, bool large, const std::string& confusable) {
  const std::string how = effect.hide({built_.hidden, random_, large});
  built_.exam.hidden.push_back({effect.name, how, confusable});
  built_.hidden.sensors.battery = built_.hidden.sensors.battery || effect.name == "voltage_sag";
}

BuiltCase CaseBuilder::finish() {
  built_.innocent.sensors = built_.hidden.sensors;
  built_.exam.sensors = built_.hidden.sensors;
  built_.exam.drive = [experiment = built_.hidden] { return drive(experiment); };
  built_.exam.drive_innocent = [experiment = built_.innocent](const std::vector<Run>& driven) {
    return drive_again(experiment, driven);
  };
  return std::exchange(built_, {});
}

BuiltCase CaseBuilder::single(const Effect& effect, bool large) {
  const Showing& showing = large ? effect.large : effect.small;
  begin(CaseKind::effects, effect.name, showing);
  if (!large) {
    // Coarse ticks would drown it.
    constexpr double coarsest_m = 3.5e-4;
    built_.exam.size = "small";
    for (Experiment* experiment : {&built_.hidden, &built_.innocent}) {
      double& tick_m = experiment->robot.encoder.metres_per_tick;
      tick_m = std::min(tick_m, coarsest_m);
    }
  }
  hide(effect, large, showing.confusable);
  return finish();
}

BuiltCase CaseBuilder::several(const std::vector<const Effect*>& effects, const Showing& showing) {
  std::string subject = "several";
  for (const Effect* effect : effects) subject += "." + effect->name;
  begin(CaseKind::effects, subject, showing);
  for (const Effect* effect : effects) hide(*effect, true, effect->large.confusable);
  return finish();
}

BuiltCase CaseBuilder::clean(const Showing& showing) {
  constexpr double battery_share = 0.3;
  begin(CaseKind::clean, "clean", showing);
  built_.hidden.sensors.battery = random_.chance(battery_share);
  return finish();
}

BuiltCase CaseBuilder::cannot_tell(const Effect& effect, const Showing& showing, double pace) {
  begin(CaseKind::cannot_tell, "cannot_tell." + effect.name, showing);
  hide(effect, true, "");
  built_.hidden.style.top_m_s *= pace;
  return finish();
}

BuiltCase CaseBuilder::outside(const Effect& effect, bool large) {
  begin(CaseKind::outside, "outside." + effect.name, large ? effect.large : effect.small);
  if (!large) built_.exam.size = "small";
  hide(effect, large, "");
  built_.exam.hidden.front().name = "outside_" + effect.name;
  return finish();
}

}  // namespace plants::fifth
