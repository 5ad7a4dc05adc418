#pragma once

#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/third_plant/derating.hpp"
#include "tests/benchmark/third_plant/encoder.hpp"
#include "tests/benchmark/third_plant/episodes.hpp"
#include "tests/benchmark/third_plant/firmware.hpp"
#include "tests/benchmark/third_plant/floor.hpp"
#include "tests/benchmark/third_plant/friction.hpp"
#include "tests/benchmark/third_plant/gear.hpp"
#include "tests/benchmark/third_plant/grease.hpp"
#include "tests/benchmark/third_plant/motor.hpp"
#include "tests/benchmark/third_plant/odd_force.hpp"
#include "tests/benchmark/third_plant/supply.hpp"
#include "tests/benchmark/third_plant/tyre.hpp"
#include "tests/benchmark/third_plant/undercarriage.hpp"
#include "tests/benchmark/third_plant/wheel_controller.hpp"
#include "tests/benchmark/third_plant/wheel_noise.hpp"

namespace plants::third {

// One robot on one floor. A spec as drawn is linear; each effect changes a few numbers of it.
struct RobotSpec {
  double period_s = 0.018;
  double jitter_s = 0.0003;
  double fastest_m_s = 0.35;
  double fastest_turn_rad_s = 2.0;
  double wheel_base_m = 0.25;           // as the log's header says
  double rim_mass_kg = 2.0;             // that one motor moves, at the rim
  double drive_stiffness_n_s_m = 20.0;  // force per wheel that costs 1 m/s without a closed loop
  double quadratic_drag_n_s2_m2 = 0.0;
  FirmwareSpec firmware;
  ControllerSpec controller;
  MotorSpec motor;
  SupplySpec supply;
  GreaseSpec grease;
  FrictionSpec friction;
  WheelNoiseSpec noise;
  PerWheel<GearSpec> gear;
  PerWheel<TyreSpec> tyre;
  UndercarriageSpec undercarriage;
  FloorSpec floor;
  EncoderSpec encoder;
  double marker_x_m = 0.0;  // where on the body the outside reference looks
  double marker_y_m = 0.0;

  // No effects of the library:
  OddForceSpec odd_force;
  DeratingSpec derating;
  EpisodeSpec slips;           // a wheel loses most of its grip
  EpisodeSpec loose_contacts;  // a motor loses its current
};

}  // namespace plants::third
