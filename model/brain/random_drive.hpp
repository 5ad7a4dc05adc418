// The random drive of the ARMA calibration (calibration C of the source paper): normally distributed speeds,
// each held for a random time, that stay inside a circle; and then a tour of that circle (tour.hpp).
//
// The random speeds show the dynamics. With friction, a gain depends on the speed, and the random speeds give
// the gains at the speeds that happened to be drawn. This is the main difference between two calibrations of
// a minute. The tour shows the gains at the speeds of a route.
//
// A draw that would leave the circle is replaced by its negative, which goes back the way it came. A normal
// deviate and its negative are equally likely, so the distribution of speeds stays as it is. If both would
// leave the circle, another pair is drawn.
//
// With a model, the pose is the one that the model predicts from the commands. The commands are then a
// function of seed, model and first pose. The same drive can be repeated, and an encoder that fails on the
// way cannot lead the robot out of its circle. No noise of the sensors gets into the commands, which would
// bias the identification (closed loop). Without a model nobody knows what a command does, and staying in the
// circle comes first: the pose is then that of odometry. Its noise has little influence, because only the
// choice between a draw and its negative depends on it. A tour is steered all the time, so there is none.
#pragma once

#include <cstdint>
#include <optional>

#include "model/brain/mission.hpp"
#include "model/brain/portable_random.hpp"
#include "model/brain/tour.hpp"
#include "model/geometry/pose.hpp"

namespace wheelwright {

// Does not allocate. The same seed and the same poses give the same speeds, on every platform.
class RandomDrive {
 public:
  RandomDrive(const RandomDrivePlan& plan, const RobotLimits& limits);

  // Back to the start, with the same draws to come. Without a model there is no tour, and the random speeds
  // last as long as both.
  void restart(bool has_model = true);

  // Wheel speeds wanted for the coming period, in m/s on the floor; nothing once the tour is over and the
  // robot has had time to come to rest. `rest` is the pose at which the robot would come to rest if it were
  // stopped now, as seen from where the run began. Once inside the circle it stays there, as far as wheels do
  // what is wanted of them; from outside it never leads further out.
  std::optional<WheelPair> next(const Pose& rest);

 private:
  void draw(const Pose& rest);
  WheelPair random_speed(const Pose& rest);
  WheelPair within_limits(const WheelPair& wanted) const;
  double from_middle_m(const Pose& pose) const;
  bool stays_inside(const Pose& rest, const WheelPair& speed) const;

  RandomDrivePlan plan_;
  double period_s_;
  double wheel_base_m_;
  double largest_speed_m_s_;
  int random_ticks_ = 0;  // of the random speeds; a rest follows, and the tour, and a rest
  int tour_ticks_ = 0;
  int rest_ticks_;
  PortableRandom random_;
  Tour tour_;
  int tick_ = 0;
  int hold_ = 0;  // ticks for which the present speeds are still to be held
  WheelPair speed_m_s_;
};

}  // namespace wheelwright
