#include "model/gap/candidates/quantization_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "model/gap/candidates/quantization_levels.hpp"
#include "model/gap/runs/fastest_command.hpp"

namespace wheelwright::gap {
namespace {

constexpr int max_moves = 3;           // of a rise, up or down
constexpr double widest_apart = 0.06;  // of a step, two places of a rise that are tried
constexpr double closest_apart = 0.002;
constexpr double widest_to_centre = 0.04;
constexpr double closest_to_centre = 0.003;
constexpr double default_autocorrelation_factor = 10.0;  // of a likelihood, by correlation

// The speeds that the steps stand for stay as they are: the linear part answers less to what is larger.
TrialModel with_steps(TrialModel model, std::size_t place, const CommandSteps& steps) {
  auto& parameters = model.effects[place].parameters;
  const double times = steps.step_m_s / parameters[0];
  parameters = {steps.step_m_s, std::clamp(steps.level_edges, 0.0, 1.0)};
  const std::size_t per_wheel = model.shape.per_wheel();
  for (std::size_t i = 0; i < model.shape.of_responses(); ++i) {
    if (model.shape.is_weight(i % per_wheel)) model.linear_part[i] /= times;
  }
  return model;
}

std::vector<double> sum_squares_of_all(const FitProblem& train, const std::vector<TrialModel>& models,
                                       const ParallelFor& parallel_for) {
  const Outputs outputs = train.outputs_of(EffectStage::command);
  std::vector<double> sum_squares(models.size());
  parallel_for(models.size(),
               [&](std::size_t i) { sum_squares[i] = sum_squares_of(train.residuals(models[i], outputs)); });
  return sum_squares;
}

std::optional<std::size_t> place_of_steps(const TrialModel& model) {
  const auto effect =
      std::ranges::find_if(model.effects, [](const auto& present) { return rounds_commands(*present.info); });
  if (effect == model.effects.end()) return std::nullopt;
  return static_cast<std::size_t>(effect - model.effects.begin());
}

// All that differ in the commands at which it rises first and, at the fastest command, last: `apart` is a
// share of a step.
std::vector<TrialModel> with_moved_rises(const TrialModel& model, std::size_t place, double fastest_m_s,
                                         double apart) {
  const CommandSteps middle{model.effects[place].parameters[0], model.effects[place].parameters[1]};
  const double steps_between = std::max(1.0, std::floor(fastest_m_s / middle.step_m_s - middle.level_edges));
  std::vector<TrialModel> all;
  for (int first = -max_moves; first <= max_moves; ++first) {
    for (int last = -max_moves; last <= max_moves; ++last) {
      const double step_m_s = middle.step_m_s * (1.0 + apart * (last - first) / steps_between);
      const double first_m_s = middle.step_m_s * (middle.level_edges + apart * first);
      all.push_back(with_steps(model, place, {step_m_s, first_m_s / step_m_s}));
    }
  }
  return all;
}

// Of all models, by their likelihood.
CommandSteps mean_steps(const std::vector<TrialModel>& models, const std::vector<double>& sum_squares,
                        double least, std::size_t place) {
  CommandSteps mean{0.0, 0.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const auto& parameters = models[i].effects[place].parameters;
    const double weight = std::exp(-0.5 * (sum_squares[i] - least) / default_autocorrelation_factor);
    mean.step_m_s += weight * parameters[0];
    mean.level_edges += weight * parameters[1];
    sum += weight;
  }
  return {mean.step_m_s / sum, mean.level_edges / sum};
}

}  // namespace

bool rounds_commands(const EffectInfo& info) {
  return info.name == "command_quantization";
}

TrialModel with_steps_tuned(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for) {
  const auto place = place_of_steps(model);
  if (!place) return model;
  const double fastest_m_s = fastest_command_m_s(train.runs());
  double least = sum_squares_of(train.residuals(model, train.outputs_of(EffectStage::command)));
  for (double apart = widest_apart; apart > closest_apart; apart *= 0.5) {
    const std::vector<TrialModel> tried = with_moved_rises(model, *place, fastest_m_s, apart);
    const std::vector<double> sum_squares = sum_squares_of_all(train, tried, parallel_for);
    const auto best = std::ranges::min_element(sum_squares);
    if (*best >= least) continue;
    least = *best;
    model = tried[static_cast<std::size_t>(best - sum_squares.begin())];
  }
  return model;
}

TrialModel with_steps_centred(const FitProblem& train, TrialModel model, const ParallelFor& parallel_for) {
  const auto place = place_of_steps(model);
  if (!place) return model;
  const Outputs outputs = train.outputs_of(EffectStage::command);
  const double fastest_m_s = fastest_command_m_s(train.runs());
  for (double apart = widest_to_centre; apart > closest_to_centre; apart *= 0.5) {
    const std::vector<TrialModel> tried = with_moved_rises(model, *place, fastest_m_s, apart);
    const std::vector<double> sum_squares = sum_squares_of_all(train, tried, parallel_for);
    const double least = *std::ranges::min_element(sum_squares);
    const TrialModel centred = with_steps(model, *place, mean_steps(tried, sum_squares, least, *place));
    if (sum_squares_of(train.residuals(centred, outputs)) < least + 2.0 * default_autocorrelation_factor)
      model = centred;
  }
  return model;
}

}  // namespace wheelwright::gap
