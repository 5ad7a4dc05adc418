// A whole model in motion: linear part and effects, one period at a time, from rest.
//
// Allocates when it is made and never after; assigning one simulation to another of the same model does not
// allocate either.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "model/effects/effect.hpp"
#include "model/geometry/pose.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

struct RobotModel;

class ModelSimulation {
 public:
  explicit ModelSimulation(const RobotModel& model);
  // Effects act as they are listed, but for those that act first (effect_library.hpp). Throws
  // std::invalid_argument for one that make_effect refuses.
  ModelSimulation(const LinearModel& linear_part, std::span<const EffectSetting> effects);
  // With effects that need not be of the library, in the order in which they act.
  ModelSimulation(const LinearModel& linear_part, std::vector<std::unique_ptr<Effect>> effects);
  ModelSimulation(const ModelSimulation& other);
  ModelSimulation& operator=(const ModelSimulation& other);
  ModelSimulation(ModelSimulation&&) = default;
  ModelSimulation& operator=(ModelSimulation&&) = default;
  ~ModelSimulation() = default;

  // What one period brought.
  struct Motion {
    WheelPair wheel_m_s;  // as the encoders see it
    WheelPair floor_m_s;  // as the wheels roll on the floor
    Twist twist;          // of the middle of the axle
  };

  // Moves on by one period with this command in force. The battery's voltage matters to some effects.
  const Motion& step(const WheelPair& command_m_s,
                     double battery_v = std::numeric_limits<double>::quiet_NaN());

  const Motion& motion() const { return motion_; }
  // Of the middle of the axle.
  const Pose& pose() const { return context_.pose; }
  // Of the point that an outside reference measures.
  Pose observed_pose() const { return observed(context_.pose); }
  Pose observed(const Pose& axle) const;
  // The pose of the axle at which the reference measures `point`.
  Pose axle_of(const Pose& point) const;
  // Rolled by the wheels since the start (and before it, as reset was told), as the encoders see it.
  const WheelPair& distance_m() const { return context_.distance_m; }

  // From here on x and y of the pose stay where they are, which saves time: for those who look at each
  // period's motion only, of a model in which no effect acts by place.
  void leave_out_place() { with_place_ = false; }

  // Sets the pose, not the motion.
  void set_pose(const Pose& pose) { context_.pose = pose; }
  // Sets the way that the wheels have rolled, which tells their angle.
  void set_distance_m(const WheelPair& distance_m) { context_.distance_m = distance_m; }
  // To rest at a pose, at the start of a run. `initial_travel_m` tells the angle at which the wheels stand.
  void reset(const Pose& pose, const WheelPair& initial_travel_m = {});
  // Goes on in the place of another: pose, way and time are those of `before`; the motion is its own.
  void take_over(const ModelSimulation& before);

 private:
  struct WheelEffect {
    Effect* effect;
    bool is_load;
  };
  // Those that have a hook, in the order in which they act.
  struct ByHook {
    std::vector<Effect*> command;
    std::vector<WheelEffect> wheel;
    std::vector<Effect*> floor;
    std::vector<Effect*> body;
    std::vector<Effect*> observed;
  };
  void sort_by_hook();

  LinearPredictor linear_part_;
  std::vector<std::unique_ptr<Effect>> effects_;  // in the order in which they act
  ByHook with_hook_;
  StepContext context_;
  Motion motion_;
  bool with_place_ = true;
};

}  // namespace wheelwright
