#include "model/gap/fit/linear_part_weights.hpp"

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
      break;
  }
  return weights;
}

void add_cross_coupling_weights(std::vector<double>& linear_part, CrossCoupling cross_coupling,
                                const std::vector<double>& weights) {
  linear_part.insert(linear_part.end(), weights.begin(),
                     weights.end() - (cross_coupling == CrossCoupling::balanced ? 1 : 0));
}

}  // namespace wheelwright::gap
