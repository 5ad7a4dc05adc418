// What the brain knows of its robot: the model that predicts from commands alone, and the filter that holds
// the sensors against it. One is exchanged with the other, since the filter judges by the model.
#pragma once

#include <array>
#include <cstdint>
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
  explicit DrivingModel(const RobotModel& model)
      : predictor(model), uncertainty(PoseUncertainty(model)), saved_{saved(), saved()} {
    if (!model.encoder_scale) return;
    filter.emplace(model);
    fresh_filter_ = filter;
  }
  explicit DrivingModel(const LinearModel& linear_part) : predictor(linear_part), saved_{saved(), saved()} {}

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
    forget();
  }

  // Moves the prediction on by one period with this command in force.
  void step(const WheelPair& command_m_s) {
    predictor.step(command_m_s);
    if (uncertainty) uncertainty->step(command_m_s, predictor.motion());
  }

  // Keeps the prediction of this tick, if the last one that was kept lies far enough back.
  void save(std::int64_t tick) {
    const bool first_is_older = saved_[0].tick <= saved_[1].tick;
    Saved& older = saved_.at(first_is_older ? 0 : 1);
    const Saved& newer = saved_.at(first_is_older ? 1 : 0);
    if (newer.tick >= 0 && tick < newer.tick + ticks_between_saved) return;
    older.tick = tick;
    older.simulation = predictor.simulation();
    if (uncertainty) older.uncertainty = uncertainty;
  }

  // Goes back to the last prediction that was kept of `tick` or earlier, and returns its tick; nothing where
  // none was kept.
  std::optional<std::int64_t> go_back_to(std::int64_t tick) {
    const Saved* last = nullptr;
    for (const Saved& one : saved_) {
      if (one.tick >= 0 && one.tick <= tick && (last == nullptr || one.tick > last->tick)) last = &one;
    }
    if (last == nullptr) return std::nullopt;
    predictor.go_on_from(last->simulation);
    uncertainty = last->uncertainty;
    const std::int64_t back_at = last->tick;
    for (Saved& one : saved_) {
      if (one.tick > back_at) one.tick = -1;
    }
    return back_at;
  }

  // Goes on in the place of another model of the same robot, which drives. Both have to be primed with the
  // commands of the past first.
  void take_over(const DrivingModel& before) {
    predictor.take_over(before.predictor);
    if (uncertainty && before.uncertainty) uncertainty->take_over(*before.uncertainty, predictor.pose());
    if (filter && before.filter) filter->take_over(*before.filter);
    forget();
  }

  MotionPredictor predictor;
  std::optional<PoseUncertainty> uncertainty;  // of the predictor's pose
  std::optional<HybridFilter> filter;

 private:
  static constexpr std::int64_t ticks_between_saved = 32;

  struct Saved {
    std::int64_t tick;  // none where negative
    ModelSimulation simulation;
    std::optional<PoseUncertainty> uncertainty;
  };
  Saved saved() const { return {-1, predictor.simulation(), uncertainty}; }
  void forget() {
    for (Saved& one : saved_) one.tick = -1;
  }

  std::optional<HybridFilter> fresh_filter_;
  std::array<Saved, 2> saved_;
};

}  // namespace wheelwright
