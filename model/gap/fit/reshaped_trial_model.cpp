// Trial models that behave as one does, with another shape of their linear part.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>

#include "model/gap/fit/linear_part_weights.hpp"
#include "model/gap/fit/trial_model.hpp"

namespace wheelwright::gap {
namespace {

// Travel and turns of one wheel's parameters, each changed, at the end of a linear part.
template <typename Change>
void add_changed_modes(const LinearPartShape& shape, const double* values, Change change,
                       std::vector<double>& linear_part) {
  Modes modes = modes_of(shape, values);
  change(modes.travel);
  change(modes.turn);
  add_modes(linear_part, modes, shape.cross_coupling);
}

}  // namespace

// Both sides of the difference equation times the same: the response stays what it is.
TrialModel TrialModel::with_higher_order(double pole) const {
  TrialModel larger = *this;
  larger.shape.poles += 1;
  larger.shape.weights += 1;
  larger.linear_part.clear();
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    if (shape.has_modes()) {
      const auto with_pole = [pole](Mode& mode) {
        mode.past = times_a_pole(mode.past, pole);
        mode.weights = times_a_pole(mode.weights, pole);
      };
      add_changed_modes(shape, linear_part.data() + wheel, with_pole, larger.linear_part);
      continue;
    }
    const auto begin = linear_part.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto rest = weights + static_cast<std::ptrdiff_t>(shape.weights);
    std::vector<double> past{1.0};
    std::transform(begin, weights, std::back_inserter(past), std::negate<>{});
    past = times_a_pole(past, pole);
    std::transform(past.begin() + 1, past.end(), std::back_inserter(larger.linear_part), std::negate<>{});
    std::ranges::copy(times_a_pole({weights, rest}, pole), std::back_inserter(larger.linear_part));
    if (shape.crosses_by_one_value()) larger.linear_part.push_back(*rest);
    if (shape.crosses_by_weights()) {
      add_cross_coupling_weights(larger.linear_part, shape.cross_coupling,
                                 times_a_pole(cross_coupling_weights(shape, {weights, rest}, &*rest), pole));
    }
  }
  larger.linear_part.insert(larger.linear_part.end(),
                            linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                            linear_part.end());
  return larger;
}

TrialModel TrialModel::with_cross_coupling(CrossCoupling cross_coupling) const {
  TrialModel crossed = *this;
  crossed.shape.cross_coupling = cross_coupling;
  crossed.linear_part.clear();
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    const auto begin = linear_part.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto rest = weights + static_cast<std::ptrdiff_t>(shape.weights);
    if (crossed.shape.has_modes()) {
      if (shape.has_modes()) {
        add_modes(crossed.linear_part, modes_of(shape, linear_part.data() + wheel), cross_coupling);
        continue;
      }
      const Mode own = mode_of(shape, linear_part.data() + wheel);
      std::vector<double> other = cross_coupling_weights(shape, own.weights, &*rest);
      other.resize(shape.weights);
      Modes modes{own, own};
      for (std::size_t i = 0; i < other.size(); ++i) {
        modes.travel.weights[i] += other[i];
        modes.turn.weights[i] -= other[i];
      }
      add_modes(crossed.linear_part, modes, cross_coupling);
      continue;
    }
    crossed.linear_part.insert(crossed.linear_part.end(), begin, rest);
    if (crossed.shape.crosses_by_one_value()) crossed.linear_part.push_back(0.0);
    if (crossed.shape.crosses_by_weights()) {
      std::vector<double> other = cross_coupling_weights(shape, {weights, rest}, &*rest);
      other.resize(shape.weights);
      add_cross_coupling_weights(crossed.linear_part, cross_coupling, other);
    }
  }
  crossed.linear_part.insert(crossed.linear_part.end(),
                             linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                             linear_part.end());
  return crossed;
}

TrialModel TrialModel::with_later_linear_part(double delay_s) const {
  const auto whole = static_cast<std::size_t>(delay_s / period_s);
  const double rest = delay_s / period_s - static_cast<double>(whole);
  TrialModel later = *this;
  later.shape.weights += whole + 1;
  later.linear_part.clear();
  const auto put_off = [&](const std::vector<double>& weights) {
    std::vector<double> put(whole, 0.0);
    std::ranges::copy(delayed(weights, rest), std::back_inserter(put));
    return put;
  };
  for (std::size_t wheel = 0; wheel < shape.of_responses(); wheel += shape.per_wheel()) {
    if (shape.has_modes()) {
      const auto later_mode = [&](Mode& mode) { mode.weights = put_off(mode.weights); };
      add_changed_modes(shape, linear_part.data() + wheel, later_mode, later.linear_part);
      continue;
    }
    const auto begin = linear_part.begin() + static_cast<std::ptrdiff_t>(wheel);
    const auto weights = begin + static_cast<std::ptrdiff_t>(shape.poles);
    const auto cross_coupling = weights + static_cast<std::ptrdiff_t>(shape.weights);
    later.linear_part.insert(later.linear_part.end(), begin, weights);
    std::ranges::copy(put_off({weights, cross_coupling}), std::back_inserter(later.linear_part));
    if (shape.crosses_by_one_value()) later.linear_part.push_back(*cross_coupling);
    if (shape.crosses_by_weights()) {
      add_cross_coupling_weights(
          later.linear_part, shape.cross_coupling,
          put_off(cross_coupling_weights(shape, {weights, cross_coupling}, &*cross_coupling)));
    }
  }
  later.linear_part.insert(later.linear_part.end(),
                           linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_responses()),
                           linear_part.end());
  return later;
}

TrialModel TrialModel::with_delay_in_linear_part() const {
  const auto delay = std::ranges::find(effects, "transport_delay",
                                       [](const TrialEffect& effect) { return effect.info->name; });
  if (delay == effects.end()) return *this;
  TrialModel later = with_later_linear_part(delay->parameters[0]);
  later.effects.erase(later.effects.begin() + (delay - effects.begin()));
  return later;
}

TrialModel TrialModel::with_response_of(WheelSide wheel) const {
  TrialModel alike = *this;
  const auto left = alike.linear_part.begin();
  const auto right = left + static_cast<std::ptrdiff_t>(shape.per_wheel());
  if (wheel == WheelSide::left) {
    std::copy(left, right, right);
  } else {
    std::copy(right, right + static_cast<std::ptrdiff_t>(shape.per_wheel()), left);
  }
  return alike;
}

TrialModel TrialModel::with_unequal_lags() const {
  TrialModel unequal_lags = *this;
  unequal_lags.shape.unequal_lags = true;
  unequal_lags.linear_part.insert(
      unequal_lags.linear_part.begin() + static_cast<std::ptrdiff_t>(shape.of_wheels()), 0.0);
  return unequal_lags;
}

TrialModel TrialModel::with_parted_linear_part() const {
  const auto add_measurement = [this](TrialModel& model) {
    if (shape.reference_lag) model.linear_part.push_back(reference_lag_s());
    if (shape.gyro_scaled) model.linear_part.push_back(gyro_scale());
  };
  const LinearModel as_one = linear();
  TrialModel parted = *this;
  parted.shape.shared = parted.shape.unequal_lags = false;
  parted.shape.weights = as_one.left.from_left.size() - (shape.cross_coupling == CrossCoupling::lag ? 1 : 0);
  parted.linear_part.clear();
  if (shape.has_modes()) {
    const double half_excess = 0.5 * excess_of_right();
    const double half_lag = shape.unequal_lags ? 0.5 * linear_part[shape.of_wheels()] : 0.0;
    parted.shape.weights = shape.weights + (shape.unequal_lags ? 1 : 0);
    for (const double sign : {-1.0, 1.0}) {
      const auto of_wheel = [&](Mode& mode) {
        if (shape.unequal_lags) mode.weights = delayed(mode.weights, sign * half_lag);
        for (double& weight : mode.weights) weight *= 1.0 + sign * half_excess;
      };
      add_changed_modes(shape, linear_part.data(), of_wheel, parted.linear_part);
    }
    add_measurement(parted);
    return parted;
  }
  const auto add = [&](const std::vector<double>& past, const std::vector<double>& own,
                       const std::vector<double>& other) {
    std::ranges::copy(past, std::back_inserter(parted.linear_part));
    parted.linear_part.insert(parted.linear_part.end(), own.begin(),
                              own.begin() + static_cast<std::ptrdiff_t>(parted.shape.weights));
    if (shape.crosses_by_one_value()) parted.linear_part.push_back(linear_part[shape.per_wheel() - 1]);
    if (shape.crosses_by_weights())
      add_cross_coupling_weights(parted.linear_part, shape.cross_coupling, other);
  };
  add(as_one.left.from_own_past, as_one.left.from_left, as_one.left.from_right);
  add(as_one.right.from_own_past, as_one.right.from_right, as_one.right.from_left);
  add_measurement(parted);
  return parted;
}

}  // namespace wheelwright::gap
