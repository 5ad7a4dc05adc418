#include "tools/wheelwright/fit/fit_json.hpp"

#include "model/prediction/segments.hpp"

namespace wheelwright::tools {
namespace {

using nlohmann::ordered_json;

ordered_json gain_json(double value, double standard_error) {
  return {{"value", value}, {"standard_error", standard_error}};
}

ordered_json wheel_json(const WheelFit& fit) {
  return {{"gain_from_left", gain_json(fit.gain.from_left, fit.gain_standard_error.from_left)},
          {"gain_from_right", gain_json(fit.gain.from_right, fit.gain_standard_error.from_right)},
          {"position_noise_m", fit.position_noise_m},
          {"drift_m_per_sqrt_s", fit.drift_m_per_sqrt_s}};
}

ordered_json arma_wheel_json(const ArmaWheelFit& fit) {
  ordered_json json = wheel_json(fit.quality);
  json["largest_pole"] = fit.largest_pole;
  json["condition"] = fit.condition;
  json["rank"] = fit.rank;
  json["unknowns"] = fit.unknowns;
  json["one_step_rms_m_s"] = fit.one_step_rms_m_s;
  return json;
}

ordered_json orders_json(const OrderSweep& sweep) {
  ordered_json orders = ordered_json::array();
  for (const auto& row : sweep.rows) {
    if (row.refusal) {
      orders.push_back({{"order", row.order}, {"refused", row.refusal->reason}});
      continue;
    }
    orders.push_back({{"order", row.order},
                      {"one_step_rms_m_s", row.one_step_rms_m_s},
                      {"held_out_distance_rms_m", row.held_out_distance_rms_m},
                      {"standard_error_m", row.standard_error_m},
                      {"largest_pole", row.largest_pole},
                      {"condition", row.condition},
                      {"multiplications", row.multiplications},
                      {"best", row.order == sweep.best},
                      {"chosen", row.order == sweep.chosen}});
  }
  return orders;
}

void add_fir(ordered_json& json, const FirReport& report) {
  json["type"] = "fir";
  json["order"] = report.fit.model.left.from_left.size();
  json["rows"] = report.fit.rows;
  json["response_cut"] = report.fit.cut;
  json["left"] = wheel_json(report.fit.left);
  json["right"] = wheel_json(report.fit.right);
  json["free_run"] = {{"distance_rms_m", report.score.distance_rms_m.value_or(0.0)},
                      {"wheel_speed_rms_m_s", report.score.wheel_speed_rms_m_s.value_or(0.0)}};
}

void add_arma(ordered_json& json, const ArmaFit& fit) {
  json["type"] = "arma";
  json["order"] = fit.model.left.from_own_past.size();
  json["rows"] = fit.rows;
  json["left"] = arma_wheel_json(fit.left);
  json["right"] = arma_wheel_json(fit.right);
  json["free_run"] = {{"distance_rms_m", fit.free_run_distance_rms_m}};
  if (fit.sweep) json["orders"] = orders_json(*fit.sweep);
}

ordered_json holes_json(const std::vector<DriveLog>& runs) {
  ordered_json holes = ordered_json::array();
  for (const auto& run : runs) {
    for (const auto& hole : find_holes(run)) {
      holes.push_back(
          {{"log", run.name}, {"line", run.first_line + hole.row}, {"duration_s", hole.duration_s}});
    }
  }
  return holes;
}

ordered_json speeds_json(const std::vector<SteadyStateSpeed>& speeds) {
  ordered_json json = ordered_json::array();
  for (const auto& speed : speeds) {
    json.push_back({{"command_m_s", speed.command_m_s},
                    {"speed_m_s", speed.speed_m_s},
                    {"standard_error_m_s", speed.standard_error_m_s},
                    {"holds", speed.holds},
                    {"held_s", speed.held_s}});
  }
  return json;
}

ordered_json gain_at_json(const GainAt& gain) {
  return {{"command_m_s", gain.command_m_s}, {"gain", gain.gain}, {"standard_error", gain.standard_error}};
}

ordered_json settled_json(const FitReport& report) {
  ordered_json json{{"left", speeds_json(report.speeds.left)}, {"right", speeds_json(report.speeds.right)}};
  if (const auto& bend = report.curve.bend) {
    json["bend"] = {{"low", gain_at_json(bend->low)}, {"high", gain_at_json(bend->high)}};
  }
  if (const auto& hole = report.hole) {
    json["hole"] = {{"from_m_s", hole->from_m_s},
                    {"to_m_s", hole->to_m_s},
                    {"moves_below_m_s", hole->moves_below_m_s},
                    {"moves_above_m_s", hole->moves_above_m_s},
                    {"commands", hole->commands}};
  }
  if (const auto& steps = report.curve.steps) {
    json["steps"] = {{"step_m_s", steps->step_m_s},
                     {"ci95", {steps->smallest_m_s, steps->largest_m_s}},
                     {"p_value", steps->p_value}};
  }
  return json;
}

}  // namespace

ordered_json fit_json(const FitReport& report, const std::string& model_file) {
  ordered_json json{{"model", model_file}, {"runs", report.runs.size()}};
  if (const auto* fir = std::get_if<FirReport>(&report.fit)) {
    add_fir(json, *fir);
  } else {
    add_arma(json, std::get<ArmaFit>(report.fit));
  }
  json["holes"] = holes_json(report.runs);
  json["steady_state_map"] = settled_json(report);
  return json;
}

}  // namespace wheelwright::tools
