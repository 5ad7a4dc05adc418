#pragma once

#include "tests/benchmark/plants/wheels.hpp"
#include "tests/benchmark/second_plant/battery.hpp"
#include "tests/benchmark/second_plant/firmware.hpp"
#include "tests/benchmark/second_plant/floor.hpp"
#include "tests/benchmark/second_plant/friction.hpp"
#include "tests/benchmark/second_plant/gear.hpp"
#include "tests/benchmark/second_plant/grease.hpp"
#include "tests/benchmark/second_plant/motor.hpp"
#include "tests/benchmark/second_plant/odd_force.hpp"
#include "tests/benchmark/second_plant/tyre.hpp"
#include "tests/benchmark/second_plant/undercarriage.hpp"
#include "tests/benchmark/second_plant/wheel_controller.hpp"

namespace plants::second {

struct BodySpec {
  double mass_kg = 3.5;
  double yaw_inertia_kg_m2 = 0.05;
  double nominal_track_m = 0.25;  // what the log's header says
  double true_track_m = 0.25;     // between the points where the tyres really touch
};

struct EncoderSpec {
  int ticks_per_turn = 400;
  double outages_per_run = 0.0;
  double shortest_outage_s = 0.1;
  double longest_outage_s = 0.2;
};

// One robot in one room. A spec as drawn is linear; each effect changes a few numbers of it.
struct RobotSpec {
  double period_s = 0.018;
  double fastest_m_s = 0.4;
  FirmwareSpec firmware;
  OddCommandSpec odd_command;
  ControllerSpec controller;
  MotorSpec motor;
  FrictionSpec friction;
  GreaseSpec grease;
  GearSpec gear;
  PerWheel<TyreSpec> tyre;
  BodySpec body;
  UndercarriageSpec undercarriage;
  FloorSpec floor;
  BatterySpec battery;
  OddForceSpec odd_force;
  EncoderSpec encoder;
  double reference_x_m = 0.0;  // where on the body the outside reference looks
  double reference_y_m = 0.0;

  // Force per wheel that costs 1 m/s of wheel speed, with the controller's help.
  [[nodiscard]] double drive_stiffness_n_s_m() const {
    const double loop_v_s_m = motor.emf_v_s_m + controller.proportional_v_s_m;
    return motor.emf_v_s_m * loop_v_s_m / motor.resistance_ohm + tyre[left_side].hub_drag_n_s_m;
  }

  // Moment that costs 1 rad/s of turn rate.
  [[nodiscard]] double turn_stiffness_n_m_s() const {
    return 0.5 * body.true_track_m * body.true_track_m * drive_stiffness_n_s_m();
  }
};

}  // namespace plants::second
