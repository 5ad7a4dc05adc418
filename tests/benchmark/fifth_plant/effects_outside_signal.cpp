// Without a name in the contract: links, loops and sensors.
#include "tests/benchmark/fifth_plant/effects.hpp"
#include "tests/benchmark/plants/text.hpp"

namespace plants::fifth {

namespace {

// The last command goes on for a while, and then the newest one is there at once: no delay that stays.
std::string hide_stalls(const Setting& setting) {
  FirmwareSpec& firmware = setting.robot().firmware;
  firmware.stall_every_s = setting.random.uniform(3.5, 5.0);
  firmware.stall_s = setting.drawn(0.25, 0.35, 0.6, 0.9);
  return "the radio link stands still for " + fixed(firmware.stall_s, 2) + " s every " +
         fixed(firmware.stall_every_s, 1) + " s";
}

std::string hide_hunting(const Setting& setting) {
  FirmwareSpec& firmware = setting.robot().firmware;
  firmware.hunting_m_s = setting.drawn(0.022, 0.03, 0.05, 0.07);
  firmware.hunting_period_s = setting.random.uniform(1.1, 1.9);
  return "a heading hold swings by " + fixed(firmware.hunting_m_s, 4) + " m/s of each wheel every " +
         fixed(firmware.hunting_period_s, 2) + " s";
}

// The positions are right.
std::string hide_iron(const Setting& setting) {
  TrackerSpec& tracker = setting.robot().tracker;
  tracker.iron_rad = setting.drawn(0.04, 0.06, 0.15, 0.25);
  tracker.iron_twice_rad = 0.4 * tracker.iron_rad;
  tracker.iron_phase_rad = setting.random.uniform(-3.0, 3.0);
  return "the heading comes from a compass beside iron: " + fixed(tracker.iron_rad, 3) +
         " rad once a turn and " + fixed(tracker.iron_twice_rad, 3) + " rad twice";
}

std::string hide_crosstalk(const Setting& setting) {
  EncoderSpec& encoder = setting.robot().encoder;
  encoder.crosstalk = setting.drawn(0.06, 0.09, 0.2, 0.3);
  encoder.crosstalk_from_m_s = 0.3 * setting.robot().top_m_s;
  return "the right counter sees " + fixed(100.0 * encoder.crosstalk, 1) +
         " % of the left wheel's edges beyond " + fixed(encoder.crosstalk_from_m_s, 2) + " m/s";
}

}  // namespace

std::vector<Effect> outside_signal_effects() {
  using enum Sensing;
  using enum Programme;
  return {
      {"radio_stalls",
       {.programme = teleoperation},
       {.sensing = ticks_and_poses, .programme = docking},
       hide_stalls},
      {"hunting_heading_hold",
       {.programme = laps},
       {.sensing = ticks_and_poses, .programme = patrol},
       hide_hunting},
      {"iron_near_compass",
       {.sensing = ticks_and_poses, .programme = laps},
       {.sensing = ticks_and_poses, .programme = teleoperation},
       hide_iron},
      {"encoder_crosstalk",
       {.sensing = ticks_and_poses, .programme = teleoperation},
       {.sensing = ticks_and_poses, .programme = laps},
       hide_crosstalk},
  };
}

}  // namespace plants::fifth
