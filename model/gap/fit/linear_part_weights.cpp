#include "model/gap/fit/linear_part_weights.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>

namespace wheelwright::gap {

std::vector<double> delayed(const std::vector<double>& weights, double periods) {
  std::vector<double> later(weights.size() + 1, 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    later[i] += (1.0 - periods) * weights[i];
    later[i + 1] += periods * weights[i];
  }
  return later;
}

std::vector<double> times_a_pole(const std::vector<double>& polynomial, double pole) {
  std::vector<double> product(polynomial.size() + 1, 0.0);
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    product[i] += polynomial[i];
    product[i + 1] -= pole * polynomial[i];
  }
  return product;
}

std::vector<double> cross_coupling_weights(const LinearPartShape& shape, const std::vector<double>& own,
                                           const double* values) {
  std::vector<double> weights(values, values + shape.cross_coupling_size());
  const auto times = [](std::vector<double> all, double factor) {
    for (double& weight : all) weight *= factor;
    return all;
  };
  switch (shape.cross_coupling) {
    case CrossCoupling::none:
      return times(own, 0.0);
    case CrossCoupling::share:
      return times(own, *values);
    case CrossCoupling::lag:
      return times(times_a_pole(own, 1.0), *values);
    case CrossCoupling::balanced:
      weights.push_back(-std::accumulate(weights.begin(), weights.end(), 0.0));
      break;
    case CrossCoupling::free:
    case CrossCoupling::modes:
    case CrossCoupling::balanced_modes:
      break;
  }
  return weights;
}

std::vector<double> product(const std::vector<double>& one, const std::vector<double>& other) {
  std::vector<double> result(one.size() + other.size() - 1, 0.0);
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t j = 0; j < other.size(); ++j) result[i + j] += one[i] * other[j];
  }
  return result;
}

Mode mode_of(const LinearPartShape& shape, const double* values) {
  Mode mode;
  mode.past.push_back(1.0);
  std::transform(values, values + shape.poles, std::back_inserter(mode.past), std::negate<>{});
  mode.weights.assign(values + shape.poles, values + shape.poles + shape.weights);
  return mode;
}

Modes modes_of(const LinearPartShape& shape, const double* values) {
  const auto sum = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  const double* of_turn = values + shape.poles + shape.weights;
  Modes modes{mode_of(shape, values), {}};
  if (shape.cross_coupling != CrossCoupling::balanced_modes) {
    modes.turn = mode_of(shape, of_turn);
    return modes;
  }
  LinearPartShape all_but_last = shape;
  all_but_last.weights -= 1;
  modes.turn = mode_of(all_but_last, of_turn);
  const double gain = sum(modes.travel.weights) / sum(modes.travel.past);
  modes.turn.weights.push_back(gain * sum(modes.turn.past) - sum(modes.turn.weights));
  return modes;
}

void add_modes(std::vector<double>& linear_part, const Modes& modes, CrossCoupling cross_coupling) {
  const auto add = [&](const Mode& mode, std::ptrdiff_t left_out) {
    std::transform(mode.past.begin() + 1, mode.past.end(), std::back_inserter(linear_part), std::negate<>{});
    linear_part.insert(linear_part.end(), mode.weights.begin(), mode.weights.end() - left_out);
  };
  add(modes.travel, 0);
  add(modes.turn, cross_coupling == CrossCoupling::balanced_modes ? 1 : 0);
}

void add_cross_coupling_weights(std::vector<double>& linear_part, CrossCoupling cross_coupling,
                                const std::vector<double>& weights) {
  linear_part.insert(linear_part.end(), weights.begin(),
                     weights.end() - (cross_coupling == CrossCoupling::balanced ? 1 : 0));
}

}  // namespace wheelwright::gap
