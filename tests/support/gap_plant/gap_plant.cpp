#include "tests/support/gap_plant/gap_plant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/gap_plant/floor_contact.hpp"
#include "tests/support/gap_plant/plant_sensors.hpp"
#include "tests/support/gap_plant/wheel_drive.hpp"

namespace wheelwright::test {
namespace {

constexpr double finest_step_s = 0.001;

class Plant {
 public:
  Plant(const PlantParameters& robot, const GapRunPlan& plan, double dt_s)
      : robot_(robot),
        plan_(plan),
        dt_s_(dt_s),
        gear_phase_(plan.seed),
        left_(robot, robot.motor_gain.left, dt_s, plan.hour, phase(), plan.seed * 4 + 1),
        right_(robot, robot.motor_gain.right, dt_s, plan.hour, phase(), plan.seed * 4 + 2),
        floor_(robot, plan.start, dt_s, plan.seed * 4 + 3) {
    load_supply({}, 0.0);
  }

  // `progress`: how much of the run has passed, 0 to 1.
  void step(const WheelPair& command, double progress) {
    load_supply(command, progress);
    const WheelPair load = floor_.load_m_s();
    const double left = left_.force_m_s(command.left, command.right, supply_, rim_m_s_.left, motor_m_.left);
    const double right =
        right_.force_m_s(command.right, command.left, supply_, rim_m_s_.right, motor_m_.right);
    accelerate({left + load.left, right + load.right});
    const WheelPair before = rim_m_;
    motor_m_.left += dt_s_ * rim_m_s_.left;
    motor_m_.right += dt_s_ * rim_m_s_.right;
    rim_m_ = {left_.wheel_m(motor_m_.left) - gear_start_m_.left,
              right_.wheel_m(motor_m_.right) - gear_start_m_.right};
    floor_.step({rim_m_.left - before.left, rim_m_.right - before.right}, hardest_m_s2_);
  }

  double battery_v() const { return battery_v_; }
  const FloorContact& floor() const { return floor_; }
  PlantTruth truth() const { return {rim_m_, rim_m_s_, floor_.pose(), supply_}; }

 private:
  double phase() { return std::uniform_real_distribution<double>(0.0, 2.0 * std::numbers::pi)(gear_phase_); }

  // The battery as charge and load leave it; the drive feels it only where it is not regulated.
  void load_supply(const WheelPair& command, double progress) {
    const double charge = plan_.charge_used + progress * (plan_.charge_used_at_end - plan_.charge_used);
    const double load = std::abs(command.left) + std::abs(command.right);
    loaded_ += dt_s_ / 0.05 * (load - loaded_);
    const bool regulated = robot_.supply_fall_share <= 0.0;
    const double fall = regulated ? robot_.battery_fall_share : robot_.supply_fall_share;
    const double share = 1.0 - 0.75 * fall * charge - 0.3 * fall * loaded_;
    battery_v_ = robot_.battery_full_v * share;
    supply_ = regulated ? 1.0 : share;
  }

  // The body couples the wheels: its inertia against turning is another than against going straight.
  void accelerate(const WheelPair& force_m_s) {
    const double straight = 0.5 * (force_m_s.left + force_m_s.right) / robot_.response_s;
    const double turning =
        0.5 * (force_m_s.right - force_m_s.left) / (robot_.response_s * robot_.yaw_response_ratio);
    const WheelPair a{straight - turning, straight + turning};
    rim_m_s_.left += dt_s_ * a.left;
    rim_m_s_.right += dt_s_ * a.right;
    constexpr double smoothing_s = 0.01;
    hardest_m_s2_ += dt_s_ / smoothing_s * (std::max(std::abs(a.left), std::abs(a.right)) - hardest_m_s2_);
  }

  const PlantParameters robot_;
  const GapRunPlan plan_;
  double dt_s_;
  std::mt19937_64 gear_phase_;
  WheelDrive left_;
  WheelDrive right_;
  FloorContact floor_;
  WheelPair motor_m_;
  WheelPair rim_m_;
  WheelPair rim_m_s_;
  WheelPair gear_start_m_{left_.wheel_m(0.0), right_.wheel_m(0.0)};
  double hardest_m_s2_ = 0.0;
  double loaded_ = 0.0;
  double supply_ = 1.0;
  double battery_v_ = 0.0;
};

}  // namespace

PlantRun drive_plant(const PlantParameters& robot, const std::vector<WheelPair>& commands_m_s,
                     const GapRunPlan& plan) {
  const auto substeps = static_cast<int>(std::ceil(plan.period_s / finest_step_s - 1e-9));
  Plant plant(robot, plan, plan.period_s / substeps);
  PlantSensors sensors(robot, plan.period_s, plan.wrap_heading, plan.seed * 4 + 4);
  PlantRun run;
  run.log.name = "gap plant";
  run.log.wheel_base_m = robot.wheel_base_m;
  run.log.period_s = plan.period_s;
  run.log.metres_per_tick = WheelPair{robot.metres_per_tick, robot.metres_per_tick};
  run.log.other_metadata = {{"robot", "gap plant"}};
  for (std::size_t k = 0; k < commands_m_s.size(); ++k) {
    DriveSample sample;
    sample.t_s = plan.period_s * static_cast<double>(k);
    sample.command_m_s = commands_m_s[k];
    const PlantTruth truth = plant.truth();
    sensors.measure(sample, truth.rim_m, truth.pose, plant.floor().twist(), plant.battery_v());
    run.log.samples.push_back(sample);
    run.truth.push_back(truth);
    for (int i = 0; i < substeps; ++i) {
      plant.step(commands_m_s[k], static_cast<double>(k) / static_cast<double>(commands_m_s.size()));
    }
  }
  return run;
}

}  // namespace wheelwright::test
