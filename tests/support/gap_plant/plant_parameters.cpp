#include "tests/support/gap_plant/plant_parameters.hpp"

#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>

namespace wheelwright::test {
namespace {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool toss() { return between(0.0, 1.0) < 0.5; }
  double sign() { return toss() ? 1.0 : -1.0; }

 private:
  std::mt19937_64 random_;
};

using Hide = std::function<std::string(PlantParameters&, double, Chance&)>;

std::string signed_words(double sign, const char* positive, const char* negative) {
  return sign > 0.0 ? positive : negative;
}

const std::map<std::string_view, Hide>& command_effects() {
  static const std::map<std::string_view, Hide> table{
      {"dead_zone",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const bool firmware = chance.toss();
         (firmware ? robot.firmware_threshold_m_s : robot.crossover_m_s) = size;
         return firmware ? "firmware ignores small commands" : "crossover of the output stage";
       }},
      {"saturation",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.rail_m_s = size;
         return "rail of the amplifier";
       }},
      {"rate_limit",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.slew_m_s2 = size;
         return "slew rate of the amplifier";
       }},
      {"command_quantization",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.command_step_m_s = size;
         return "coarse pulse width";
       }},
      {"transport_delay",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.extra_delay_s = size;
         return "buffer of the radio link";
       }},
      {"voltage_sag",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.supply_fall_share = size;
         return "unregulated drive";
       }},
      {"outside_cross_talk",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.cross_talk = size;
         return "left forward and right backward at once share a driver";
       }},
      {"outside_history_gain",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.history_gain = size;
         return "current limit that remembers 6 s of commands";
       }},
  };
  return table;
}

const std::map<std::string_view, Hide>& motor_effects() {
  static const std::map<std::string_view, Hide> table{
      {"coulomb_friction",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.sliding_friction_m_s = robot.breakaway_friction_m_s = size;
         return "LuGre friction without Stribeck rise";
       }},
      {"stiction",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.breakaway_friction_m_s = size;
         robot.sliding_friction_m_s = 0.1 * size;
         return "LuGre friction that is gone at 20 mm/s";
       }},
      {"gain_curve",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const bool windage = chance.toss();
         (windage ? robot.windage_share : robot.grease_share) = size;
         return windage ? "quadratic drag" : "grease that thins with speed";
       }},
      {"direction_gain",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const double sign = chance.sign();
         robot.brush_advance = sign * size;
         return signed_words(sign, "brushes favour forward", "brushes favour reverse");
       }},
      {"asymmetric_response",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.missing_brake_share = size;
         return "amplifier that hardly brakes";
       }},
      {"gain_drift",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         robot.warm_loss_share = size;
         robot.warming_s = chance.between(15.0, 35.0);
         return "winding that warms";
       }},
      {"backlash",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.play_m = size;
         return "play of the gear before the encoder";
       }},
      {"wheel_eccentricity",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.eccentricity = size;
         return "eccentric last gear";
       }},
      {"outside_resonance",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.resonance_share = size;
         return "drive through a hysteretic spring";
       }},
      {"outside_clock_cogging",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.clock_cogging_m_s = size;
         return "cogging that comes and goes with the time of day";
       }},
  };
  return table;
}

const std::map<std::string_view, Hide>& body_effects() {
  static const std::map<std::string_view, Hide> table{
      {"wheel_scale_mismatch",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const double sign = chance.sign();
         robot.rolling.left *= 1.0 + 0.5 * sign * size;
         robot.rolling.right *= 1.0 - 0.5 * sign * size;
         return signed_words(sign, "left wheel larger", "right wheel larger");
       }},
      {"effective_track",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.track_share = size;
         return "wheels touch at their outer edges";
       }},
      {"distance_scale",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const double scale = 1.0 + chance.sign() * size;
         robot.rolling.left *= scale;
         robot.rolling.right *= scale;
         return scale > 1.0 ? "tyres pumped up" : "tyres pressed flat";
       }},
      {"acceleration_slip",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.hop_share = size;
         return "tyre curve under hopping wheels";
       }},
      {"turn_speed_loss",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.turn_drag_m = size;
         return "caster dragged sideways";
       }},
      {"turn_scrub",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.scrub_share = size;
         return "scrub torque of wide tyres";
       }},
      {"yaw_bias",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const double sign = chance.sign();
         robot.yaw_bias_rad_s = sign * size;
         return signed_words(sign, "side brush pulls to the left", "side brush pulls to the right");
       }},
      {"floor_slope",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         robot.slope_m_s = size;
         robot.uphill_rad = chance.between(-std::numbers::pi, std::numbers::pi);
         return "inclined floor";
       }},
      {"surface_patch",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.patch_share = size;
         return "rug";
       }},
      {"caster_kick",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         robot.caster_kick_rad = chance.sign() * size;
         robot.caster_turns_on = chance.toss();
         return robot.caster_turns_on ? "caster that turns on round" : "caster that swings to and fro";
       }},
      {"lever_arm",
       [](PlantParameters& robot, double size, Chance& chance) -> std::string {
         const double angle = chance.between(-std::numbers::pi, std::numbers::pi);
         robot.measured_point = move_along_arc({0.0, 0.0, angle}, {size, 0.0}, 1.0);
         return "marker beside the middle of the axle";
       }},
      {"encoder_dropout",
       [](PlantParameters& robot, double size, Chance&) -> std::string {
         robot.dropout_share = size;
         return "counts lost in bursts";
       }},
  };
  return table;
}

}  // namespace

PlantParameters random_robot(std::uint64_t seed) {
  Chance chance(seed ^ 0x9e3779b97f4a7c15ULL);
  PlantParameters robot;
  robot.delay_s = chance.between(0.018, 0.05);
  robot.amplifier_lag_s = chance.between(0.01, 0.03);
  robot.response_s = chance.between(0.05, 0.09);
  robot.yaw_response_ratio = chance.between(0.7, 1.1);
  robot.viscous_share = chance.between(0.3, 0.45);
  robot.motor_gain = {chance.between(0.97, 1.03), chance.between(0.97, 1.03)};
  robot.reference_noise_m = chance.between(0.001, 0.002);
  robot.reference_noise_rad = chance.between(0.002, 0.004);
  robot.slip_noise_share = chance.between(0.001, 0.003);
  robot.speed_noise_m_s = chance.between(0.0003, 0.001);
  robot.gyro_bias_rad_s = chance.between(-0.01, 0.01);
  if (chance.between(0.0, 1.0) < 0.3) {
    robot.controller_gain = 0.7;
    robot.controller_integral_hz = 4.0;
    robot.response_s *= 2.0;
  }
  return robot;
}

std::string hide(PlantParameters& robot, const HiddenEffect& effect, double size, std::uint64_t seed,
                 bool encoders_only) {
  std::uint64_t mixed = seed;
  for (const char letter : effect.name) mixed = mixed * 1099511628211ULL + static_cast<unsigned char>(letter);
  Chance chance(mixed);
  for (const auto* table : {&command_effects(), &motor_effects(), &body_effects()}) {
    const auto found = table->find(effect.name);
    if (found == table->end()) continue;
    std::string how = found->second(robot, size, chance);
    if (table == &body_effects()) robot.upset_loads_motors = encoders_only || chance.toss();
    return how;
  }
  throw std::logic_error("no way to hide " + std::string(effect.name));
}

}  // namespace wheelwright::test
