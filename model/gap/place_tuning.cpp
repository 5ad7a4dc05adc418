#include "model/gap/place_tuning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace wheelwright::gap {
namespace {

constexpr std::array steps_m{0.4, 0.15, 0.05};
constexpr int most_moves = 12;  // of each size
constexpr double least_size_m = 0.1;
constexpr double worth_a_move = 0.2;  // of the sum of squares: a tenth of a nat

// Parameters of surface_patch, in their order.
enum : std::size_t { change, x, y, length, width, heading };

std::optional<std::size_t> region_in(const TrialModel& model) {
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    if (model.effects[i].info->name == "surface_patch") return i;
  }
  return std::nullopt;
}

// One edge goes out or in, the opposite one stays.
std::vector<double> with_edge_moved(std::vector<double> region, std::size_t side, double direction,
                                    double by_m) {
  const double angle = region[heading] + (side == width ? 0.5 * std::numbers::pi : 0.0);
  region[side] += by_m;
  region[x] += 0.5 * direction * by_m * std::cos(angle);
  region[y] += 0.5 * direction * by_m * std::sin(angle);
  return region;
}

// Variants of surface_patch stand in two pairs: under the middle, and under each wheel.
std::size_t other_way(std::size_t variant) {
  return (variant + 2) % 4;
}

// By steps, and by half of the region at once: one that reaches over what two runs passed may have to be cut
// a long way before it fits again.
std::vector<TrialEffect> moved(const TrialEffect& present, double step_m) {
  std::vector<TrialEffect> all;
  const auto add = [&](std::vector<double> region) {
    all.push_back(present);
    all.back().parameters = std::move(region);
  };
  for (const std::size_t side : {length, width}) {
    const double size_m = present.parameters[side];
    for (const double by_m : {step_m, -step_m, -0.5 * size_m}) {
      if (size_m + by_m < least_size_m) continue;
      for (const double direction : {1.0, -1.0}) {
        add(with_edge_moved(present.parameters, side, direction, by_m));
      }
    }
  }
  for (const double by_m : {step_m, -step_m}) {
    for (const std::size_t parameter : {x, y, heading}) {
      add(present.parameters);
      all.back().parameters[parameter] += by_m;
    }
  }
  all.push_back(present);
  all.back().variant = other_way(present.variant);
  return all;
}

}  // namespace

bool has_region(const TrialModel& model) {
  return region_in(model).has_value();
}

TrialModel with_region_tuned(const GapProblem& train, TrialModel model, const ForEach& for_each) {
  const auto place = region_in(model);
  if (!place) return model;
  const Part part = train.part_of(model.effects[*place]);
  double least = squares_of(train.residuals(model, part));
  for (const double step_m : steps_m) {
    for (int move = 0; move < most_moves; ++move) {
      const auto regions = moved(model.effects[*place], step_m);
      std::vector<double> squares(regions.size());
      for_each(regions.size(), [&](std::size_t i) {
        TrialModel tried = model;
        tried.effects[*place] = regions[i];
        squares[i] = squares_of(train.residuals(tried, part));
      });
      const auto best = std::ranges::min_element(squares);
      if (*best > least - worth_a_move) break;
      least = *best;
      model.effects[*place] = regions[static_cast<std::size_t>(best - squares.begin())];
    }
  }
  return model;
}

}  // namespace wheelwright::gap
