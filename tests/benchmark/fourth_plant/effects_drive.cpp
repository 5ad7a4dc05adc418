// Effects of motor, supply, gear and encoder.
#include <numbers>

#include "tests/benchmark/fourth_plant/command_blocks.hpp"
#include "tests/benchmark/fourth_plant/effects.hpp"
#include "tests/benchmark/fourth_plant/wheel_blocks.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fourth {

namespace {

// Large: in a proportional loop, which leaves about half of it.
std::string hide_coulomb_friction(const Setting& setting) {
  const double level_m_s = drawn(setting, {0.012, 0.016}, {0.06, 0.075});
  for (DriveSpec& drive : setting.robot().drives)
    drive.friction = {.moving_m_s = level_m_s, .breakaway_m_s = level_m_s};
  return "dry friction takes " + fixed(1000.0 * level_m_s, 0) + " mm/s of the drive";
}

std::string hide_stiction(const Setting& setting) {
  const double level_m_s = drawn(setting, {0.035, 0.042}, {0.085, 0.1});
  for (DriveSpec& drive : setting.robot().drives) drive.friction = {.breakaway_m_s = level_m_s};
  return "Stribeck friction: " + fixed(1000.0 * level_m_s, 0) +
         " mm/s of drive to break away, none when rolling";
}

std::string hide_voltage_sag(const Setting& setting) {
  BatterySpec& battery = setting.robot().battery;
  const double sag_share = drawn(setting, {0.06, 0.08}, {0.15, 0.18});
  battery.sag_v = sag_share * battery.full_v;
  battery.fall_v_s = (setting.large ? 0.0025 : 0.001) * battery.full_v;
  battery.fall_between_v = (setting.large ? 0.03 : 0.01) * battery.full_v;
  add_to_both(setting.diagram().drive, SupplyGain{battery.full_v});
  setting.experiment.sensors.battery = true;
  return "weak battery: sags by " + fixed(battery.sag_v, 2) +
         " V under load and runs down; gain as the volts";
}

std::string hide_gain_drift(const Setting& setting) {
  const double change = drawn(setting, {0.05, 0.065}, {0.14, 0.2});
  const double time_constant_s = setting.random.uniform(15.0, 30.0);
  add_to_both(setting.diagram().drive, WarmingGain{change, time_constant_s});
  return "warming up adds " + fixed(100.0 * change, 1) + " % of gain in " + fixed(time_constant_s, 0) + " s";
}

// Large: the encoder sits on the motor's side of the play and sees none of it.
std::string hide_backlash(const Setting& setting) {
  const double gap_m = drawn(setting, {0.004, 0.006}, {0.011, 0.015});
  const bool unseen = setting.large && setting.experiment.sensors.poses;
  add_to_both(unseen ? setting.diagram().floor : setting.diagram().gear, Play{gap_m});
  return "play of " + fixed(1000.0 * gap_m, 1) + " mm, encoder on the " + (unseen ? "motor" : "wheel");
}

// Small: a gear runs untrue before the encoder; large: the wheels do behind it.
std::string hide_eccentricity(const Setting& setting) {
  const double ripple = drawn(setting, {0.04, 0.055}, {0.08, 0.1});
  PerWheel<Chain>& chains = setting.large ? setting.diagram().floor : setting.diagram().gear;
  for (Chain& chain : chains) {
    const double start_rad = setting.random.uniform(0.0, 2.0 * std::numbers::pi);
    chain.push_back(OncePerTurn{ripple, setting.robot().metres_per_turn, start_rad, setting.large});
  }
  return fixed(100.0 * ripple, 1) + " % ripple once per turn, " +
         (setting.large ? "of the wheels on the floor" : "of gears that the encoders see");
}

// Small: a register that hangs and catches up; large: a dirty disc.
std::string hide_dropout(const Setting& setting) {
  const Range lasting = setting.large ? Range{0.5, 1.5} : Range{0.15, 0.35};
  const double per_s = drawn(setting, {0.06, 0.08}, {0.15, 0.2});
  add_to_both(setting.diagram().count, Dropout{per_s, lasting.low, lasting.high, !setting.large});
  return "counts stand still for " + fixed(lasting.low, 2) + " to " + fixed(lasting.high, 2) + " s, " +
         (setting.large ? "and are lost" : "and then catch up");
}

}  // namespace

std::vector<Effect> drive_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"coulomb_friction",
       {.programme = stairs, .loop = Loop::open, .confusable = "dead_zone"},
       {.programme = random_steps, .loop = Loop::proportional},
       hide_coulomb_friction},
      {"stiction",
       {.programme = stairs, .loop = Loop::open, .confusable = "dead_zone"},
       {.programme = multi_sine, .loop = Loop::open},
       hide_stiction},
      {"voltage_sag",
       {.programme = random_steps, .loop = Loop::open},
       {.programme = stop_and_go, .loop = Loop::open},
       hide_voltage_sag},
      {"gain_drift",
       {.programme = multi_sine, .loop = Loop::open, .confusable = "voltage_sag"},
       {.sensing = poses, .programme = laps, .loop = Loop::open, .confusable = "voltage_sag"},
       hide_gain_drift},
      {"backlash",
       {.programme = stop_and_go},
       {.sensing = ticks_and_poses, .programme = chirp},
       hide_backlash},
      {"wheel_eccentricity",
       {.programme = stop_and_go},
       {.sensing = ticks_and_poses, .programme = laps, .pose_every_s = 0.0},
       hide_eccentricity},
      {"encoder_dropout", {.programme = waypoints}, {.programme = random_steps}, hide_dropout},
  };
}

}  // namespace plants::fourth
