#include "tests/support/gap_plant/drive_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace wheelwright::test {
namespace {

constexpr std::array<std::string_view, 4> program_names{"mixed", "forward_only", "straight_only",
                                                        "one_speed"};

class Driver {
 public:
  Driver(double seconds, double period_s, double wheel_base_m, std::uint64_t seed)
      : rows_(static_cast<std::size_t>(seconds / period_s)),
        period_s_(period_s),
        wheel_base_m_(wheel_base_m),
        random_(seed) {}

  std::vector<WheelPair> drive(Program program) {
    hold({}, rest_s);
    while (!done()) {
      switch (program) {
        case Program::mixed:
          mixed_part();
          break;
        case Program::forward_only:
          forward_part();
          break;
        case Program::straight_only:
          straight_part();
          break;
        case Program::one_speed:
          hold({0.2, 0.2}, 1.0);
          break;
      }
    }
    const auto resting = std::min(rows_, static_cast<std::size_t>(rest_s / period_s_));
    std::fill(commands_.end() - static_cast<std::ptrdiff_t>(resting), commands_.end(), WheelPair{});
    return std::move(commands_);
  }

 private:
  static constexpr double rest_s = 0.5;

  bool done() const { return commands_.size() >= rows_; }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool toss(double probability) { return between(0.0, 1.0) < probability; }

  void hold(const WheelPair& wheels, double seconds) {
    const auto periods = std::max<long>(1, std::lround(seconds / period_s_));
    const auto within = [](double value) {
      return std::clamp(value, -largest_program_speed_m_s, largest_program_speed_m_s);
    };
    for (long k = 0; k < periods && !done(); ++k)
      commands_.push_back({within(wheels.left), within(wheels.right)});
  }
  void move(double v_m_s, double w_rad_s, double seconds) {
    hold(wheels_of_twist({v_m_s, w_rad_s}, wheel_base_m_), seconds);
  }

  void mixed_part() {
    if (parts_.empty()) {
      parts_ = {0, 1, 2, 3, 4};
      std::shuffle(parts_.begin(), parts_.end(), random_);
    }
    const int part = parts_.back();
    parts_.pop_back();
    switch (part) {
      case 0:
        held_commands();
        break;
      case 1:
        route();
        break;
      case 2:
        steps();
        break;
      case 3:
        ramps();
        break;
      default:
        reversals();
        break;
    }
  }

  void held_commands() {
    for (int i = 0; i < 14; ++i) {
      hold({between(-0.4, 0.4), between(-0.4, 0.4)}, between(0.2, 1.2));
      if (toss(0.1)) hold({}, 0.4);
    }
  }

  void route() {
    const double speed = between(0.12, 0.32);
    const double turn = toss(0.5) ? 1.0 : -1.0;
    for (int leg = 0; leg < 4; ++leg) {
      move(speed, between(-0.15, 0.15), between(1.5, 3.0));
      const double rate = between(0.6, 2.0);
      const double angle = between(0.8, 2.2);
      move(toss(0.5) ? 0.0 : 0.5 * speed, turn * rate, angle / rate);
    }
  }

  void steps() {
    for (int i = 0; i < 4; ++i) {
      const double speed = between(0.03, 0.42);
      move(speed, 0.0, between(0.8, 1.6));
      hold({}, 0.6);
      move(-between(0.6, 1.0) * speed, 0.0, between(0.8, 1.6));
      hold({}, 0.4);
    }
    const double rate = between(0.5, 2.5);
    move(0.0, rate, between(0.8, 1.6));
    hold({}, 0.4);
    move(0.0, -rate, between(0.8, 1.6));
  }

  // A slow triangle through zero, of both wheels alike or against each other.
  void ramps() {
    const double peak = between(0.06, 0.2);
    const double ramp_s = between(2.0, 3.5);
    const double right_sign = toss(0.5) ? 1.0 : -1.0;
    for (double t = 0.0; t < 4.0 * ramp_s; t += period_s_) {
      const double share = 2.0 / std::numbers::pi * std::asin(std::sin(0.5 * std::numbers::pi * t / ramp_s));
      hold({peak * share, right_sign * peak * share}, period_s_);
    }
  }

  void reversals() {
    for (int i = 0; i < 8; ++i) {
      const double speed = between(0.04, 0.3);
      const double turn = toss(0.3) ? between(-0.6, 0.6) : 0.0;
      const double seconds = between(0.5, 1.1);
      move(speed, turn, seconds);
      move(-speed, -turn, seconds);
    }
  }

  void forward_part() {
    const double speed = between(0.08, 0.35);
    move(speed, between(-0.6, 0.6) * 2.0 * speed / wheel_base_m_, between(0.8, 3.0));
  }

  void straight_part() {
    const double speed = between(0.05, 0.4);
    move(speed, 0.0, between(0.8, 2.0));
    if (toss(0.7)) move(-between(0.5, 1.0) * speed, 0.0, between(0.8, 2.0));
    if (toss(0.3)) hold({}, 0.5);
  }

  std::size_t rows_;
  double period_s_;
  double wheel_base_m_;
  std::mt19937_64 random_;
  std::vector<WheelPair> commands_;
  std::vector<int> parts_;
};

}  // namespace

std::string_view name_of(Program program) {
  return program_names.at(static_cast<std::size_t>(program));
}

std::optional<Program> program_named(std::string_view name) {
  const auto* found = std::find(program_names.begin(), program_names.end(), name);
  if (found == program_names.end()) return std::nullopt;
  return static_cast<Program>(found - program_names.begin());
}

std::vector<WheelPair> drive_commands(Program program, double seconds, double period_s, double wheel_base_m,
                                      std::uint64_t seed) {
  return Driver(seconds, period_s, wheel_base_m, seed).drive(program);
}

}  // namespace wheelwright::test
