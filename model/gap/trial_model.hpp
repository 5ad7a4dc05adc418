// A model while it is being searched for: a small linear core as a vector of numbers, and effects.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "model/effects/effect.hpp"
#include "model/linear_model.hpp"
#include "model/model_simulation.hpp"

namespace wheelwright::gap {

// An effect under trial; `info` may be one of the library or a decoy.
struct TrialEffect {
  const EffectInfo* info = nullptr;
  std::size_t variant = 0;
  std::vector<double> parameters;
};

// The linear core: y(k) = sum a_i y(k-i) + sum b_j u(k-j) for each wheel from its own command.
//
// Short on purpose: what a long core could imitate (delay, lag, ringing), it would take from the effect that
// is there (GAP.md, point 6). `shared` gives both wheels one response: without counts, a difference of the
// wheels and a difference of their motors are one and the same, and it is called the wheels'.
// `reference_lag`: the references may tell of a moment other than the counts do, by a clock that is off or a
// tyre that yields; how much is found beside the core, or the loss at each reversal would look like play.
struct CoreShape {
  std::size_t poles = 2;
  std::size_t weights = 6;  // from_own lags 0..weights-1
  bool shared = false;
  bool crossed = false;  // each wheel also feels a share of the other's command
  bool reference_lag = false;

  std::size_t per_wheel() const { return poles + weights + (crossed ? 1 : 0); }
  std::size_t of_wheels() const { return shared ? per_wheel() : 2 * per_wheel(); }
  std::size_t size() const { return of_wheels() + (reference_lag ? 1 : 0); }
};

struct TrialModel {
  CoreShape shape;
  double period_s = 0.018;
  double wheel_base_m = 0.235;
  // a, b, share of the other's command; left, then right where not shared; lag of the references, s
  std::vector<double> core;
  std::vector<TrialEffect> effects;

  LinearModel linear() const;
  double reference_lag_s() const { return shape.reference_lag ? core.back() : 0.0; }
  ModelSimulation simulation() const;
  // Core and effect parameters, one after the other.
  std::size_t parameter_count() const;
  double parameter(std::size_t index) const;
  void set_parameter(std::size_t index, double value);
  // The effect to which a parameter belongs, or nothing for the core's.
  const ParameterInfo* parameter_info(std::size_t index) const;
  bool stable() const;
  // The same model with a core of one more pole and one more weight.
  TrialModel with_larger_core() const;
  // The same model with a core that is crossed.
  TrialModel with_crossed_core() const;
  // Of the effects, as they are listed.
  std::vector<EffectSetting> settings() const;
  // The effects in the order in which they act: as they are listed, but for those that act first.
  std::vector<TrialEffect> acting() const;
};

// A first-order lag behind a delay, with a gain of 1: where every search begins.
TrialModel first_guess(const CoreShape& shape, double period_s, double wheel_base_m, double lag_s,
                       double delay_s);

}  // namespace wheelwright::gap
