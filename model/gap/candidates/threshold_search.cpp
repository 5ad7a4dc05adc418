#include "model/gap/candidates/threshold_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace wheelwright::gap {
namespace {

constexpr std::string_view dead_zone = "dead_zone";
constexpr std::string_view stiction = "stiction";

// Of stiction.
constexpr std::size_t breakaway = 0;
constexpr std::size_t sticking_speed = 3;

// The sizes of all commands up to `largest_m_s`, each once.
std::vector<double> command_sizes_m_s(const FitProblem& problem, double largest_m_s) {
  std::vector<double> sizes{0.0};
  for (const auto& run : problem.runs()) {
    for (const auto& u : run.commands_m_s) {
      for (const double size : {std::abs(u.left), std::abs(u.right)}) {
        if (size <= largest_m_s) sizes.push_back(size);
      }
    }
  }
  std::ranges::sort(sizes);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

constexpr std::size_t max_tried = 40;

// In the middle between sizes of commands that are `stride` apart.
std::vector<double> between(const std::vector<double>& sizes, std::size_t stride) {
  std::vector<double> middles;
  for (std::size_t i = stride; i < sizes.size(); i += stride) {
    middles.push_back(0.5 * (sizes[i - 1] + sizes[i]));
  }
  return middles;
}

std::vector<double> nearest(std::vector<double> values, double to, std::size_t count) {
  std::ranges::sort(values, {}, [to](double value) { return std::abs(value - to); });
  values.resize(std::min(values.size(), count));
  return values;
}

// From `value / most` to `value * most`, each by the same factor more than the one before.
std::vector<double> context(double value, double most, int each_side) {
  std::vector<double> values;
  for (int i = -each_side; i <= each_side; ++i) {
    if (i != 0) values.push_back(value * std::pow(most, static_cast<double>(i) / each_side));
  }
  return values;
}

class Tuning {
 public:
  Tuning(const FitProblem& train, TrialModel& model)
      : train_(train), model_(model), min_(sum_squares_of(train.residuals(model))) {}

  // Leaves the parameter where the free runs are best.
  void choose(std::size_t effect, std::size_t parameter, const std::vector<double>& values) {
    for (const double value : values) {
      std::vector<double> parameters = model_.effects[effect].parameters;
      parameters[parameter] = value;
      try_with(effect, std::move(parameters));
    }
  }

  // The same of several parameters at once, which hang on each other.
  void choose(std::size_t effect, const std::vector<std::vector<double>>& of_all_parameters) {
    for (const auto& parameters : of_all_parameters) try_with(effect, parameters);
  }

 private:
  void try_with(std::size_t effect, std::vector<double> parameters) {
    TrialModel tried = model_;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto& info = tried.effects[effect].parameter_info(i);
      parameters[i] = std::clamp(parameters[i], info.lower, info.upper);
    }
    tried.effects[effect].parameters = std::move(parameters);
    const double sum_squares = sum_squares_of(train_.residuals(tried));
    if (sum_squares >= min_) return;
    min_ = sum_squares;
    model_ = std::move(tried);
  }

  const FitProblem& train_;
  TrialModel& model_;
  double min_;
};

// Of the wheels, or of one of them. Firmware passes commands above its threshold whole, an output stage less:
// each threshold is tried with the taper, the last parameter, as it is, and as a step.
void tune_dead_zone(const FitProblem& train, const TrialModel& model, std::size_t effect,
                    std::size_t threshold, Tuning& tuning) {
  constexpr double max_times = 3.0;  // of the threshold as it is
  const auto parameters = [&] { return model.effects[effect].parameters; };
  const std::size_t taper = parameters().size() - 1;
  const double step = model.effects[effect].parameter_info(taper).lower;
  const std::vector<double> sizes = command_sizes_m_s(train, max_times * parameters()[threshold]);
  const std::size_t stride = 1 + sizes.size() / max_tried;
  const auto with_tapers = [&](const std::vector<double>& thresholds) {
    std::vector<std::vector<double>> tried;
    for (const double value : thresholds) {
      for (const double shape : {parameters()[taper], step}) {
        tried.push_back(parameters());
        tried.back()[threshold] = value;
        tried.back()[taper] = shape;
      }
    }
    return tried;
  };
  tuning.choose(effect, with_tapers(between(sizes, stride)));
  if (stride > 1)
    tuning.choose(effect, with_tapers(nearest(between(sizes, 1), parameters()[threshold], 2 * stride)));
}

}  // namespace

bool has_threshold(const EffectInfo& info) {
  return info.name == dead_zone || info.name == stiction;
}

TrialModel with_thresholds_tuned(const FitProblem& train, TrialModel model) {
  const auto with_one = std::ranges::find_if(
      model.effects, [](const TrialEffect& effect) { return has_threshold(*effect.info); });
  if (with_one == model.effects.end()) return model;
  Tuning tuning(train, model);
  for (std::size_t i = 0; i < model.effects.size(); ++i) {
    const auto value = [&](std::size_t parameter) { return model.effects[i].parameters[parameter]; };
    if (model.effects[i].info->name == dead_zone) {
      for (std::size_t threshold = 0; threshold + 1 < model.effects[i].parameters.size(); ++threshold)
        tune_dead_zone(train, model, i, threshold, tuning);
    } else if (model.effects[i].info->name == stiction) {
      for (const double most : {1.3, 1.04}) {
        tuning.choose(i, breakaway, context(value(breakaway), most, 12));
        tuning.choose(i, sticking_speed, context(value(sticking_speed), most * most, 4));
      }
    }
  }
  return model;
}

}  // namespace wheelwright::gap
