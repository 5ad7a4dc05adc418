#include "model/gap/candidates/region_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "model/gap/candidates/region_scale.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::array move_steps{0.4, 0.15, 0.05};  // m in a room, and rad
constexpr int max_moves_of_size = 12;              // of each size
constexpr double worth_a_move = 0.2;               // of the sum of squares: a tenth of a nat

// Parameters of surface_patch, in their order.
enum : std::size_t { change, x, y, length, width, heading };

std::optional<std::size_t> region_in(const TrialModel& model) {
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    if (model.effects[i].info->name == "surface_patch") return i;
  }
  return std::nullopt;
}

std::vector<double> with(std::vector<double> region, std::initializer_list<std::size_t> parameters,
                         double by) {
  for (const std::size_t parameter : parameters) region[parameter] += by;
  return region;
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

// Variants of surface_patch: behind the encoder or before it, times under the middle or under each wheel,
// times rectangle or ellipse.
constexpr std::size_t under_each = 2;
constexpr std::size_t an_ellipse = 4;

// Of the other shape and the same area.
TrialEffect reshaped(TrialEffect region) {
  const double wider = 2.0 * std::numbers::inv_sqrtpi;  // of a disc than of a square
  region.variant ^= an_ellipse;
  for (const std::size_t side : {length, width}) {
    const double size_m =
        region.parameters[side] * ((region.variant & an_ellipse) != 0 ? wider : 1.0 / wider);
    const ParameterInfo& size = region.parameter_info(side);
    region.parameters[side] = std::clamp(size_m, size.lower, size.upper);
  }
  return region;
}

// By steps, and by half of the region at once: one that reaches over what two runs passed may have to be cut
// a long way before it fits again. What lies on a floor is mostly as long as wide.
std::vector<TrialEffect> moved(const TrialEffect& present, double step_m, double step_rad) {
  std::vector<TrialEffect> all;
  const auto add = [&](std::vector<double> region) {
    for (const std::size_t side : {length, width}) {
      const ParameterInfo& size = present.parameter_info(side);
      if (region[side] < size.lower || region[side] > size.upper) return;
    }
    region[heading] = std::remainder(region[heading], std::numbers::pi);  // it looks the same turned by half
    all.push_back(present);
    all.back().parameters = std::move(region);
  };
  const std::vector<double>& region = present.parameters;
  for (const std::size_t side : {length, width}) {
    for (const double by_m : {step_m, -step_m, -0.5 * region[side]}) {
      for (const double direction : {1.0, -1.0}) add(with_edge_moved(region, side, direction, by_m));
    }
  }
  for (const double by_m : {step_m, -step_m}) {
    for (const std::size_t parameter : {x, y}) add(with(region, {parameter}, by_m));
    add(with(region, {length, width}, by_m));
  }
  for (const double by_rad : {step_rad, -step_rad}) add(with(region, {heading}, by_rad));
  std::vector<double> square = region;
  square[length] = square[width] = 0.5 * (region[length] + region[width]);
  add(std::move(square));
  all.push_back(present);
  all.back().variant ^= under_each;
  return all;
}

// Discs around where the region is.
std::vector<TrialEffect> discs_near(const TrialEffect& region, double scale) {
  std::vector<TrialEffect> all;
  const double apart_m = 0.3 * scale;
  for (const double diameter_m : {0.5, 0.8, 1.2, 1.8}) {
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) {
        TrialEffect disc = region;
        disc.variant |= an_ellipse;
        disc.parameters[x] += apart_m * i;
        disc.parameters[y] += apart_m * j;
        disc.parameters[length] = disc.parameters[width] = scale * diameter_m;
        disc.parameters[heading] = 0.0;
        all.push_back(std::move(disc));
      }
    }
  }
  return all;
}

struct Tuned {
  TrialEffect region;
  double sum_squares = 0.0;
};

// Tunes the region at one place of a model.
class RegionTuning {
 public:
  RegionTuning(const FitProblem& train, const TrialModel& model, std::size_t place,
               const ParallelFor& parallel_for)
      : train_(train),
        model_(model),
        place_(place),
        outputs_(train.outputs_of(model.effects[place])),
        scale_(region_scale(train)),
        parallel_for_(parallel_for) {}

  Tuned best_of(const std::vector<TrialEffect>& regions) const {
    std::vector<double> sum_squares(regions.size());
    parallel_for_(regions.size(), [&](std::size_t i) {
      TrialModel tried = model_;
      tried.effects[place_] = regions[i];
      sum_squares[i] = sum_squares_of(train_.residuals(tried, outputs_));
    });
    const auto least = std::ranges::min_element(sum_squares);
    return {regions[static_cast<std::size_t>(least - sum_squares.begin())], *least};
  }

  Tuned moved_while_better(Tuned best) const {
    for (const double step : move_steps) {
      for (int move = 0; move < max_moves_of_size; ++move) {
        Tuned next = best_of(moved(best.region, scale_ * step, step));
        if (next.sum_squares > best.sum_squares - worth_a_move) break;
        best = std::move(next);
      }
    }
    return best;
  }

  // Whether the best of others leads to a better one.
  Tuned better_of(const Tuned& tuned, const std::vector<TrialEffect>& others) const {
    Tuned other = moved_while_better(best_of(others));
    return other.sum_squares < tuned.sum_squares ? other : tuned;
  }

 private:
  const FitProblem& train_;
  const TrialModel& model_;
  std::size_t place_;
  Outputs outputs_;
  double scale_;
  const ParallelFor& parallel_for_;
};

}  // namespace

bool has_region(const TrialModel& model) {
  return region_in(model).has_value();
}

// No step by step leads from one shape to another: the best rectangle is seldom as good an ellipse before
// that has found its own place.
TrialModel with_region_tuned(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for) {
  const auto place = region_in(model);
  if (!place) return model;
  const RegionTuning tuning(train, model, *place, parallel_for);
  Tuned best = tuning.moved_while_better(tuning.best_of({model.effects[*place]}));
  best = tuning.better_of(best, {reshaped(best.region)});
  model.effects[*place] = best.region;
  return model;
}

// What two regions have in common may be all of them that the runs passed over.
TrialModel with_region_found(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for) {
  model = with_region_tuned(train, model, parallel_for);
  const auto place = region_in(model);
  if (!place) return model;
  const RegionTuning tuning(train, model, *place, parallel_for);
  const Tuned tuned = tuning.best_of({model.effects[*place]});
  model.effects[*place] = tuning.better_of(tuned, discs_near(tuned.region, region_scale(train))).region;
  return model;
}

}  // namespace wheelwright::gap
