#include "model/gap/candidates/screening_probes.hpp"

#include <algorithm>

#include "model/gap/candidates/region_scale.hpp"
#include "model/gap/candidates/screening_pairs.hpp"

namespace wheelwright::gap {
namespace {

// Places where the robot has been.
std::vector<Pose> visited_places(const FitProblem& problem, const TrialModel& model, double scale) {
  const double apart_m = 0.35 * scale;
  constexpr std::size_t most = 40;
  std::vector<Pose> places;
  for (const auto& run : problem.runs()) {
    const auto states = model_states(model, run);
    const std::size_t step = std::max<std::size_t>(1, states.size() / 200);
    for (std::size_t k = 0; k < states.size(); k += step) {
      Pose at = states[k].pose;
      // Where the robot really was is known better than where the model thinks.
      for (const auto& reference : run.references) {
        if (reference.at.period >= k) {
          at = reference.pose;
          break;
        }
      }
      const auto near = [&](const Pose& other) { return distance_between_m(at, other) < apart_m; };
      if (places.size() < most && std::ranges::none_of(places, near)) places.push_back(at);
    }
  }
  return places;
}

// Without counts nothing tells whether the wheels or the floor lose the motion: one of the two is enough. Nor
// which of two wheels is not as large as it should be.
// What a region does under each wheel by itself, and of what shape it is, is tried when its place is known
// (region_search.hpp).
bool told_apart(const EffectInfo& info, std::size_t variant, bool counts) {
  const std::string& name = info.variants[variant].name;
  const bool needs_counts = name.ends_with("at_wheels") || name.ends_with("_wheel");
  return (counts || !needs_counts) && !name.ends_with("_each") && !name.ends_with("_round");
}

using Points = std::vector<std::vector<double>>;

// Each point once for each value of a parameter.
Points spread(const Points& points, std::size_t parameter, const std::vector<double>& values) {
  Points all;
  for (const auto& point : points) {
    for (const double value : values) {
      all.push_back(point);
      all.back()[parameter] = value;
    }
  }
  return all;
}

// Each point once for each place.
Points spread(const Points& points, std::size_t x, std::size_t y, const std::vector<Pose>& places) {
  Points all;
  for (const auto& point : points) {
    for (const Pose& place : places) {
      all.push_back(point);
      all.back()[x] = place.x_m;
      all.back()[y] = place.y_m;
    }
  }
  return all;
}

// Where regions may lie, and how much larger than those of a room they may be (region_scale.hpp).
struct Floor {
  std::vector<Pose> places;
  double scale = 1.0;
};

std::vector<double> scaled_sizes(const ParameterInfo& side, double scale) {
  std::vector<double> sizes = side.sizes;
  for (double& size : sizes) size = std::min(scale * size, side.upper);
  return sizes;
}

// All that does not scale the effect, in all combinations, with x and y together; the sizes are still zero.
Points shapes_of(const std::vector<ParameterInfo>& parameters, const Floor& floor) {
  Points points{std::vector<double>(parameters.size(), 0.0)};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterInfo& parameter = parameters[i];
    if (parameter.scales_effect || parameter.name == "y") continue;
    const bool is_side = parameter.name == "length" || parameter.name == "width";
    points = parameter.name == "x"
                 ? spread(points, i, i + 1, floor.places)
                 : spread(points, i, is_side ? scaled_sizes(parameter, floor.scale) : parameter.sizes);
  }
  return points;
}

// One size is tried at several values, one at a time; several sizes at one value each, together.
void add_probes(const EffectInfo& info, std::size_t variant, const Floor& floor, std::vector<Probe>& probes) {
  const std::vector<ParameterInfo>& parameters = info.parameters_of(variant);
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].scales_effect) sizes.push_back(i);
  }
  for (const auto& shape : shapes_of(parameters, floor)) {
    if (sizes.size() == 1) {
      for (auto& point : spread({shape}, sizes[0], parameters[sizes[0]].sizes)) {
        probes.push_back({&info, variant, {std::move(point)}});
      }
    } else if (sizes.size() > 1) {
      Probe probe{&info, variant, Points(sizes.size(), shape)};
      for (std::size_t i = 0; i < sizes.size(); ++i) {
        probe.points[i][sizes[i]] = parameters[sizes[i]].sizes.front();
      }
      probes.push_back(std::move(probe));
    }
  }
}

// Of an effect with a size for each wheel: every other size at one wheel alone, with the first and the last
// shape. Where both wheels have it, the variant whose wheels are alike shows it as well.
void add_probes_of_one_wheel(const EffectInfo& info, std::size_t variant, const Floor& floor,
                             std::vector<Probe>& probes) {
  const std::vector<ParameterInfo>& parameters = info.parameters_of(variant);
  Points shapes = shapes_of(parameters, floor);
  for (auto& shape : shapes) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {  // none of it, as no limit is a high one
      if (parameters[i].scales_effect && !vanishes_at_zero(parameters[i])) shape[i] = parameters[i].upper;
    }
  }
  for (std::size_t wheel = 0; wheel < parameters.size(); ++wheel) {
    if (!parameters[wheel].scales_effect) continue;
    for (std::size_t size = 1; size < parameters[wheel].sizes.size(); size += 2) {
      for (std::size_t shape = 0; shape < shapes.size();
           shape += std::max<std::size_t>(1, shapes.size() - 1)) {
        std::vector<double> point = shapes[shape];
        point[wheel] = parameters[wheel].sizes[size];
        probes.push_back({&info, variant, {std::move(point)}});
      }
    }
  }
}

}  // namespace

std::vector<Probe> probes_of(std::span<const EffectInfo* const> candidate_effects, const FitProblem& problem,
                             const TrialModel& model) {
  std::vector<Probe> probes;
  const double scale = region_scale(problem);
  const Floor floor{visited_places(problem, model, scale), scale};
  for (const EffectInfo* info : candidate_effects) {
    for (std::size_t variant = 0; variant < info->variants.size(); ++variant) {
      if (info->variants[variant].alike) {
        add_probes_of_one_wheel(*info, variant, floor, probes);
      } else if (told_apart(*info, variant, problem.has_counts())) {
        add_probes(*info, variant, floor, probes);
      }
    }
  }
  return probes;
}

}  // namespace wheelwright::gap
