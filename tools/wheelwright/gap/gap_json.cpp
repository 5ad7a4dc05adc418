#include "tools/wheelwright/gap/gap_json.hpp"

#include <nlohmann/json.hpp>

#include "model/effects/library/effect_library.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/gap/check_section.hpp"
#include "tools/wheelwright/gap/simulation_section.hpp"

namespace wheelwright::tools {
namespace {

using nlohmann::ordered_json;

ordered_json finding_to_json(const gap::Finding& found) {
  const auto infos = parameters_of(found.setting);
  ordered_json parameters = ordered_json::object();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    ordered_json parameter = {{"value", found.setting.parameters[i]}, {"unit", infos[i].unit}};
    if (i < found.intervals.size()) parameter["ci95"] = {found.intervals[i].lower, found.intervals[i].upper};
    parameters[infos[i].name] = parameter;
  }
  ordered_json rivals = ordered_json::array();
  for (const auto& rival : found.rivals) {
    rivals.push_back({{"effect", rival.effect}, {"posterior", rival.posterior}});
  }
  ordered_json json = {{"effect", found.setting.name}};
  if (!found.setting.variant.empty()) json["variant"] = found.setting.variant;
  json["parameters"] = parameters;
  json["evidence"] = {{"heldout_gain_nats", found.heldout_gain_nats},
                      {"p_value", found.p_value},
                      {"posterior", found.posterior}};
  if (found.test_gain_nats) json["evidence"]["log_e_test"] = *found.test_gain_nats;
  json["rivals"] = rivals;
  return json;
}

// A set of runs under one key of a channel; empty where the logs cannot show it.
template <typename Pick>
ordered_json figures(const gap::GapFigures& figures, Pick pick) {
  const auto before = pick(figures.before);
  const auto after = pick(figures.after);
  const auto floor = pick(figures.floor);
  if (!before || !after) return nullptr;
  ordered_json json = {{"before", *before}, {"after", *after}};
  if (floor) json["floor"] = *floor;
  return json;
}

template <typename Pick>
void add_channel(ordered_json& gap, const std::string& name, const gap::GapAnalysis& analysis,
                 ordered_json head, Pick pick) {
  const ordered_json train = figures(analysis.train, pick);
  const ordered_json test = figures(analysis.test, pick);
  if (train.is_null() && test.is_null()) return;
  if (!train.is_null()) head["train"] = train;
  if (!test.is_null()) head["test"] = test;
  gap[name] = head;
}

template <typename Pick>
void add_channel_at_horizon(ordered_json& gap, const std::string& name, const gap::GapAnalysis& analysis,
                            Pick pick) {
  ordered_json head = ordered_json::object();
  if (const auto& figure = pick(analysis.train.before)) head["horizon_s"] = figure->horizon_s;
  add_channel(gap, name, analysis, head, [&](const Score& score) -> std::optional<double> {
    const auto& figure = pick(score);
    return figure ? std::optional(figure->value) : std::nullopt;
  });
}

ordered_json gap_sizes(const gap::GapAnalysis& analysis) {
  ordered_json gap = ordered_json::object();
  const ordered_json none = ordered_json::object();
  add_channel(gap, "wheel_speed_rms_m_s", analysis, none,
              [](const Score& score) { return score.wheel_speed_rms_m_s; });
  add_channel(gap, "distance_rms_m", analysis, none, [](const Score& score) { return score.distance_rms_m; });
  add_channel_at_horizon(gap, "position_rms_m", analysis,
                         [](const Score& score) { return score.position_rms_m; });
  add_channel_at_horizon(gap, "heading_rms_rad", analysis,
                         [](const Score& score) { return score.heading_rms_rad; });
  return gap;
}

// The path of the search: who was tried in each round, best first.
ordered_json rounds_to_json(const std::vector<gap::SelectionStep>& selection_steps) {
  ordered_json list = ordered_json::array();
  for (const auto& selection_step : selection_steps) {
    ordered_json tried = ordered_json::array();
    for (const auto& candidate : selection_step.candidates) {
      tried.push_back({{"effect", candidate.effect.info->name},
                       {"variant", candidate.effect.info->variants[candidate.effect.variant].name},
                       {"parameters", candidate.effect.parameters},
                       {"train_nats", candidate.train_nats},
                       {"heldout_nats", candidate.heldout_nats},
                       {"left_out_nats", candidate.left_out_nats},
                       {"inflation", candidate.autocorrelation_factor()},
                       {"score", candidate.score}});
    }
    list.push_back(tried);
  }
  return list;
}

ordered_json check_to_json(const gap::GapAnalysis& analysis) {
  const gap::PredictiveCheck& check = analysis.check;
  ordered_json json = {
      {"passed", check.passed}, {"p_value", check.p_value}, {"runs", checked_text(analysis.checked)}};
  ordered_json all = ordered_json::array();
  for (const auto& statistic : check.statistics) {
    ordered_json detail = ordered_json::object();
    for (const auto& [key, value] : statistic.detail) detail[key] = value;
    all.push_back({{"statistic", statistic.name},
                   {"p_value", statistic.p_value},
                   {"visible", statistic.visible},
                   {"detail", detail}});
  }
  if (!all.empty()) {
    json["statistic"] = all.front()["statistic"];
    json["detail"] = all.front()["detail"];
  }
  json["statistics"] = all;
  return json;
}

ordered_json data_to_json(const gap::GapAnalysis& analysis) {
  return {{"train", analysis.trained},
          {"selected_by", analysis.held_out},
          {"test", analysis.tested},
          {"untouched", analysis.untouched}};
}

ordered_json linear_changes_to_json(const std::vector<gap::LinearChange>& changes) {
  ordered_json list = ordered_json::array();
  for (const auto& change : changes) {
    list.push_back({{"what", change.what},
                    {"wheel", change.wheel},
                    {"value", change.value},
                    {"unit", change.unit},
                    {"ci95", {change.interval.lower, change.interval.upper}}});
  }
  return list;
}

ordered_json experiment_to_json(const gap::NextExperiment& next, const std::string& file) {
  return {{"route_or_commands", file},  {"separates", next.separates},
          {"seconds", next.seconds},    {"manoeuvre", next.manoeuvre},
          {"expected_nats", next.nats}, {"makes_testable", next.makes_testable}};
}

}  // namespace

std::string gap_to_json(const gap::GapAnalysis& analysis, const std::optional<gap::NextExperiment>& next,
                        const std::string& next_file, const ComparedSimulation* simulation) {
  ordered_json json = {{"verdict", gap::verdict_name(analysis.verdict)}, {"summary", analysis.summary}};
  json["added"] = ordered_json::array();
  for (const auto& found : analysis.found) json["added"].push_back(finding_to_json(found));
  json["where"] = ordered_json::array();
  for (const auto& regime : analysis.where) {
    json["where"].push_back({{"regime", regime.name},
                             {"share_of_gap", regime.share_of_gap},
                             {"share_of_time", regime.share_of_time}});
  }
  json["gap"] = gap_sizes(analysis);
  json["not_testable"] = ordered_json::array();
  for (const auto& effect : analysis.not_testable) {
    json["not_testable"].push_back({{"effect", effect.effect}, {"why", effect.why}});
  }
  json["detectable"] = ordered_json::array();
  for (const auto& effect : analysis.detectable) {
    json["detectable"].push_back({{"effect", effect.effect},
                                  {"parameter", effect.parameter},
                                  {"size", effect.size},
                                  {"unit", effect.unit}});
  }
  json["data_faults"] = ordered_json::array();
  for (const auto& fault : analysis.data_faults) {
    json["data_faults"].push_back({{"log", fault.log}, {"row", fault.row}, {"what", fault.text()}});
  }
  json["linear_changes"] = linear_changes_to_json(analysis.linear_changes);
  if (simulation != nullptr) json["simulation"] = simulation_to_json(*simulation);
  json["data"] = data_to_json(analysis);
  if (!analysis.check.statistics.empty()) json["check"] = check_to_json(analysis);
  json["next_experiment"] = nullptr;
  if (next) json["next_experiment"] = experiment_to_json(*next, next_file);
  json["search"] = {{"rounds", rounds_to_json(analysis.search.selection_steps)},
                    {"checks", rounds_to_json(analysis.search.checks)},
                    {"references_late_s", analysis.search.final.model.reference_lag_s()}};
  if (analysis.search.final.model.shape.gyro_scaled)
    json["search"]["gyro_scale"] = analysis.search.final.model.gyro_scale();
  return json_text(json) + "\n";
}

}  // namespace wheelwright::tools
