// Imperfections that have no name in the library.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/benchmark/fourth_plant/block.hpp"
#include "tests/benchmark/fourth_plant/delay_line.hpp"

namespace plants::fourth {

// Happens at random moments and lasts; `size` is drawn again each time.
struct Episode {
  double per_s;
  double shortest_s;
  double longest_s;
  double until_s = -1.0;
  double size = 0.0;
  // True while it lasts.
  bool goes_on(double low, double high, const Moment& moment) {
    if (moment.time_s > until_s && moment.random->chance(per_s * moment.step_s)) {
      until_s = moment.time_s + moment.random->uniform(shortest_s, longest_s);
      size = moment.random->uniform(low, high);
    }
    return moment.time_s <= until_s;
  }
};

struct SpinningWheel {
  Episode episode;
  double min_grip;
  double operator()(double input, const Moment& moment) {
    return episode.goes_on(min_grip, 0.6, moment) ? episode.size * input : input;
  }
};

struct BreathingGain {
  double swing;
  double period_s;
  double start_rad = -1.0;
  double operator()(double input, const Moment& moment) {
    if (start_rad < 0.0) start_rad = moment.random->uniform(0.0, 2.0 * std::numbers::pi);
    return input * (1.0 + swing * std::sin(2.0 * std::numbers::pi * moment.time_s / period_s + start_rad));
  }
};

// The gain remembers how hard the motor has worked lately.
struct TiringGain {
  double loss;
  double memory_s;
  double top_m_s;
  double worked = 0.0;
  double operator()(double input, const Moment& moment) {
    const double work = input / top_m_s * (input / top_m_s);
    worked += moment.step_s / memory_s * (work - worked);
    return input * (1.0 - loss * worked);
  }
};

// Small commands travel longer than large ones.
class SlowForSmall {
 public:
  SlowForSmall(double longest_s, double top_m_s, double step_s)
      : longest_s_(longest_s), top_m_s_(top_m_s), line_(steps_in(longest_s, step_s), 0.0) {}
  double operator()(double input, const Moment& moment) {
    line_.step(input);
    const double size = std::min(1.0, std::abs(input) / top_m_s_);
    return line_.back(steps_in(longest_s_ * (1.0 - size), moment.step_s));
  }

 private:
  double longest_s_;
  double top_m_s_;
  DelayLine<double> line_;
};

// A filter that hurries after large errors and dawdles after small ones.
struct HurryingFilter {
  double lag_s;
  double error_m_s;  // at which the lag is as given
  double output_m_s = 0.0;
  double operator()(double input, const Moment& moment) {
    const double error = input - output_m_s;
    output_m_s += moment.step_s / lag_s * error * std::min(4.0, std::abs(error) / error_m_s);
    return output_m_s;
  }
};

// Each wheel takes a share of the other's command that grows with its square.
struct Crosstalk {
  double share;
  double top_m_s;
  PerWheel<double> operator()(PerWheel<double> input, const Moment& /*moment*/) const {
    const auto taken = [this](double other) { return share * other * std::abs(other) / top_m_s; };
    return {input[left_side] - taken(input[right_side]), input[right_side] + taken(input[left_side])};
  }
};

// Packets get lost: the robot goes on with the last one that came.
struct LostPackets {
  Episode episode;
  PerWheel<double> held{};
  PerWheel<double> operator()(PerWheel<double> input, const Moment& moment) {
    if (!episode.goes_on(0.0, 1.0, moment)) held = input;
    return held;
  }
};

struct Push {
  Episode episode;
  double hardest_m_s;
  Twist operator()(Twist twist, const Moment& moment) {
    constexpr double turn_of_push_rad_m = 4.0;
    if (!episode.goes_on(-hardest_m_s, hardest_m_s, moment)) return twist;
    return {twist.forward_m_s + episode.size, twist.left_m_s,
            twist.turn_rad_s + turn_of_push_rad_m * episode.size};
  }
};

// A tyre comes off its groove in the middle of the run.
struct JumpingDiameter {
  double scale;
  double earliest_s;
  double latest_s;
  double jump_s = -1.0;
  double operator()(double input, const Moment& moment) {
    if (jump_s < 0.0) jump_s = moment.random->uniform(earliest_s, latest_s);
    return moment.time_s > jump_s ? scale * input : input;
  }
};

// A cable that winds up holds the turn back the more, the further it is from where it hung free, and at last
// snaps.
struct WindingCable {
  double rate_rad_s;  // at the twist at which it snaps
  double snaps_rad;
  double wound_rad = 0.0;
  Twist operator()(Twist twist, const Moment& moment) {
    const double share = wound_rad / snaps_rad;
    const double moving = std::tanh(std::abs(twist.forward_m_s) / 0.02);
    twist.turn_rad_s -= rate_rad_s * share * share * share * moving;
    wound_rad += twist.turn_rad_s * moment.step_s;
    if (std::abs(wound_rad) > snaps_rad) wound_rad = 0.0;
    return twist;
  }
};

}  // namespace plants::fourth
