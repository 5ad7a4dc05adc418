#include "model/filter/model_doubt.hpp"

#include <algorithm>
#include <cmath>

#include "model/simulation/moved_models.hpp"

namespace wheelwright {
namespace {

// As far as a parameter may be off before a reading is called a fault.
constexpr double deviations = 3.0;

}  // namespace

ModelDoubt::ModelDoubt(const RobotModel& model) {
  for (const MovedModels& moved : moved_effects(model, deviations))
    moved_.push_back({ModelSimulation(moved.up), ModelSimulation(moved.down)});
}

void ModelDoubt::set_place(const Pose& pose, const WheelPair& distance_m) {
  for (Moved& moved : moved_) {
    for (ModelSimulation* simulation : {&moved.up, &moved.down}) {
      simulation->set_pose(pose);
      simulation->set_distance_m(distance_m);
    }
  }
}

WheelPair ModelDoubt::step(const WheelPair& command_m_s, double battery_v, const WheelPair& wheel_m_s) {
  WheelPair doubt_m_s;
  for (Moved& moved : moved_) {
    const WheelPair& up = moved.up.step(command_m_s, battery_v).wheel_m_s;
    const WheelPair& down = moved.down.step(command_m_s, battery_v).wheel_m_s;
    doubt_m_s.left = std::max(doubt_m_s.left, std::abs(up.left + down.left - 2.0 * wheel_m_s.left));
    doubt_m_s.right = std::max(doubt_m_s.right, std::abs(up.right + down.right - 2.0 * wheel_m_s.right));
  }
  return doubt_m_s;
}

}  // namespace wheelwright
