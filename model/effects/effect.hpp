// What a linear model of a robot lacks: physical effects before, after and around its linear part.
//
//   command -> [command effects] -> linear part -> [wheel effects] -> what the encoders count
//           -> [floor effects] -> rolling on the floor -> [body effects] -> motion
//           -> [observation] -> reference
//
// An effect is a small block with a name, a cause, and parameters with units and bounds. It is one file in
// this folder: a class that overrides the hook of its stage, and a function of the file's own name that
// returns its EffectInfo. The build finds the file (model/CMakeLists.txt); nothing else needs a change.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "model/geometry/pose.hpp"
#include "model/geometry/sensor_period.hpp"

namespace wheelwright {

// Where an effect acts. `counts` are effects of the encoders alone: they move nothing.
enum class EffectStage { command, wheel, floor, body, observation, counts };

// What an effect may know at the beginning of a period.
struct StepContext {
  double period_s = default_period_s;
  double wheel_base_m = 0.235;
  double time_s = 0.0;          // since the start of the run
  WheelPair command_m_s;        // as sent
  WheelPair speed_m_s;          // of the wheels, as the encoders saw it, in the period before
  WheelPair distance_m;         // rolled by the wheels since the start, as the encoders saw it
  WheelPair next_speed_m_s;     // of the wheels in this period; from the floor stage on
  WheelPair load_m_s;           // speed that loads have taken from the wheels, in the period before
  WheelPair rolling{1.0, 1.0};  // rolled on the floor per counted, of each wheel (Effect::rolling)
  Pose pose;                    // of the middle of the axle
  double battery_v = std::numeric_limits<double>::quiet_NaN();  // where it was measured
};

// Which hooks an effect overrides: the others need not be called.
struct EffectHooks {
  bool command = false;
  bool wheel = false;
  bool floor = false;
  bool body = false;
  bool observed = false;
  bool load = false;  // on the wheels: what it takes of their speed counts as StepContext::load_m_s
};

// One effect at work. Holds its own state; never allocates after it was made.
class Effect {
 public:
  Effect() = default;
  Effect(const Effect&) = default;
  Effect& operator=(const Effect&) = default;
  virtual ~Effect() = default;

  // Each hook changes what it is given, for one period. An effect overrides the one of its stage.
  virtual void command(WheelPair& /*command_m_s*/, const StepContext&) {}
  virtual void wheel(WheelPair& /*speed_m_s*/, const StepContext&) {}
  virtual void floor(WheelPair& /*speed_m_s*/, const StepContext&) {}
  virtual void body(Twist& /*twist*/, const StepContext&) {}
  // The pose of the point that an outside reference measures.
  virtual Pose observed(const Pose& axle) const { return axle; }
  // Of an effect on the floor: what each wheel rolls there per what its encoder counts, where that is
  // constant.
  virtual WheelPair rolling() const { return {1.0, 1.0}; }
  virtual EffectHooks hooks() const = 0;

  // To rest, at the start of a run.
  virtual void reset() {}

  virtual std::unique_ptr<Effect> clone() const = 0;
  // Takes over the state of an effect of the same class, without allocating.
  virtual void assign(const Effect& other) = 0;
};

// The class that declares a member, by the type of a pointer to it.
template <typename Member>
struct DeclaredBy;
template <typename Class, typename Member>
struct DeclaredBy<Member Class::*> {
  using type = Class;
};
template <typename Hook>
constexpr bool is_overridden = !std::is_same_v<typename DeclaredBy<Hook>::type, Effect>;

// Whether a class says by a member `loads_motors` that what it does to the wheels is a load of their motors.
template <typename Derived>
constexpr bool is_load = requires {
  requires Derived::loads_motors;
};

// Gives an effect its copies, and tells its hooks.
template <typename Derived>
class EffectOf : public Effect {
 public:
  EffectHooks hooks() const override {
    return {is_overridden<decltype(&Derived::command)>,  is_overridden<decltype(&Derived::wheel)>,
            is_overridden<decltype(&Derived::floor)>,    is_overridden<decltype(&Derived::body)>,
            is_overridden<decltype(&Derived::observed)>, is_load<Derived>};
  }
  std::unique_ptr<Effect> clone() const override {
    return std::make_unique<Derived>(static_cast<const Derived&>(*this));
  }
  void assign(const Effect& other) override {
    static_cast<Derived&>(*this) = static_cast<const Derived&>(other);
  }
};

struct ParameterInfo {
  std::string name;
  std::string unit;
  std::string meaning;
  double lower = 0.0;  // what is physically possible
  double upper = 0.0;
  std::vector<double> sizes;  // where a search begins, from weak to strong
  double negligible = 0.0;    // smaller sizes are of no consequence and are never named
  bool scales_effect = true;  // false for a shape (a time constant, a place) that says nothing of the size
  std::optional<double> if_absent{};  // in files from before there was one
};

// Ways in which the same effect may show, e.g. before or behind the encoder.
struct EffectVariant {
  std::string name;
  EffectStage stage;
  std::vector<ParameterInfo> parameters{};  // of its own, in the place of the effect's
  bool acts_first = false;                  // before the others of its stage
  // Of one with a size for each wheel: the variant whose wheels are alike (library/each_wheel_variants.hpp).
  std::optional<std::size_t> alike{};
};

// What the data must hold for the effect to be seen at all.
struct EffectNeeds {
  bool reference = false;  // poses from outside
  bool or_gyro = false;    // or a gyro beside the counts: it shows in how the robot turns
  bool heading = false;    // with a heading in them
  bool place = false;      // with x and y in them
  bool reversal = false;   // both directions of wheel motion
  bool turning = false;
  bool battery = false;
  bool encoders = false;
  bool scale = false;    // metres per tick that someone states
  bool variety = false;  // several sizes of command: with one or two, a bend looks like a gain
};

struct EffectArguments {
  std::span<const double> parameters;  // in the order of EffectInfo::parameters_of
  std::size_t variant = 0;             // index in EffectInfo::variants
};

struct EffectInfo {
  std::string name;
  std::string summary;                    // one line: what is seen
  std::string cause;                      // physical origin, and what separates it from its likes
  std::vector<EffectVariant> variants;    // at least one; the first is the usual one
  std::vector<ParameterInfo> parameters;  // of the variants that have none of their own
  EffectNeeds needs;
  std::function<std::unique_ptr<Effect>(const EffectArguments&)> make;
  bool may_load_wheels = false;  // what it does to the body may show in the wheels: wheel_load_variants.hpp
  bool linear = false;           // a linear part can take it up, and then hides it
  bool by_wheel_angle = false;   // hangs on the angle at which the wheels stood when a run began
  bool by_pose = false;          // hangs on where the robot stands and heads
  bool wheel_mismatch = false;   // the difference of the wheels' rolling radii, which counts do not show
  // Whether it is what its name says, in runs with such commands, and not mostly another's; empty: always.
  std::function<bool(const EffectArguments&, double largest_command_m_s)> in_character{};
  // Parameters with which nothing but a linear lag is left of it; what this explains as well, its linear part
  // lacks.
  std::function<std::vector<double>(const EffectArguments&)> linear_part{};
  bool by_wheel = false;  // each wheel has its own, which may differ: library/each_wheel_variants.hpp

  const std::vector<ParameterInfo>& parameters_of(std::size_t variant) const {
    const std::vector<ParameterInfo>& own = variants[variant].parameters;
    return own.empty() ? parameters : own;
  }
};

// An effect as a model holds it.
struct EffectSetting {
  std::string name;
  std::string variant;
  std::vector<double> parameters;
};

// Applies a map to both wheels.
template <typename Map>
void both(WheelPair& pair, Map map) {
  pair.left = map(pair.left);
  pair.right = map(pair.right);
}

}  // namespace wheelwright
