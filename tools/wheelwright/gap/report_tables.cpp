#include "tools/wheelwright/gap/report_tables.hpp"

#include <algorithm>
#include <vector>

#include "model/effects/library/effect_library.hpp"
#include "model/gap/candidates/decoys.hpp"
#include "tools/wheelwright/gap/check_section.hpp"
#include "tools/wheelwright/gap/gap_text.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/number_text.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using Rows = std::vector<std::vector<std::string>>;

std::string section(const std::string& title, const std::string& body) {
  return body.empty() ? "" : html::element("h2", title) + body;
}

std::string with_variant(const std::string& name, const std::string& variant) {
  return variant.empty() ? name : name + " (" + variant + ")";
}

std::string unit_text(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

std::string finding(const gap::Finding& found) {
  const EffectInfo* info = find_effect(found.setting.name);
  if (info == nullptr) return "";
  std::string text = html::element("h3", with_variant(found.setting.name, found.setting.variant));
  text += html::element("p", info->summary + ".");
  text += "<p class=\"quiet\">" + html::escaped(info->cause) + "</p>\n";
  Rows rows;
  const auto parameters = parameters_of(found.setting);
  for (std::size_t i = 0; i < parameters.size() && i < found.setting.parameters.size(); ++i) {
    const ParameterInfo& parameter = parameters[i];
    const bool known = i < found.intervals.size();
    rows.push_back({parameter.name, short_number(found.setting.parameters[i]),
                    known ? "[" + short_number(found.intervals[i].lower) + ", " +
                                short_number(found.intervals[i].upper) + "]"
                          : "-",
                    unit_text(parameter.unit), parameter.meaning});
  }
  text += html::table({"parameter", "value", "95 % interval", "unit", "meaning"}, rows);
  text += html::element("p", "With it the log likelihood of held-out runs is higher by " +
                                 fixed_number(found.heldout_gain_nats, 1) +
                                 " (corrected for correlation); "
                                 "probability of this name " +
                                 fixed_number(found.posterior, 3) + ".");
  Rows rivals;
  for (const auto& rival : found.rivals) {
    const std::string name = rival.effect == "decoy" ? "a decoy (something without a name)" : rival.effect;
    rivals.push_back({name, rival.posterior < 0.001 ? "< 0.001" : fixed_number(rival.posterior, 3)});
  }
  return text + html::table({"rival in its place", "probability"}, rivals);
}

std::string bar(const std::string& kind, double share) {
  return "<div><span class=\"bar " + kind + "\" style=\"width:" + fixed_number(80.0 * share, 1) +
         "%\"></span> " + percent(share) + "</div>";
}

void add_row(Rows& rows, const std::string& channel, const std::string& runs, double scale,
             const std::optional<double>& before, const std::optional<double>& after,
             const std::optional<double>& floor) {
  if (!before || !after) return;
  const double reducible = *before * *before - (floor ? *floor * *floor : 0.0);
  const double closed = *before * *before - *after * *after;
  rows.push_back(
      {channel, runs, fixed_number(scale * *before, 2), fixed_number(scale * *after, 2),
       floor ? fixed_number(scale * *floor, 2) : "-",
       floor && reducible > 0.02 * *before * *before ? percent(std::min(1.0, closed / reducible)) : "-"});
}

template <typename Pick>
void add_channel(Rows& rows, const gap::GapAnalysis& analysis, const std::string& name, Pick pick) {
  for (const bool heldout : {false, true}) {
    const gap::GapFigures& figures = heldout ? analysis.test : analysis.train;
    add_row(rows, name, heldout ? test_runs_text(analysis) : "training", 1000.0, pick(figures.before),
            pick(figures.after), pick(figures.floor));
  }
}

std::string at_horizon(const std::optional<AtHorizon>& figure, const std::string& what,
                       const std::string& unit) {
  return what + " after " + (figure ? fixed_number(figure->horizon_s, 0) : "-") + " s, " + unit;
}

std::optional<double> value(const std::optional<AtHorizon>& figure) {
  return figure ? std::optional(figure->value) : std::nullopt;
}

std::string parameters_text(const gap::TrialEffect& effect) {
  std::string text;
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const ParameterInfo& info = effect.parameter_info(i);
    const std::string unit = unit_text(info.unit);
    text += (i > 0 ? ", " : "") + info.name + " " + short_number(effect.parameters[i]) +
            (unit.empty() ? "" : " " + unit);
  }
  return text;
}

std::string present_effects(const gap::TrialModel& model) {
  std::string text;
  for (const auto& effect : model.effects) text += (text.empty() ? "" : ", ") + effect.info->name;
  return text.empty() ? "the linear model alone" : "the linear model with " + text;
}

std::string selection_steps(const std::vector<gap::SelectionStep>& list, const std::string& title) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Rows rows;
    for (const auto& candidate : list[i].candidates) {
      const gap::TrialEffect& effect = candidate.effect;
      rows.push_back({with_variant(effect.info->name, effect.info->variants[effect.variant].name),
                      gap::is_decoy(*effect.info) ? "decoy" : "", parameters_text(effect),
                      fixed_number(candidate.train_nats, 1), fixed_number(candidate.unseen_nats(), 1),
                      fixed_number(candidate.autocorrelation_factor(), 1), fixed_number(candidate.score, 1)});
    }
    const std::string summary = title + " " + std::to_string(i + 1) + ": effects that could be added to " +
                                present_effects(list[i].without.model);
    text += "<details" + std::string(i == 0 && title == "Step" ? " open" : "") + "><summary>" +
            html::escaped(summary) + "</summary>\n" +
            (rows.empty() ? html::element("p", "No effect was worth a fit.")
                          : html::table({"effect", "", "parameters", "training gain", "held-out gain",
                                         "autocorrelation factor", "score"},
                                        rows)) +
            "</details>\n";
  }
  return text;
}

}  // namespace

std::string findings_section(const gap::GapAnalysis& analysis) {
  std::string text;
  for (const auto& found : analysis.found) text += finding(found);
  return section(analysis.verdict == gap::Verdict::ambiguous ? "What may be missing" : "What was added",
                 text);
}

std::string where_section(const gap::GapAnalysis& analysis) {
  if (analysis.where.empty()) return "";
  std::string text =
      "<p class=\"quiet\">Share of the gap (coloured) against share of the time (grey), on training runs. A "
      "regime that holds far more of the gap than of the time is where to look.</p>\n<div class=\"bars\">\n";
  for (const auto& regime : analysis.where) {
    text += "<div>" + html::escaped(regime.name) + "</div><div>" + bar("gap", regime.share_of_gap) +
            bar("time", regime.share_of_time) + "</div>\n";
  }
  return section("Where the linear model is wrong", text + "</div>\n");
}

std::string gap_section(const gap::GapAnalysis& analysis) {
  Rows rows;
  add_channel(rows, analysis, "wheel speed, mm/s", [](const Score& s) { return s.wheel_speed_rms_m_s; });
  add_channel(rows, analysis, "wheel travel, mm", [](const Score& s) { return s.distance_rms_m; });
  const Score& shown = analysis.train.before.empty() ? analysis.test.before : analysis.train.before;
  add_channel(rows, analysis, at_horizon(shown.position_rms_m, "position", "mm"),
              [](const Score& s) { return value(s.position_rms_m); });
  add_channel(rows, analysis, at_horizon(shown.heading_rms_rad, "heading", "mrad"),
              [](const Score& s) { return value(s.heading_rms_rad); });
  std::string text = html::table({"RMS of free run", "runs", "before", "after", "floor", "closed"}, rows);
  if (text.empty()) return "";
  text +=
      "<p class=\"quiet\">Floor: what the right model would show, from the noise that was found. Closed: "
      "share of the reducible square (before less floor) that is gone; a dash where there is nothing to "
      "reduce.";
  if (analysis.tail_held_out)
    text += " A single run: its last third was held out, and has no figures of its own.";
  text += " " + late_references_text(analysis);
  return section("The gap, before and after", text + "</p>\n");
}

std::string residual_section(const std::optional<gap::ResidualTable>& table) {
  if (!table) return "";
  Rows rows;
  for (const auto& row : table->rows) {
    rows.push_back({short_number(row.from), short_number(row.to), short_number(row.mean),
                    short_number(row.ci95), percent(row.share_of_time)});
  }
  const std::string over = table->over + ", " + table->over_unit;
  std::string text =
      html::table({over + ": from", "to", table->residual + " beyond the model, " + table->residual_unit,
                   "+- (95 %)", "share of time"},
                  rows);
  text += "<p class=\"quiet\">Measured less predicted " + html::escaped(table->residual) +
          ", means over a quarter of a second, over all runs; between the rows lies " +
          percent(table->explained) +
          " of its variance. This is a tabulated correction, not an explanation: it was not added to "
          "model.yaml.</p>\n";
  return section("Residuals over " + table->over + " (tabulated correction)", text);
}

std::string search_section(const gap::GapAnalysis& analysis) {
  std::string text = selection_steps(analysis.search.selection_steps, "Step") +
                     selection_steps(analysis.search.checks, "Check");
  if (text.empty()) return "";
  return section(
      "The search",
      "<p class=\"quiet\">The gains are those of the log likelihood over the model without the effect; "
      "autocorrelated residuals overstate them by the factor. The score is the sum of both gains, divided by "
      "the factor, less a penalty for the parameters. Decoys have no name and no cause: a name must beat "
      "them. Checks: each accepted "
      "effect taken out again, and who would take its place.</p>\n" +
          text);
}

std::string limits_section(const gap::GapAnalysis& analysis) {
  Rows untestable;
  for (const auto& effect : analysis.not_testable) untestable.push_back({effect.effect, effect.why});
  Rows detectable;
  for (const auto& effect : analysis.detectable) {
    detectable.push_back(
        {effect.effect, effect.parameter, short_number(effect.size), unit_text(effect.unit)});
  }
  std::string text = section("What these runs cannot show", html::table({"effect", "why"}, untestable));
  if (!detectable.empty()) {
    text += section("What would have shown",
                    "<p class=\"quiet\">The smallest size of each absent effect that these runs would have "
                    "shown with a probability of 80 %.</p>\n" +
                        html::table({"effect", "parameter", "size", "unit"}, detectable));
  }
  return text;
}

std::string faults_section(const gap::GapAnalysis& analysis) {
  Rows faults;
  Rows events;
  for (const auto& fault : analysis.data_faults) {
    (fault.happened ? events : faults).push_back({fault.log + ":" + std::to_string(fault.row), fault.text()});
  }
  return section("Faults of the data", html::table({"where", "what"}, faults)) +
         section("What held a wheel", html::table({"where", "what"}, events));
}

}  // namespace wheelwright::tools
