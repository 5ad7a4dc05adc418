#include "model/gap/candidates/screening_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelwright::gap {
namespace {

constexpr double min_gain_nats = 40.0;

// `effect` with its size times `amount`; nothing where it cannot have that size.
std::optional<TrialEffect> resized(TrialEffect effect, double amount) {
  constexpr double min_amount = 0.1;
  constexpr double max_amount = 30.0;
  if (!(std::abs(amount) > min_amount) || !(std::abs(amount) < max_amount)) return std::nullopt;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const ParameterInfo& parameter = effect.parameter_info(i);
    if (!parameter.scales_effect || !vanishes_at_zero(parameter)) continue;
    const double size = amount * effect.parameters[i];
    if (size < parameter.lower || size > parameter.upper) return std::nullopt;
    effect.parameters[i] = size;
  }
  return effect;
}

// What two effects could explain together, each by its place in `common`.
std::optional<ScreenedPair> pair_of(const TrialEffect& one, const TrialEffect& other, const Common& common,
                                    double alike) {
  const double a = common.products(0, 0);
  const double b = common.products(1, 1);
  const double both = common.products(0, 1);
  const double determinant = a * b - both * both;
  if (!(determinant > (1.0 - alike * alike) * a * b)) return std::nullopt;
  const double p = -common.with_left(0);
  const double q = -common.with_left(1);
  const double first = (p * b - q * both) / determinant;
  const double second = (q * a - p * both) / determinant;
  const auto start = resized(one, first);
  const auto beside = resized(other, second);
  if (!start || !beside) return std::nullopt;
  return ScreenedPair{{*start, *beside}, 0.5 * (first * p + second * q)};
}

}  // namespace

std::optional<ScreenedPair> stronger_pair(std::span<const Screened> effects, const Common& common) {
  constexpr double alike = 0.98;  // cosine
  constexpr double times_the_best_single = 1.5;
  double min_nats = min_gain_nats;
  for (const Screened& effect : effects)
    min_nats = std::max(min_nats, times_the_best_single * effect.gain_nats);
  std::optional<ScreenedPair> best;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const TrialEffect& one = effects[i].start;
      const TrialEffect& other = effects[j].start;
      if (one.info == other.info) continue;
      const std::array<Eigen::Index, 2> at{static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)};
      const auto pair = pair_of(one, other, {common.products(at, at), common.with_left(at)}, alike);
      if (pair && pair->gain_nats > (best ? best->gain_nats : min_nats)) best = pair;
    }
  }
  return best;
}

}  // namespace wheelwright::gap
