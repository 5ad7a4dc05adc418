// What the brain knows of its robot: the model that predicts from commands alone, and the filter that holds
// the sensors against it. One is exchanged with the other, since the filter judges by the model.
#pragma once

#include <optional>

#include "model/filter/hybrid_filter.hpp"
#include "model/simulation/motion_predictor.hpp"
#include "model/simulation/robot_model.hpp"
#include "model/uncertainty/pose_uncertainty.hpp"

namespace wheelwright {

// Allocates when it is made and never after.
struct DrivingModel {
  // A model of type fir or arma. Without an encoder scale there is no filter: readings in ticks say nothing
  // then of travel in metres.
  explicit DrivingModel(const RobotModel& model) : predictor(model) {
    uncertainty.emplace(model);
    if (!model.encoder_scale) return;
    filter.emplace(model);
    fresh_filter_ = filter;
  }
  explicit DrivingModel(const LinearModel& linear_part) : predictor(linear_part) {}

  // As it was made: at rest, and with nothing learnt of the robot since. A run begins so, whatever was before
  // it, since a recording begins with it too.
  void restart() {
    rest_at({});
    filter = fresh_filter_;
  }

  // The robot rests at this pose; so does the prediction.
  void rest_at(const Pose& pose) {
    predictor.reset(pose);
    if (uncertainty) uncertainty->reset(pose);
  }

  // Moves the prediction on by one period with this command in force.
  void step(const WheelPair& command_m_s) {
    predictor.step(command_m_s);
    if (uncertainty) uncertainty->step(command_m_s, predictor.motion());
  }

  // Goes on in the place of another model of the same robot, which drives. Both have to be primed with the
  // commands of the past first.
  void take_over(const DrivingModel& before) {
    predictor.take_over(before.predictor);
    if (uncertainty && before.uncertainty) uncertainty->take_over(*before.uncertainty, predictor.pose());
    if (filter && before.filter) filter->take_over(*before.filter);
  }

  MotionPredictor predictor;
  std::optional<PoseUncertainty> uncertainty;  // of the predictor's pose
  std::optional<HybridFilter> filter;

 private:
  std::optional<HybridFilter> fresh_filter_;
};

}  // namespace wheelwright
