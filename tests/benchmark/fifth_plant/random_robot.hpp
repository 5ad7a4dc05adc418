#pragma once

#include "tests/benchmark/fifth_plant/robot.hpp"
#include "tests/benchmark/plants/random.hpp"

namespace plants::fifth {

// How much a motor gives way to a load: with a feed-forward of voltage it does, with an integral it does so
// for a moment.
enum class Drive { any, soft, stiff };

// A robot in which nothing is hidden: motors with current, viscous gears, tyres that creep by parts of a
// thousandth, noise.
Robot random_robot(Drive drive, Random& random);

// Torque on a wheel that takes so much of its speed, in a soft drive.
double torque_n_m(const Robot& robot, double loss_m_s);
// Force on the body that takes so much of its speed.
double force_n(const Robot& robot, double loss_m_s);
// Yaw moment that takes so much of its turn rate.
double moment_n_m(const Robot& robot, double loss_rad_s);
// Voltage that holds a speed.
double volts(const Robot& robot, double speed_m_s);

void set_both(Robot& robot, double GearSpec::*quantity, double value);
void set_both(Robot& robot, double DriverSpec::*quantity, double value);

}  // namespace plants::fifth
