#include "model/gap/conclusion/linear_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "model/effects/library/effect_library.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::string_view delay_effect = "transport_delay";

const LinearChange* longer_delay(const std::vector<LinearChange>& changes) {
  const auto found = std::ranges::find_if(
      changes, [](const LinearChange& change) { return change.what == "delay" && change.value > 0.0; });
  return found == changes.end() ? nullptr : &*found;
}

bool has_period(const RobotModel& model, double period_s) {
  constexpr double same_period = 0.02;
  return std::abs(model.linear_part.period_s - period_s) <= same_period * period_s;
}

bool lag_changed(const std::vector<LinearChange>& changes) {
  return std::ranges::any_of(changes, [](const LinearChange& change) { return change.what == "lag"; });
}

Finding finding_of(const LinearChange& delay, double heldout_gain_nats) {
  Finding found;
  found.setting = {std::string(delay_effect), "", {delay.value}};
  found.intervals = {{std::max(0.0, delay.interval.lower), delay.interval.upper}};
  found.heldout_gain_nats = heldout_gain_nats;
  found.p_value = std::exp(-std::min(heldout_gain_nats, 600.0));
  found.posterior = 1.0 - found.p_value;
  return found;
}

void scale(std::vector<double>& weights, double gain) {
  for (double& weight : weights) weight *= gain;
}

// The given model with corrected gains and the delay as an effect.
RobotModel corrected_model(const RobotModel& given, const CommandCorrection& correction, const Finding& delay,
                           const std::vector<std::string>& source) {
  RobotModel model = given;
  for (WheelResponse* response : {&model.linear_part.left, &model.linear_part.right}) {
    scale(response->from_left, correction.gain.left);
    scale(response->from_right, correction.gain.right);
  }
  AddedEffect effect;
  effect.setting = delay.setting;
  effect.intervals = delay.intervals;
  effect.source = source;
  effect.heldout_gain_nats = delay.heldout_gain_nats;
  effect.p_value = delay.p_value;
  model.effects.insert(model.effects.begin(), std::move(effect));
  return model;
}

// Of an effect that the given model has and these runs have not, the lag that stands in its parameters
// instead of in the linear part stays.
std::vector<AddedEffect> lags_of_absent_effects(const RobotModel& given, const RobotModel& found) {
  std::vector<AddedEffect> lags;
  for (const AddedEffect& known : given.effects) {
    const EffectInfo& info = *find_effect(known.setting.name);
    const bool is_found = std::ranges::any_of(
        found.effects, [&](const AddedEffect& one) { return one.setting.name == info.name; });
    if (is_found || !info.linear_part) continue;
    AddedEffect& lag = lags.emplace_back();
    lag.setting = known.setting;
    lag.setting.parameters =
        info.linear_part({known.setting.parameters, variant_index(info, known.setting.variant)});
  }
  return lags;
}

}  // namespace

std::optional<Finding> delay_finding(const std::vector<LinearChange>& changes, double heldout_gain_nats) {
  const LinearChange* delay = longer_delay(changes);
  if (delay == nullptr) return std::nullopt;
  return finding_of(*delay, heldout_gain_nats);
}

void add_linear_changes(GapAnalysis& analysis, const LinearChanges& found, const RobotModel& given) {
  analysis.linear_changes = found.changes;
  if (found.changes.empty()) return;
  const std::string words = in_words(found.changes);
  if (analysis.verdict != Verdict::nothing_missing) {
    analysis.summary += " The linear part of the given model is off: " + words + ".";
    return;
  }
  const LinearChange* delay = longer_delay(found.changes);
  if (delay == nullptr) {
    analysis.verdict = Verdict::unnamed;
    analysis.summary = "No effect is missing, but the linear part of the given model is off: " + words +
                       ". The model that was written has it refitted.";
    return;
  }
  analysis.verdict = Verdict::named;
  analysis.summary = "Missing: transport_delay. The linear part of the given model is off: " + words + ".";
  analysis.found.push_back(*delay_finding(found.changes, found.heldout_gain_nats));
  if (!lag_changed(found.changes)) {
    analysis.after = corrected_model(given, found.correction, analysis.found.back(), analysis.after.source);
  }
}

std::string not_compared_in_words(const RobotModel& given, double period_s) {
  if (has_period(given, period_s)) return "";
  std::ostringstream words;
  words << " The given model's period is " << given.linear_part.period_s << " s and that of the logs "
        << period_s << " s: its linear part was not compared with them.";
  return words.str();
}

LinearChanges changes_of_linear_part(const TrialModel& accepted, const ModelOrigin& origin,
                                     const FitProblem& train, const FitProblem& heldout) {
  const RobotModel& given = *origin.given;
  if (!has_period(given, train.runs().front().period_s)) return {};
  RobotModel whole = whole_model_of(accepted, origin);
  whole.linear_part = given.linear_part;
  // A linear effect that was found, as a delay, stands beside the fitted linear part; beside the given one it
  // has another size.
  std::erase_if(whole.effects, [&](const AddedEffect& effect) {
    const auto same = [&](const AddedEffect& known) { return known.setting.name == effect.setting.name; };
    return find_effect(effect.setting.name)->linear && std::ranges::none_of(given.effects, same);
  });
  std::ranges::move(lags_of_absent_effects(given, whole), std::back_inserter(whole.effects));
  const NoiseModel noise = train.noise_left_by(accepted);
  FitProblem fitted = train;
  FitProblem confirming = heldout;
  fitted.set_noise(noise);
  confirming.set_noise(noise);
  return linear_changes(whole, accepted, fitted, confirming);
}

bool add_linear_changes(GapAnalysis& analysis, const ModelOrigin& origin, const FitProblem& train,
                        const FitProblem& heldout) {
  add_linear_changes(analysis, changes_of_linear_part(analysis.search.final.model, origin, train, heldout),
                     *origin.given);
  return !analysis.linear_changes.empty();
}

}  // namespace wheelwright::gap
