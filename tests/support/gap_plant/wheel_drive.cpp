#include "tests/support/gap_plant/wheel_drive.hpp"

#include <cmath>
#include <numbers>

namespace wheelwright::test {
namespace {

double sign_of(double value) {
  return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0);
}

// A class-B output stage: each transistor conducts above its threshold, with a soft knee.
double class_b(double wanted, double threshold) {
  const double knee = 0.1 * threshold;
  const auto conducts = [knee](double above) {
    return 0.5 * (above + std::sqrt(above * above + knee * knee));
  };
  return conducts(wanted - threshold) - conducts(-wanted - threshold);
}

// A rail is approached within a few per cent before it is met.
double below_rail(double wanted, double rail) {
  constexpr double sharpness = 14.0;
  return wanted / std::pow(1.0 + std::pow(std::abs(wanted) / rail, sharpness), 1.0 / sharpness);
}

}  // namespace

WheelDrive::WheelDrive(const PlantParameters& robot, double motor_gain, double dt_s, double hour,
                       double phase_rad, std::uint64_t seed)
    : robot_(robot),
      motor_gain_(motor_gain),
      dt_s_(dt_s),
      phase_rad_(phase_rad),
      cogging_(robot.clock_cogging_m_s * std::pow(std::sin(std::numbers::pi * hour / 24.0), 2)),
      in_flight_(static_cast<std::size_t>(std::lround((robot.delay_s + robot.extra_delay_s) / dt_s)) + 1,
                 0.0),
      friction_(robot.sliding_friction_m_s, robot.breakaway_friction_m_s),
      play_(robot.play_m),
      random_(seed) {}

double WheelDrive::received(double command, double other_command) {
  if (robot_.cross_talk > 0.0 && command > 0.0 && other_command < 0.0) {
    command += robot_.cross_talk * std::sqrt(-command * other_command);
  }
  if (robot_.command_step_m_s > 0.0) {
    command = robot_.command_step_m_s * std::round(command / robot_.command_step_m_s);
  }
  if (std::abs(command) < robot_.firmware_threshold_m_s) command = 0.0;
  in_flight_[next_] = command;
  next_ = (next_ + 1) % in_flight_.size();
  const double arrived = in_flight_[next_];
  constexpr double memory_s = 6.0;
  history_ += dt_s_ / memory_s * (std::abs(arrived) / 0.2 - history_);
  return arrived * (1.0 - robot_.history_gain * history_ * history_ / (0.5 + history_ * history_));
}

double WheelDrive::amplified(double wanted, double supply) {
  if (robot_.crossover_m_s > 0.0) wanted = class_b(wanted, robot_.crossover_m_s);
  if (std::isfinite(robot_.rail_m_s)) wanted = below_rail(wanted, robot_.rail_m_s);
  if (std::isfinite(robot_.slew_m_s2)) {
    const double most = robot_.slew_m_s2 * dt_s_;
    slewed_ += most * std::tanh((wanted - slewed_) / most);
    wanted = slewed_;
  }
  lagged_ += dt_s_ / robot_.amplifier_lag_s * (wanted - lagged_);
  return lagged_ * supply * motor_gain_;
}

// Voltage against back-EMF over the winding's resistance, which rises as it warms.
double WheelDrive::motor_force(double drive, double speed) const {
  const double back_emf_share = 1.0 - robot_.viscous_share;
  const double favour = robot_.brush_advance / (2.0 * back_emf_share) * sign_of(speed);
  const double warm_loss = robot_.warm_loss_share * (1.0 - std::exp(-time_s_ / robot_.warming_s));
  const double resistance = 1.0 + warm_loss / ((1.0 - warm_loss) * robot_.viscous_share);
  double force = (drive - back_emf_share * (1.0 - favour) * speed) / resistance;
  if (force * speed < 0.0) force *= 1.0 - robot_.missing_brake_share;
  return force;
}

double WheelDrive::losses(double speed, double rim_m) {
  double loss = robot_.viscous_share * speed + friction_.step(speed, dt_s_);
  loss += robot_.windage_share / (1.0 - robot_.windage_share) * speed * std::abs(speed) / 0.3;
  constexpr double thin_m_s = 0.12;
  loss += robot_.grease_share / (1.0 - robot_.grease_share) * speed / (1.0 + std::pow(speed / thin_m_s, 2));
  constexpr double teeth = 24.0;
  loss += cogging_ * std::sin(teeth * rim_m / robot_.wheel_radius_m + phase_rad_);
  return loss;
}

double WheelDrive::force_m_s(double command, double other_command, double supply, double rim_speed_m_s,
                             double rim_m) {
  time_s_ += dt_s_;
  const double reference = received(command, other_command);
  const double error = reference - rim_speed_m_s;
  integral_m_ += dt_s_ * (error - integral_m_ / robot_.controller_leak_s);
  const double wanted = robot_.controller_gain > 0.0 ? reference + robot_.controller_gain * error +
                                                           robot_.controller_integral_hz * integral_m_
                                                     : reference;
  double drive = amplified(wanted, supply);
  if (robot_.resonance_share > 0.0) drive += robot_.resonance_share * (spring_.step(drive, dt_s_) - drive);
  // An unsteady load, correlated over 20 ms; the rim's inertia takes half of its size away.
  constexpr double correlation_s = 0.02;
  const double keep = std::exp(-dt_s_ / correlation_s);
  unsteady_ =
      keep * unsteady_ + std::sqrt(1.0 - keep * keep) * 2.0 * robot_.speed_noise_m_s * normal_(random_);
  return motor_force(drive, rim_speed_m_s) - losses(rim_speed_m_s, rim_m) + unsteady_;
}

double WheelDrive::wheel_m(double motor_m) {
  const double geared = robot_.eccentricity > 0.0 ? eccentric_travel_m(motor_m, robot_.wheel_radius_m,
                                                                       robot_.eccentricity, phase_rad_)
                                                  : motor_m;
  return play_.step(geared);
}

}  // namespace wheelwright::test
