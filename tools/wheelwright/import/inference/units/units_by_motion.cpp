#include "tools/wheelwright/import/inference/units/units_by_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "config/load/ascii_text.hpp"
#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/conversion/wheel_travel.hpp"
#include "tools/wheelwright/import/inference/response_rows.hpp"
#include "tools/wheelwright/import/inference/units/gain_units.hpp"
#include "tools/wheelwright/import/inference/units/reference_units.hpp"
#include "tools/wheelwright/import/inference/units/register_units.hpp"
#include "tools/wheelwright/import/inference/units/row_counts.hpp"
#include "tools/wheelwright/import/inference/wheel_directions.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

using config::fixed_number;
using config::plain_number;
using std::numbers::pi;

constexpr double min_unit_explained = 0.1;
constexpr double unit_nats = 50.0;

class UnitFinder {
 public:
  UnitFinder(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
             std::vector<std::string>& findings, std::vector<std::string>& doubts)
      : columns_(columns), given_(given), mapping_(mapping), findings_(findings), doubts_(doubts) {}

  void run() {
    if (mapping_.command && mapping_.wheels) {
      const auto rows = response_rows(columns_, mapping_);
      for (std::size_t k = 0; k < 2; ++k) fits_[k] = fit_response(rows[k]);
      gain_ = fits_[0].explained >= fits_[1].explained || mapping_.command->is_of_body() ? fits_[0].gain
                                                                                         : fits_[1].gain;
      explained_ = mapping_.command->is_of_body() ? fits_[0].explained
                                                  : std::max(fits_[0].explained, fits_[1].explained);
      if (is_sure()) {
        by_gain();
        check_gain();
        doubt_weak_evidence();
      }
      suggest_base();
    }
    if (mapping_.reference && mapping_.wheels && mapping_.wheel_base_m)
      set_reference_units(columns_, given_, directions(), mapping_, findings_);
  }

 private:
  std::array<double, 2> directions() const { return wheel_directions(mapping_, fits_); }

  // Coarse counts and stamps that jitter hide a speed that is sure all the same.
  bool is_sure() const {
    return explained_ >= unit_explained ||
           (explained_ >= min_unit_explained && fits_[0].nats + fits_[1].nats >= unit_nats);
  }

  std::string evidence() const {
    return " (the command explains " + fixed_number(100.0 * explained_, 1) +
           " % of the speed, log-likelihood gain " + fixed_number(fits_[0].nats + fits_[1].nats, 0) + ")";
  }

  bool unit_is_said() const { return given_.says("command.unit"); }

  // Whole numbers of commands and wheels alike, which no one gives a unit, and which are too large for
  // others.
  void take_both_for_millimetres() {
    if (are_registers(columns_, given_, mapping_, findings_)) return;
    constexpr double fastest_cm_s = 100.0;
    constexpr double fastest_mm_s = 3000.0;
    WheelMapping& wheels = *mapping_.wheels;
    CommandMapping& command = *mapping_.command;
    const double most = largest(columns_.command[0]);
    const bool are_named = wheels.unit_assumed && command.kind == CommandKind::wheels &&
                           command.unit == "m/s" && !unit_is_said() && !given_.says("wheels.unit");
    if (wheels.kind != WheelKind::speed || !are_named || !is_near(std::abs(gain_), 1.0) ||
        !are_whole(columns_.command[0]) || most <= fastest_cm_s || most > fastest_mm_s)
      return;
    wheels.unit = command.unit = "mm/s";
    wheels.unit_assumed = false;
    doubts_.push_back("commands and wheel speeds of up to " + plain_number(most) +
                      " are taken for mm/s; say it otherwise: --set command.unit, --set wheels.unit");
  }

  void by_gain() {
    take_both_for_millimetres();
    if (mapping_.wheels->kind == WheelKind::speed && !given_.says("wheels.unit")) {
      speed_unit();
    }
    if (mapping_.wheels->kind == WheelKind::angle || mapping_.wheels->kind == WheelKind::distance)
      travel_unit();
    if (!wheel_scale(*mapping_.wheels) && !take_scale_of_reference(true)) {
      find_scale();
      if (found_scale_ || !take_scale_of_reference(false)) return;
    }
    const auto scale = wheel_scale(*mapping_.wheels);
    if (!scale) return;
    const double gain_m_s = std::abs(gain_) * *scale;
    if (mapping_.command->is_duty())
      return are_millimetres(gain_m_s) ? take_millimetres(gain_m_s) : find_full_scale(gain_m_s);
    if (unit_is_said() || !(gain_m_s > 0.0)) return;
    command_unit(gain_m_s);
  }

  bool take_scale_of_reference(bool has_to_agree) {
    return set_scale_by_reference(columns_, given_, directions(), has_to_agree, mapping_, findings_);
  }

  double command_in_si() const {
    const auto unit = find_unit(speed_units(), mapping_.command->unit);
    return unit && !unit->of_wheel && !unit->of_count ? unit->in_si : 1.0;
  }

  void command_unit(double gain_m_s) {
    CommandMapping& command = *mapping_.command;
    if (largest(columns_.command[0]) * command_in_si() <= fastest_m_s && gain_m_s > command_in_si() / 3.0 &&
        gain_m_s < command_in_si() * 3.0)
      return;
    const bool is_register = names_a_register(command.first.channel) && are_whole(columns_.command[0]);
    if (const auto unit = is_register ? register_unit(gain_m_s, mapping_.wheels)
                                      : unit_of_gain(gain_m_s, mapping_.wheels)) {
      if (unit->name == command.unit) return;
      command.unit = unit->name;
      findings_.push_back("commands are in " + command.unit + ": the wheels reach " +
                          plain_number(rounded_gain(gain_m_s)) + " m/s for each unit" + evidence());
      return;
    }
    if (command.kind != CommandKind::wheels || largest(columns_.command[0]) <= fastest_m_s) return;
    command.kind = CommandKind::duty;
    find_full_scale(gain_m_s);
  }

  // Whole numbers without a name that lead to as many mm/s. A duty that happens to do so has a gain near one
  // then.
  bool are_millimetres(double gain_m_s) const {
    constexpr double near = 1.1;
    const CommandMapping& command = *mapping_.command;
    const bool has_name = !std::ranges::all_of(command.first.channel, config::is_digit);
    const bool is_said = given_.says("command.kind") || given_.says("command.full_scale") ||
                         given_.says("command.full_scale_m_s");
    return command.kind == CommandKind::duty && command.neutral == 0.0 && !has_name && !is_said &&
           are_whole(columns_.command[0]) && std::abs(std::log(gain_m_s / 0.001)) < std::log(near);
  }

  void take_millimetres(double gain_m_s) {
    mapping_.command->kind = CommandKind::wheels;
    mapping_.command->unit = "mm/s";
    findings_.push_back("commands are in mm/s: the wheels reach " +
                        plain_number(rounded_gain(1e3 * gain_m_s)) + " mm/s for each unit" + evidence());
  }

  void find_full_scale(double gain_m_s) {
    CommandMapping& command = *mapping_.command;
    set_full_scale(columns_, given_, command);
    if (given_.says("command.full_scale_m_s")) return;
    const double full_m_s = rounded_gain(gain_m_s * command.full_scale);
    if (full_m_s < 0.001 || full_m_s > 100.0) return;
    command.full_scale_m_s = full_m_s;
    findings_.push_back("commands are a duty of " + plain_number(command.full_scale) + ", which leads to " +
                        plain_number(*command.full_scale_m_s) + " m/s by the wheels" + evidence());
  }

  // How far a count goes, where commands are speeds.
  void find_scale() {
    const CommandMapping& command = *mapping_.command;
    if (command.is_duty() || (largest(columns_.command[0]) > fastest_m_s && command_in_si() == 1.0)) return;
    const auto unit = find_unit(speed_units(), command.unit);
    if (!unit || unit->of_wheel || unit->of_count) return;
    const double scale = rounded_gain(unit->in_si / std::abs(gain_));
    if (!(scale > 1e-9) || scale > 1.0) return;  // no wheel has such a count or radius
    found_scale_ = true;
    const bool are_counts = mapping_.wheels->kind == WheelKind::counts;
    const auto angle = find_unit(mapping_.wheels->kind == WheelKind::angle ? angle_units() : speed_units(),
                                 mapping_.wheels->unit);
    if (are_counts || (angle && angle->of_count)) {
      mapping_.wheels->metres_per_count = scale;
      mapping_.wheels->scale_from = from_commands;
      findings_.push_back("a count is " + plain_number(scale) +
                          " m, so that a wheel reaches the speed that it is asked for; --set "
                          "wheels.metres_per_count if you know it" +
                          evidence());
    } else {
      const double radius_m = rounded_gain(scale / (angle ? angle->in_si : 1.0));
      if (radius_m < 0.003 || mapping_.wheels->unit.empty()) return;
      mapping_.wheels->wheel_radius_m = radius_m;
      mapping_.wheels->scale_from = from_commands;
      findings_.push_back("the wheel radius is " + plain_number(*mapping_.wheels->wheel_radius_m) +
                          " m, so that a wheel reaches the speed that it is asked for; --set "
                          "wheels.wheel_radius_m if you know it" +
                          evidence());
    }
  }

  // Of wheel speeds that the file gives no unit: the one in which wheels come near their commands, else none.
  void speed_unit() {
    WheelMapping& wheels = *mapping_.wheels;
    if (!wheels.unit_assumed || mapping_.command->is_duty()) return;
    const double gain = std::abs(gain_) / command_in_si();
    if (are_counts_of_a_row(columns_, gain, wheels)) {
      take_counts_of_a_row(wheels);
      findings_.push_back("the wheels hold the counts since the row before" + evidence());
      return;
    }
    if (gain > 1.0 / 3.0 && gain < 3.0) return;
    for (const Unit& unit : speed_units()) {
      const auto m_s = speed_in_m_s(unit, mapping_.wheels);
      if (!m_s || !unit.is_found_by_motion() || !is_near(gain, 1.0 / *m_s)) continue;
      wheels.unit = unit.name;
      findings_.push_back("wheel speeds are in " + wheels.unit + evidence());
      return;
    }
    wheels.unit.clear();
  }

  // Of wheel angles or distances that the file gives no unit, with the radius of the wheel.
  void travel_unit() {
    WheelMapping& wheels = *mapping_.wheels;
    if (!wheels.unit_assumed || mapping_.command->is_duty()) return;
    const bool may_turn = !wheels.body_motion;  // the way of a body is no angle
    if (may_turn && largest(columns_.command[0]) * command_in_si() > fastest_m_s) return angle_unit();
    const double metres = command_in_si() / std::abs(gain_);  // of one unit
    for (const Unit& unit : angle_units()) {
      if (!wheels.wheel_radius_m || !is_near(metres, unit.in_si * *wheels.wheel_radius_m)) continue;
      return take_travel_unit(WheelKind::angle, unit);
    }
    for (const Unit& unit : distance_units()) {
      if (unit.is_found_by_motion() && is_near(metres, unit.in_si))
        return take_travel_unit(WheelKind::distance, unit);
    }
    if (may_turn && wheels.kind == WheelKind::distance)
      take_travel_unit(WheelKind::angle, angle_units().front());
  }

  // Commands that are in no metres per second: the travel is an angle, and they may be its speed.
  void angle_unit() {
    take_travel_unit(WheelKind::angle, angle_units().front());
    if (is_near(std::abs(gain_), 1.0) && !unit_is_said()) mapping_.command->unit = "rad/s";
  }

  void take_travel_unit(WheelKind kind, const Unit& unit) {
    mapping_.wheels->kind = kind;
    mapping_.wheels->unit = unit.name;
    mapping_.wheels->unit_assumed = false;
    findings_.push_back(std::string("the travel of the wheels is ") +
                        (kind == WheelKind::angle ? "an angle" : "a distance") + " in " +
                        mapping_.wheels->unit + evidence());
  }

  // Units and scales that are known leave nothing to find, and may be wrong.
  void check_gain() {
    const auto scale = wheel_scale(*mapping_.wheels);
    if (!scale || mapping_.command->is_duty()) return;
    const auto unit = find_unit(speed_units(), mapping_.command->unit);
    const auto command = unit ? speed_in_m_s(*unit, mapping_.wheels) : std::nullopt;
    if (!command) return;
    const double gain = std::abs(gain_) * *scale / *command;
    if (mapping_.wheels->scale_from == from_reference && !is_near(gain, 1.0)) {
      doubts_.push_back("by the reference the wheels go " + plain_number(rounded_gain(gain)) +
                        " times as fast as commanded: the commands may be a duty, or in another unit (--set "
                        "command.kind=duty, command.unit), or the reference in another (reference.unit)");
    } else if (!found_scale_ && (gain < 0.6 || gain > 1.6)) {
      doubts_.push_back("the wheels go " + plain_number(rounded_gain(gain)) +
                        " times as far as commanded: check the units of commands and wheels, and the scale");
    }
    if (mapping_.command->kind != CommandKind::twist || !mapping_.wheel_base_m) return;
    const auto angular = find_unit(angular_units(), mapping_.command->angular_unit);
    const double turn = fits_[1].gain * *scale / *mapping_.wheel_base_m / (angular ? angular->in_si : 1.0);
    if (fits_[1].explained < unit_explained || (turn > 0.5 && turn < 2.0)) return;
    if (!given_.says("command.angular_unit") && mapping_.command->angular_unit == "rad/s" &&
        is_near(turn, pi / 180.0)) {
      mapping_.command->angular_unit = "deg/s";
      findings_.push_back("the angular command is in deg/s: the robot turns " +
                          plain_number(rounded_gain(turn)) + " times as far as in rad/s");
      return;
    }
    doubts_.push_back(
        turn < 0.0
            ? std::string("the robot turns against its commands: its angular command is clockwise (--set "
                          "command.reversed=right), or the "
                          "sides are swapped")
            : "the robot turns " + plain_number(rounded_gain(turn)) +
                  " times as far as commanded: check the unit of the angular command and the wheel base");
  }

  void doubt_weak_evidence() {
    if (explained_ >= 0.7 || !is_sure()) return;
    doubts_.push_back("the command explains only " + fixed_number(100.0 * explained_, 0) + " % of the speed");
  }

  // What turning suggests; the wheel base itself is given.
  void suggest_base() {
    if (mapping_.wheel_base_m || mapping_.command->kind != CommandKind::twist) return;
    const auto scale = wheel_scale(*mapping_.wheels);
    if (!scale || fits_[1].explained < unit_explained) return;
    const double angular = in_si(angular_units(), mapping_.command->angular_unit);
    findings_.push_back("turns suggest a wheel base of about " +
                        fixed_number(std::abs(fits_[1].gain) * *scale / angular, 3) + " m");
  }

  const DriveColumns& columns_;
  const GivenMapping& given_;
  Mapping& mapping_;
  std::vector<std::string>& findings_;
  std::vector<std::string>& doubts_;
  bool found_scale_ = false;
  std::array<ResponseFit, 2> fits_;
  double gain_ = 0.0;
  double explained_ = 0.0;
};

}  // namespace

void set_units(const DriveColumns& columns, const GivenMapping& given, Mapping& mapping,
               std::vector<std::string>& findings, std::vector<std::string>& doubts) {
  UnitFinder(columns, given, mapping, findings, doubts).run();
}

}  // namespace wheelwright::import
