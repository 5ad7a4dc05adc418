// A model while it is being searched for: a small linear part as a vector of numbers, and effects.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "model/effects/effect.hpp"
#include "model/geometry/sensor_period.hpp"
#include "model/geometry/wheel_side.hpp"
#include "model/simulation/linear_model.hpp"
#include "model/simulation/model_simulation.hpp"

namespace wheelwright::gap {

// An effect under trial; `info` may be one of the library or a decoy.
struct TrialEffect {
  const EffectInfo* info = nullptr;
  std::size_t variant = 0;
  std::vector<double> parameters;

  const ParameterInfo& parameter_info(std::size_t index) const { return info->parameters_of(variant)[index]; }
  // With each parameter at its bound that is beyond it: no simulation takes another.
  TrialEffect within_bounds() const;
};

// The linear part: y(k) = sum a_i y(k-i) + sum b_j u(k-j) for each wheel from its own command.
//
// Short on purpose: what a long linear part could imitate (delay, lag, ringing), it would take from the
// effect that is there. `shared` gives both wheels one response, but for a gain of each:
// without counts, a difference of the wheels and one of their motors are the same, and what a linear
// part can hold is no effect. `unequal_lags`: a shared linear part all the same gives one wheel's motor more
// lag, and the other's less. `reference_lag`: the references may tell of a moment other than the counts do,
// by a clock that is off or a tyre that yields; how much is found beside the linear part, or the loss at each
// reversal would look like play. `gyro_scaled`: so is by how much the gyro says too much.
enum class CrossCoupling {
  none,
  share,     // each wheel also feels a share of the other's command, as it feels its own
  lag,       // each wheel also feels the changes of the other's command: turns lag behind travel, or lead it
  balanced,  // with weights of its own whose sum is 0: turns answer otherwise than travel, by the same gain
  free,      // with as many weights of its own as its own command has
  modes,     // travel and turns each have poles and weights of their own, as mass and yaw inertia make them:
             // a wheel answers half of what travel makes of both commands, and half of what turns make of
             // their difference
  balanced_modes  // the same, with one gain: the last weight of turns follows from the others
};

struct LinearPartShape {
  std::size_t poles = 2;
  std::size_t weights = 6;  // from_own lags 0..weights-1
  bool shared = false;
  CrossCoupling cross_coupling = CrossCoupling::none;
  bool unequal_lags = false;  // only where shared
  bool reference_lag = false;
  bool gyro_scaled = false;

  std::size_t cross_coupling_size() const {
    switch (cross_coupling) {
      case CrossCoupling::none:
        return 0;
      case CrossCoupling::share:
      case CrossCoupling::lag:
        return 1;
      case CrossCoupling::balanced:
        return weights - 1;  // the last one makes up for the others
      case CrossCoupling::free:
        break;
      case CrossCoupling::balanced_modes:
        return poles + weights - 1;
      case CrossCoupling::modes:
        return poles + weights;  // of turns; the first ones are those of travel
    }
    return weights;
  }
  bool has_modes() const { return cross_coupling >= CrossCoupling::modes; }
  bool crosses_by_weights() const {
    return cross_coupling == CrossCoupling::balanced || cross_coupling == CrossCoupling::free;
  }
  // Whether a parameter of one wheel's response, counted from 0, is a weight of commands.
  bool is_weight(std::size_t of_wheel) const {
    if (of_wheel < poles) return false;
    if (of_wheel < poles + weights) return true;
    return has_modes() ? of_wheel >= 2 * poles + weights : crosses_by_weights();
  }
  bool crosses_by_one_value() const { return cross_coupling_size() == 1 && !crosses_by_weights(); }
  std::size_t per_wheel() const { return poles + weights + cross_coupling_size(); }
  std::size_t of_responses() const { return shared ? per_wheel() : 2 * per_wheel(); }
  std::size_t of_wheels() const { return of_responses() + (shared ? 1 : 0); }
  std::size_t lag_index() const { return of_wheels() + (unequal_lags ? 1 : 0); }
  std::size_t gyro_index() const { return lag_index() + (reference_lag ? 1 : 0); }
  std::size_t size() const { return gyro_index() + (gyro_scaled ? 1 : 0); }
};

// Relative, either way: beside an effect of turns, more would be its mirror image.
constexpr double largest_gyro_scale = 0.15;

struct TrialModel {
  LinearPartShape shape;
  double period_s = default_period_s;
  double wheel_base_m = 0.235;
  // a, b, share or weights of the other's command, or a and b of turns; left, then right where not shared, or
  // else by how much the right wheel's gain exceeds the left's, relative; periods by which the right wheel
  // lags behind the left; lag of the references, s; by how much the gyro says too much, relative
  std::vector<double> linear_part;
  std::vector<TrialEffect> effects;

  LinearModel linear() const;
  // Of the right wheel's gain over the left's, relative; 0 where each has a response of its own.
  double excess_of_right() const { return shape.shared ? linear_part[shape.per_wheel()] : 0.0; }
  double reference_lag_s() const { return shape.reference_lag ? linear_part[shape.lag_index()] : 0.0; }
  double gyro_scale() const { return shape.gyro_scaled ? linear_part[shape.gyro_index()] : 0.0; }
  ModelSimulation simulation() const;
  // Core and effect parameters, one after the other.
  std::size_t parameter_count() const;
  double parameter(std::size_t index) const;
  void set_parameter(std::size_t index, double value);
  // The effect to which a parameter belongs, or nothing for the linear part's.
  const ParameterInfo* parameter_info(std::size_t index) const;
  // The same model with every parameter moved by a step of its own, within its bounds.
  TrialModel moved(const Eigen::VectorXd& step) const;
  bool stable() const;
  // The same model with a linear part of one more pole, `pole`, and one more weight, which hides it for a
  // start.
  TrialModel with_higher_order(double pole = 0.0) const;
  // The same model with a linear part that is crossed. A single value begins at 0; weights of its own begin
  // with the crossing that was there.
  TrialModel with_cross_coupling(CrossCoupling cross_coupling) const;
  // The same model with a linear part that answers so much later, by as many more weights as that takes.
  TrialModel with_later_linear_part(double delay_s) const;
  // The same model, whose transport_delay, if it has one, is a part of the linear part.
  TrialModel with_delay_in_linear_part() const;
  // The same model with a linear part that is skewed.
  TrialModel with_unequal_lags() const;
  // The same model with a response of its own for each wheel.
  TrialModel with_parted_linear_part() const;
  // The same model, both of whose wheels respond as this one does; where the linear part is parted.
  TrialModel with_response_of(WheelSide wheel) const;
  // Of the effects, as they are listed.
  std::vector<EffectSetting> settings() const;
  // The effects in the order in which they act: as they are listed, but for those that act first.
  std::vector<TrialEffect> acting() const;
};

// A first-order lag behind a delay, with a gain of 1: where every search begins. Of more poles than two, one
// is slow and hidden for a start.
TrialModel first_guess(const LinearPartShape& shape, double period_s, double wheel_base_m, double lag_s,
                       double delay_s);

// The smallest size that a search tries.
double smallest_size(const ParameterInfo& info);

// It stands for what is known of a parameter of which the readings say nothing.
double typical_size(const TrialModel& model, std::size_t parameter);

// By how much to move a parameter to see what follows; away from the upper bound.
double small_step(const TrialModel& model, std::size_t parameter);

}  // namespace wheelwright::gap
