#include "model/brain/manoeuvre.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace wheelwright {
namespace {

int ticks_of(double seconds, double period_s) {
  return static_cast<int>(std::ceil(seconds / period_s - 1e-9));
}

// Notices that the wheels stand: counts unchanged for 0.3 s. A robot whose sensors are not received never
// stands.
class StillnessDetector {
 public:
  explicit StillnessDetector(double period_s) : needed_(ticks_of(0.3, period_s)) {}

  void restart() { unchanged_ = 0; }

  bool still(const SensorFrame& frame) {
    if (!frame.valid || frame.tick == last_tick_) return unchanged_ >= needed_;
    last_tick_ = frame.tick;
    const bool same = frame.ticks.left == last_.left && frame.ticks.right == last_.right;
    unchanged_ = same ? unchanged_ + 1 : 0;
    last_ = frame.ticks;
    return unchanged_ >= needed_;
  }

 private:
  int needed_;
  int unchanged_ = 0;
  std::int64_t last_tick_ = -1;
  WheelTicks last_;
};

class WaitUntilStill final : public Manoeuvre {
 public:
  explicit WaitUntilStill(double period_s) : stillness_(period_s) {}

  void restart() override { stillness_.restart(); }

  std::optional<WheelOrder> next(const SensorFrame& latest) override {
    if (stillness_.still(latest)) return std::nullopt;
    return WheelOrder{{}, Activity::wait_until_still, 0};
  }

 private:
  StillnessDetector stillness_;
};

class EncoderCheck final : public Manoeuvre {
 public:
  explicit EncoderCheck(double period_s) : leg_ticks_(ticks_of(0.5, period_s)) {}

  void restart() override { tick_ = 0; }

  std::optional<WheelOrder> next(const SensorFrame&) override {
    constexpr double speed_m_s = 0.1;
    const int at = tick_++;
    if (at < leg_ticks_) return WheelOrder{{speed_m_s, 0.0}, Activity::encoder_check, 0};
    if (at < 2 * leg_ticks_) return WheelOrder{{}, Activity::encoder_check, 1};
    if (at < 3 * leg_ticks_) return WheelOrder{{-speed_m_s, 0.0}, Activity::encoder_check, 2};
    return std::nullopt;
  }

 private:
  int leg_ticks_;
  int tick_ = 0;
};

// Counter-clockwise, a stop, and back: motors that are reversed at speed draw too much.
class EncoderTurn final : public Manoeuvre {
 public:
  EncoderTurn(const EncoderTurnPlan& plan, double period_s) : plan_(plan), stillness_(period_s) {
    // Without any idea of a turn's counts, those of a Roomba decide how long to go on.
    constexpr double roomba_ticks_per_turn = 1660.0;
    const double expected = plan.options.expected_ticks_per_turn;
    wanted_ticks_ = plan.turns_each_way * (expected > 0.0 ? expected : roomba_ticks_per_turn);
    // Twice the time that it takes at half the speed ordered: a robot that does not count does not turn for
    // ever.
    constexpr double default_metres_per_tick = 0.000444565;
    longest_ticks_ = ticks_of(4.0 * wanted_ticks_ * default_metres_per_tick / plan.speed_m_s, period_s);
  }

  void restart() override { begin(Leg::forth); }

  std::optional<WheelOrder> next(const SensorFrame& latest) override {
    if (++elapsed_ > longest_ticks_) return std::nullopt;
    switch (leg_) {
      case Leg::forth:
        if (!has_turned(latest)) return turn(-plan_.speed_m_s, 0);
        begin(Leg::stop);
        stillness_.restart();
        return turn(0.0, 0);
      case Leg::stop:
        if (!stillness_.still(latest)) return turn(0.0, 0);
        begin(Leg::back);
        return turn(plan_.speed_m_s, 1);
      case Leg::back:
        break;
    }
    if (has_turned(latest)) return std::nullopt;
    return turn(plan_.speed_m_s, 1);
  }

 private:
  enum class Leg : std::uint8_t { forth, stop, back };

  static WheelOrder turn(double left_m_s, std::uint16_t way) {
    return {{left_m_s, -left_m_s}, Activity::encoder_turn, way};
  }

  void begin(Leg leg) {
    leg_ = leg;
    elapsed_ = 0;
    start_.reset();
  }

  bool has_turned(const SensorFrame& latest) {
    if (!latest.valid) return false;
    if (!start_) start_ = latest.ticks;
    const auto turned = (latest.ticks.right - start_->right) - (latest.ticks.left - start_->left);
    return 0.5 * static_cast<double>(leg_ == Leg::back ? -turned : turned) >= wanted_ticks_;
  }

  EncoderTurnPlan plan_;
  StillnessDetector stillness_;
  double wanted_ticks_ = 0.0;
  int longest_ticks_ = 0;
  Leg leg_ = Leg::forth;
  int elapsed_ = 0;  // in this leg
  std::optional<WheelTicks> start_;
};

class ResponseActions final : public Manoeuvre {
 public:
  ResponseActions(const ResponsePlan& plan, double period_s)
      : plan_(plan),
        period_s_(period_s),
        shortest_off_ticks_(ticks_of(0.6, period_s)),
        stillness_(period_s) {}

  void restart() override {
    stillness_.restart();
    action_ = repetition_ = ticks_in_action_ = 0;
  }

  std::optional<WheelOrder> next(const SensorFrame& latest) override {
    const bool still = stillness_.still(latest);
    const bool off = action_ % 2 == 1;
    ++ticks_in_action_;
    if (!off && ticks_in_action_ > on_ticks()) begin_next_action();
    if (off && ticks_in_action_ > shortest_off_ticks_ && still) begin_next_action();
    if (repetition_ >= plan_.repetitions) return std::nullopt;
    return order();
  }

 private:
  void begin_next_action() {
    ticks_in_action_ = 1;
    stillness_.restart();
    action_ = (action_ + 1) % 4;
    if (action_ == 0) ++repetition_;
  }

  // Multiples of the golden ratio fill the spread evenly from the first repetitions on.
  double size_m_s() const {
    const double place = std::fmod(0.618034 * repetition_, 1.0) - 0.5;
    return plan_.speed_m_s * (1.0 + plan_.speed_spread * place);
  }

  // Each action rolls the same way, so that another one undoes it, whatever its speed.
  int on_ticks() const { return ticks_of(plan_.on_s * plan_.speed_m_s / size_m_s(), period_s_); }

  // Left forward, right back; then right forward, left back, which undoes both in the reverse order. So the
  // robot is back where it was after every second repetition, and never far from there. A last repetition
  // that none undoes goes forward with both, which keeps the heading.
  WheelOrder order() const {
    constexpr std::array left{Activity::left_on, Activity::left_off};
    constexpr std::array right{Activity::right_on, Activity::right_off};
    const bool undoes = plan_.alternate_direction && repetition_ % 2 == 1;
    const bool is_left = (action_ < 2) != undoes;
    const auto phase = static_cast<std::size_t>(action_ % 2);
    WheelOrder order{{}, is_left ? left.at(phase) : right.at(phase), static_cast<std::uint16_t>(repetition_)};
    if (phase == 1) return order;
    const bool is_undone = undoes || repetition_ + 1 < plan_.repetitions;
    const bool backwards = plan_.alternate_direction && is_undone && action_ == 2;
    (is_left ? order.speed_m_s.left : order.speed_m_s.right) = backwards ? -size_m_s() : size_m_s();
    return order;
  }

  ResponsePlan plan_;
  double period_s_;
  int shortest_off_ticks_;
  StillnessDetector stillness_;
  int action_ = 0;  // one wheel on and off, the other on and off
  int repetition_ = 0;
  int ticks_in_action_ = 0;
};

class CommandedManoeuvre final : public Manoeuvre {
 public:
  CommandedManoeuvre(CommandedDrive drive, double period_s) : drive_(std::move(drive)), period_s_(period_s) {}

  void restart() override {
    tick_ = 0;
    row_ = 0;
  }

  std::optional<WheelOrder> next(const SensorFrame& /*latest*/) override {
    const double nearest_until_s = (static_cast<double>(tick_) + 0.5) * period_s_;
    if (drive_.rows.empty() || nearest_until_s > drive_.duration_s) return std::nullopt;
    while (row_ + 1 < drive_.rows.size() && drive_.rows[row_ + 1].t_s <= nearest_until_s) ++row_;
    ++tick_;
    return WheelOrder{drive_.rows[row_].command_m_s, Activity::commanded_drive, 0};
  }

 private:
  CommandedDrive drive_;
  double period_s_;
  std::size_t tick_ = 0;
  std::size_t row_ = 0;
};

}  // namespace

std::unique_ptr<Manoeuvre> make_wait_until_still(double period_s) {
  return std::make_unique<WaitUntilStill>(period_s);
}

std::unique_ptr<Manoeuvre> make_encoder_check(double period_s) {
  return std::make_unique<EncoderCheck>(period_s);
}

std::unique_ptr<Manoeuvre> make_encoder_turn(const EncoderTurnPlan& plan, double period_s) {
  return std::make_unique<EncoderTurn>(plan, period_s);
}

std::unique_ptr<Manoeuvre> make_response_actions(const ResponsePlan& plan, double period_s) {
  return std::make_unique<ResponseActions>(plan, period_s);
}

std::unique_ptr<Manoeuvre> make_commanded_drive(CommandedDrive drive, double period_s) {
  return std::make_unique<CommandedManoeuvre>(std::move(drive), period_s);
}

}  // namespace wheelwright
