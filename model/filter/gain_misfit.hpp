// Do both wheels roll another distance than the model says, and have they done so for a while?
//
// The filter follows the encoders and the drift test learns the gain that they show, so that a model whose
// gain was wrong from the first metre on leaves no trace in either. Here the travel of the model's free run
// is set against the counts themselves: in blocks of 0.5 s of driving, over the last nine of them, for each
// wheel
//
//   counted = (1 + error) predicted,   error by least squares, its standard error from the scatter
//
// A misfit is an error of more than 4 % by three standard errors on both wheels. One wheel alone is no
// misfit of the model but a fault of that wheel or encoder (fault_detector.hpp).
//
// On some robots the gain depends on the speed (a Create 2 acts in steps of 28 mm/s), and five seconds at one
// speed are off without any change. So the spread of the blocks that have left the window is learnt, and an
// error has to stand out from that too. Where such a robot keeps one speed from the start, nothing tells the
// two apart.
#pragma once

#include <array>
#include <cstddef>

#include "model/geometry/pose.hpp"

namespace wheelwright {

class GainMisfit {
 public:
  explicit GainMisfit(double period_s);

  // Takes the travel of a tick, by the model and by the counts, in metres. Allocates nothing.
  void take(const WheelPair& predicted_m, const WheelPair& counted_m);
  // This tick says nothing: the block that it is in does not count.
  void drop_block();
  // Nothing that came so far counts.
  void restart();

  bool found() const;
  // Relative to the model's travel; 0 before all blocks are there.
  WheelPair error() const;

 private:
  static constexpr std::size_t blocks = 9;

  struct Wheel {
    double predicted_m = 0.0;  // of the present block
    double counted_m = 0.0;
    std::array<double, blocks> past_predicted_m{};
    std::array<double, blocks> past_counted_m{};
    // Of the blocks that have left the window: weights, and weighted relative errors and their squares.
    double weight = 0.0;
    double error = 0.0;
    double square = 0.0;
  };
  struct Error {
    double value = 0.0;
    double standard_error = 0.0;
  };

  static Error error_of(const Wheel& wheel);
  static void learn(Wheel& wheel, double predicted_m, double counted_m);
  double spread_of(const Wheel& wheel) const;

  int ticks_per_block_;
  int ticks_ = 0;
  std::array<Wheel, 2> wheels_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
  std::size_t learnt_ = 0;
};

}  // namespace wheelwright
