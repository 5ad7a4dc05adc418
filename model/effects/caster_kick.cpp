// caster_kick: a short yaw disturbance after the direction of travel flips.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/effects/effect.hpp"

namespace wheelwright::effects {
namespace {

constexpr double moving_m_s = 0.005;

// Variants, all of which come a second time at the wheels (model/effects/library/wheel_load_variants.hpp).
constexpr std::size_t alternating = 1;
constexpr std::size_t swivel = 2;
constexpr std::size_t swing = 3;
constexpr std::size_t ploughing_same = 4;
constexpr std::size_t ploughing_alternating = 5;
constexpr std::size_t ploughing = 6;
constexpr std::size_t variants = 7;

bool ploughs(std::size_t variant) {
  return variant == ploughing_same || variant == ploughing_alternating;
}

class CasterKick final : public EffectOf<CasterKick> {
 public:
  explicit CasterKick(const EffectArguments& arguments)
      : size_(arguments.parameters[0]),
        distance_m_(arguments.parameters[1]),
        aside_(arguments.parameters[2]),
        alternates_(arguments.variant == alternating || arguments.variant == ploughing_alternating),
        ploughs_(ploughs(arguments.variant)) {}

  // The caster's swing grows by itself once begun and settles as it ends: a logistic curve of the distance
  // travelled since the flip. Who turns back half-way has that half of it to swing back. A wheel that ploughs
  // while it stands across pushes for as long as that lasts: who drives slowly is turned farther.
  void body(Twist& twist, const StepContext& context) override {
    const double v = twist.v_m_s;
    if (std::abs(v) > moving_m_s) {
      const double direction = std::copysign(1.0, v);
      if (direction_ != 0.0 && direction != direction_) {
        swung_ = std::clamp(1.0 - swung_, aside_, 1.0 - aside_);
        kick_ = alternates_ ? direction * size_ : size_;
      }
      direction_ = direction;
    }
    const double ahead = (1.0 - swung_) * std::exp(-std::abs(v) * context.period_s / distance_m_);
    const double before = swung_;
    swung_ /= swung_ + ahead;
    twist.w_rad_s += kick_ * (ploughs_ ? 4.0 * before * (1.0 - before) * std::tanh(std::abs(v) / moving_m_s)
                                       : (swung_ - before) / (1.0 - aside_) / context.period_s);
  }
  void reset() override {
    direction_ = 0.0;
    kick_ = 0.0;
    swung_ = 1.0;
  }

 private:
  double size_;  // of the kick, rad, or of the push, rad/s
  double distance_m_;
  double aside_;
  bool alternates_;
  bool ploughs_;
  double direction_ = 0.0;  // of travel, once it has moved
  double kick_ = 0.0;       // of the present swing
  double swung_ = 1.0;      // share of it
};

// A direction in the plane, by its cosine and sine: turned without calls of either.
struct Direction {
  double x;
  double y;

  Direction turned_by(const Direction& other) const {
    return {x * other.x - y * other.y, y * other.x + x * other.y};
  }
  Direction turned_back_by(const Direction& other) const {
    return {x * other.x + y * other.y, y * other.x - x * other.y};
  }
  static Direction of_angle(double angle_rad) {
    const wheelwright::Direction direction = direction_of(angle_rad);
    return {direction.cosine, direction.sine};
  }
  static Direction of_vector(double x, double y) {
    const double length = std::sqrt(x * x + y * y);
    return length > 0.0 ? Direction{x / length, y / length} : Direction{1.0, 0.0};
  }
};

// A fork whose wheel is dragged after its pivot (a tractrix: the tangent of half the angle between the fork
// and where its pivot goes shrinks to 1/e within one trail).
class Fork {
 public:
  Fork(double trail_m, double ahead_m, double lean_rad = 0.0)
      : trail_m_(trail_m), ahead_m_(ahead_m), lean_rad_(lean_rad), fork_(Direction::of_angle(lean_rad)) {}

  // How it goes in one period. Directions of the fork are from behind the pivot, seen from the robot.
  class Step {
   public:
    Direction middle() const {
      return Direction::of_vector(off_.x + off_after_.x, off_.y + off_after_.y)
          .turned_by(behind_)
          .turned_by(half_turn_);
    }
    Direction end() const { return off_after_.turned_by(behind_).turned_back_by(half_turn_); }
    // From 0 for a fork that trails, or stands across, to 1 for one that its pivot pushes ahead of itself.
    double ahead_share() const { return std::max(0.0, -0.5 * (off_.x + off_after_.x)); }
    double swivel_rad_s() const {
      const double turned_rad = 2.0 * std::atan((after_ - before_) / (1.0 + after_ * before_));
      return turned_rad / period_s_ - turn_rad_s_;
    }

   private:
    friend class Fork;
    double period_s_;
    double turn_rad_s_;    // of the robot
    Direction half_turn_;  // of the robot
    Direction behind_;     // the pivot's way
    Direction off_;        // the fork from behind its pivot's way at the beginning, seen from the floor
    Direction off_after_;
    double before_;  // tangents of half the angles of these
    double after_;
  };
  Step dragged(const Twist& twist, double period_s) const {
    const double sideways_m_s = twist.w_rad_s * ahead_m_;
    const double pivot_m_s = std::sqrt(twist.v_m_s * twist.v_m_s + sideways_m_s * sideways_m_s);
    Step step;
    step.period_s_ = period_s;
    step.turn_rad_s_ = twist.w_rad_s;
    step.half_turn_ = Direction::of_angle(0.5 * twist.w_rad_s * period_s);
    step.behind_ = leaning(Direction::of_vector(twist.v_m_s, sideways_m_s));
    step.off_ = fork_.turned_back_by(step.half_turn_).turned_back_by(step.behind_);
    step.before_ = tangent_of_half(step.off_);
    step.after_ = step.before_ * std::exp(-pivot_m_s * period_s / trail_m_);
    const double scale = 1.0 / (1.0 + step.after_ * step.after_);
    step.off_after_ = {(1.0 - step.after_ * step.after_) * scale, 2.0 * step.after_ * scale};
    return step;
  }
  void move_on(const Step& step) { fork_ = step.end(); }
  void reset() { fork_ = Direction::of_angle(lean_rad_); }

 private:
  // For a fork that points straight ahead, a large number instead of infinity: it leaves that unstable place
  // after some 37 trails of travel.
  static double tangent_of_half(const Direction& direction) {
    constexpr double largest = 1e16;
    if (direction.x > 0.0) return direction.y / (1.0 + direction.x);
    const double other = 1.0 - direction.x;
    return std::abs(direction.y) * largest > other ? other / direction.y
                                                   : std::copysign(largest, direction.y);
  }
  Direction leaning(const Direction& behind) const {
    return lean_rad_ == 0.0 ? behind : behind.turned_by(Direction::of_angle(lean_rad_ * behind.x));
  }

  double trail_m_;
  double ahead_m_;
  double lean_rad_;  // by which it stands aside on a straight way, forward or backward to the same side
  Direction fork_;   // from behind the pivot, seen from the robot
};

// A fork that is stiff in its pivot holds the robot's nose back for as long as it turns, at flips and in
// every turn, and turns the less for it: at a rate that friction could stop, robot and fork turn as one.
//
// Friction takes the speed u = push * tanh(s / sliding), where the fork turns at the rate s = s(0) - k u that
// is left; k is the slope between no friction and all of it. u = push * tanh(s(0) / (sliding + k push)) has
// the same slope at 0, and the same limit. Wheels give way to it with a lag of the first order.
class StiffSwivel final : public EffectOf<StiffSwivel> {
 public:
  explicit StiffSwivel(const EffectArguments& arguments)
      : push_m_s_(arguments.parameters[0]),
        ahead_m_(arguments.parameters[2]),
        lag_s_(arguments.parameters[3]),
        sliding_rad_s_(arguments.parameters[4]),
        fork_(arguments.parameters[1], arguments.parameters[2]) {}

  void body(Twist& twist, const StepContext& context) override {
    const double share = context.period_s / (context.period_s + lag_s_);
    const Twist kept{(1.0 - share) * taken_.v_m_s, (1.0 - share) * taken_.w_rad_s};
    const Twist unhindered = sum(twist, kept, 1.0);
    const Fork::Step free = fork_.dragged(unhindered, context.period_s);
    const Twist whole = push_towards(free.middle(), share * push_m_s_, context.wheel_base_m);
    const double free_rad_s = free.swivel_rad_s();
    const double sign = std::copysign(1.0, free_rad_s);
    const Fork::Step held = fork_.dragged(sum(unhindered, whole, sign), context.period_s);
    const double slower_rad_s = std::max(0.0, sign * (free_rad_s - held.swivel_rad_s()));
    taken_ = sum(kept, whole, std::tanh(free_rad_s / (sliding_rad_s_ + slower_rad_s)));
    twist = sum(twist, taken_, 1.0);
    fork_.move_on(fork_.dragged(twist, context.period_s));
  }
  void reset() override {
    fork_.reset();
    taken_ = {};
  }

 private:
  static Twist sum(const Twist& one, const Twist& other, double times) {
    return {one.v_m_s + times * other.v_m_s, one.w_rad_s + times * other.w_rad_s};
  }
  // Wheels that give way by that much to a force along the robot turn it by this much for one across.
  Twist push_towards(const Direction& fork, double push_m_s, double wheel_base_m) const {
    const double arm_1_m = 4.0 * ahead_m_ / (wheel_base_m * wheel_base_m);
    return {push_m_s * fork.y, -push_m_s * fork.x * arm_1_m};
  }

  double push_m_s_;
  double ahead_m_;
  double lag_s_;
  double sliding_rad_s_;
  Fork fork_;
  Twist taken_;  // by friction
};

// A wheel that scrubs while its fork swings round turns the robot in proportion; to which side it goes at a
// flip is a matter of the turn before, and of how it leans.
class ScrubbingSwing final : public EffectOf<ScrubbingSwing> {
 public:
  explicit ScrubbingSwing(const EffectArguments& arguments)
      : angle_rad_(arguments.parameters[0]),
        fork_(arguments.parameters[1], arguments.parameters[2], arguments.parameters[3]) {}

  void body(Twist& twist, const StepContext& context) override {
    const Fork::Step step = fork_.dragged(twist, context.period_s);
    fork_.move_on(step);
    twist.w_rad_s += angle_rad_ / std::numbers::pi * step.swivel_rad_s();
  }
  void reset() override { fork_.reset(); }

 private:
  double angle_rad_;
  Fork fork_;
};

// A wheel that its pivot pushes ahead resists along its fork, and so turns the robot by as much as the fork
// stands aside, for as long as it has not come round. Its side is a matter of the turn before, too.
class PloughingFork final : public EffectOf<PloughingFork> {
 public:
  explicit PloughingFork(const EffectArguments& arguments)
      : rate_rad_s_(arguments.parameters[0]),
        fork_(arguments.parameters[1], arguments.parameters[2], arguments.parameters[3]) {}

  void body(Twist& twist, const StepContext& context) override {
    const Fork::Step step = fork_.dragged(twist, context.period_s);
    fork_.move_on(step);
    const double moving = std::tanh(std::abs(twist.v_m_s) / moving_m_s);
    twist.w_rad_s += rate_rad_s_ * step.middle().y * step.ahead_share() * moving;
  }
  void reset() override { fork_.reset(); }

 private:
  double rate_rad_s_;
  Fork fork_;
};

std::vector<ParameterInfo> swivel_parameters() {
  return {{"push",
           "m/s",
           "speed that the fork's friction takes when it points backward",
           0.0,
           0.3,
           {0.005, 0.03},
           0.0003},
          {"trail", "m", "of the fork: its wheel behind its pivot", 0.003, 0.2, {0.015, 0.04}, 0.0, false},
          {"arm",
           "m",
           "from the axle to the fork's pivot; behind the axle is hardly another",
           0.0,
           0.5,
           {0.1},
           0.0,
           false},
          {"lag", "s", "with which the wheels give way to it", 0.0, 0.3, {0.03}, 0.0, false, 0.0},
          {"sliding",
           "rad/s",
           "rate of the swivel at which its friction has nearly its full size",
           0.03,
           10.0,
           {0.5},
           0.0,
           false,
           0.7}};
}

std::vector<ParameterInfo> swing_parameters() {
  return {{"angle", "rad", "turn that a whole swing makes", -1.0, 1.0, {-0.05, 0.05}, 0.002},
          {"trail", "m", "of the fork: its wheel behind its pivot", 0.003, 0.2, {0.015, 0.03}, 0.0, false},
          {"arm",
           "m",
           "from the axle to the fork's pivot; behind it where negative",
           -0.5,
           0.5,
           {-0.1, 0.1},
           0.0,
           false},
          {"lean",
           "rad",
           "by which the fork stands aside on a straight way",
           -0.5,
           0.5,
           {-0.15, 0.0, 0.15},
           0.0,
           false}};
}

std::vector<ParameterInfo> ploughing_parameters() {
  std::vector<ParameterInfo> parameters = swing_parameters();
  parameters.front() = {"rate", "rad/s", "turn of the robot by a caster that is pushed ahead, across",
                        -3.0,   3.0,     {-0.1, 0.1},
                        0.01};
  parameters[3].sizes = {-0.1, 0.1};
  return parameters;
}

std::vector<ParameterInfo> kick_parameters() {
  return {{"angle", "rad", "turn that one kick makes in all", -1.0, 1.0, {-0.05, -0.02, 0.02, 0.05}, 0.002},
          {"distance",
           "m",
           "of travel in which the swing grows or settles to 1/e",
           0.003,
           0.5,
           {0.015, 0.05},
           0.0,
           false},
          {"aside",
           "1",
           "share of its swing at which the caster stands at the flip: little, and the kick comes late",
           0.001,
           0.5,
           {0.01, 0.3},
           0.0,
           false}};
}

std::vector<ParameterInfo> plough_parameters() {
  std::vector<ParameterInfo> parameters = kick_parameters();
  parameters.front() = {"rate",      "rad/s", "turn of the robot while the caster stands across", -3.0, 3.0,
                        {-0.1, 0.1}, 0.01};
  return parameters;
}

// What turns the robot by as much as that is no caster's swing.
bool only_kicks(const EffectArguments& caster, double largest_command_m_s) {
  constexpr double largest_kick_rad = 0.5;
  const std::size_t variant = caster.variant % variants;
  if (variant == swivel) return true;
  // Of a caster that ploughs, at full speed: the area under its push, in distances or trails.
  const double area = variant == ploughing ? 1.0 : 4.0;
  const double per_size =
      ploughs(variant) || variant == ploughing ? area * caster.parameters[1] / largest_command_m_s : 1.0;
  return std::abs(caster.parameters[0]) * per_size < largest_kick_rad;
}

}  // namespace

EffectInfo caster_kick() {
  EffectInfo info{
      "caster_kick",
      "a short yaw disturbance after the direction of travel flips",
      "A caster swings round and pushes the robot aside while it does. 'same': to the same side at every "
      "flip, 'alternating': to one side when it begins to go forward, to the other when backward; 'swivel': "
      "by the friction of its pivot, in turns as well; 'swing': as it scrubs, to the side to which it stood; "
      "'ploughing_same', 'ploughing_alternating': for as long as it stands across, by time and not by way; "
      "'ploughing': likewise, to the side to which it stood.",
      {{"same", EffectStage::body},
       {"alternating", EffectStage::body},
       {"swivel", EffectStage::body, swivel_parameters()},
       {"swing", EffectStage::body, swing_parameters()},
       {"ploughing_same", EffectStage::body, plough_parameters()},
       {"ploughing_alternating", EffectStage::body, plough_parameters()},
       {"ploughing", EffectStage::body, ploughing_parameters()}},
      kick_parameters(),
      {.reference = true, .or_gyro = true, .reversal = true},
      [](const EffectArguments& arguments) -> std::unique_ptr<Effect> {
        if (arguments.variant == swivel) return std::make_unique<StiffSwivel>(arguments);
        if (arguments.variant == ploughing) return std::make_unique<PloughingFork>(arguments);
        if (arguments.variant == swing) return std::make_unique<ScrubbingSwing>(arguments);
        return std::make_unique<CasterKick>(arguments);
      },
      true};
  info.in_character = only_kicks;
  return info;
}

}  // namespace wheelwright::effects
