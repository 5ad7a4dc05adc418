// Numbers of a model as controllers and simulators keep them: one figure each, with its interval and date.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/wheelwright/export/first_order_response.hpp"
#include "tools/wheelwright/export/model_text.hpp"

namespace wheelwright::tools {

struct Figure {
  double value = 0.0;
  std::optional<ParameterInterval> interval;  // 95 %
  std::string from;                           // effects, and when they were found
};

// Of one wheel.
struct WheelLimits {
  std::optional<Figure> largest_speed_m_s;
  std::optional<Figure> friction_loss_m_s;  // speed that dry friction costs
};

struct DriveFigures {
  double wheel_separation_m = 0.0;  // as the logs give it
  Figure separation_multiplier;     // what turning shows, relative to it
  Figure left_radius_multiplier;    // what a wheel rolls, relative to what is counted
  Figure right_radius_multiplier;
  WheelPair gain;    // speed of a wheel per command
  Figure left_gain;  // the same, with what the fit says of it
  Figure right_gain;
  FirstOrderResponse left_response;  // of the linear part
  FirstOrderResponse right_response;
  std::optional<Figure> delay_s;               // beyond that of the linear part
  std::optional<Figure> largest_speed_m_s;     // of the slower wheel
  std::optional<Figure> largest_change_m_s2;   // of a wheel's speed
  std::optional<Figure> smallest_command_m_s;  // that moves a wheel
  WheelLimits left_limits;
  WheelLimits right_limits;
};

DriveFigures drive_figures(const RobotModel& model);

// "coulomb_friction of 2026-01-02".
std::string source_of(const RobotModel& model, const AddedEffect& effect);

// "the linear part of 2026-01-02".
std::string linear_part(const RobotModel& model);

// "1.02", and for a comment: "95 % interval 1.01 to 1.03; effective_track of 2026-01-02".
std::string value_of(const Figure& figure);
std::string remark_of(const Figure& figure);

// Times a constant; plus a constant; a constant over it; and the mean of two that may share their effects.
Figure scaled(const Figure& figure, double factor);
Figure divided_by(double constant, const Figure& figure);
Figure shifted(Figure figure, double by);
Figure mean_of(const Figure& one, const Figure& other);

// Why an effect has no place in a format.
struct UnsaidReason {
  std::string_view effect;
  std::string_view reason;
};

// The effects of the model that `put` does not name, each with its reason.
std::vector<Unsaid> unsaid_of(const RobotModel& model, std::span<const std::string_view> put,
                              std::span<const UnsaidReason> reasons);

}  // namespace wheelwright::tools
