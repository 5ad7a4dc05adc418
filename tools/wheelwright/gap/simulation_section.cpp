#include "tools/wheelwright/gap/simulation_section.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/gap/check_section.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/number_text.hpp"
#include "tools/wheelwright/prediction/score_json.hpp"

namespace wheelwright::tools {
namespace {

using nlohmann::ordered_json;

ordered_json known_to_json(const gap::Known& known) {
  return {{"value", known.value}, {"ci95", {known.interval.lower, known.interval.upper}}};
}

ordered_json difference_to_json(const gap::EffectDifference& difference) {
  ordered_json parameters = ordered_json::object();
  for (const auto& parameter : difference.parameters) {
    ordered_json json = {{"unit", parameter.unit}, {"differs", parameter.differs}};
    if (parameter.simulation) json["simulation"] = known_to_json(*parameter.simulation);
    if (parameter.robot) json["robot"] = known_to_json(*parameter.robot);
    parameters[parameter.name] = json;
  }
  ordered_json json = {{"effect", difference.effect}, {"kind", gap::kind_name(difference.kind)}};
  if (!difference.simulation_form.empty()) json["simulation_variant"] = difference.simulation_form;
  if (!difference.robot_form.empty()) json["robot_variant"] = difference.robot_form;
  json["parameters"] = parameters;
  return json;
}

std::string size_text(const std::optional<gap::Known>& known) {
  if (!known) return "-";
  return short_number(known->value) + " [" + short_number(known->interval.lower) + ", " +
         short_number(known->interval.upper) + "]";
}

std::string words_for(gap::DifferenceKind kind) {
  switch (kind) {
    case gap::DifferenceKind::missing:
      return "missing in the simulation";
    case gap::DifferenceKind::wrong_size:
      return "wrong size";
    case gap::DifferenceKind::surplus:
      return "not in the robot";
    case gap::DifferenceKind::same:
      return "the same";
    case gap::DifferenceKind::not_shown:
      break;
  }
  return "these runs cannot show whether the robot has it";
}

std::string name_of(const gap::EffectDifference& difference, const gap::ParameterDifference& parameter) {
  return difference.effect + "." + parameter.name +
         (parameter.unit == "1" ? "" : " [" + parameter.unit + "]");
}

std::vector<std::vector<std::string>> rows_of(const gap::SimulationGap& gap) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& difference : gap.differences) {
    for (const auto& parameter : difference.parameters) {
      const bool same = parameter.simulation && parameter.robot && !parameter.differs;
      rows.push_back({name_of(difference, parameter), size_text(parameter.simulation),
                      size_text(parameter.robot), same ? "the same" : words_for(difference.kind)});
    }
  }
  return rows;
}

using NamedFigures = std::vector<std::pair<std::string, std::string>>;

void add_figures(const std::string& runs, const Score& score, NamedFigures& figures) {
  const auto add = [&](const std::string& what, double value, const std::string& unit) {
    figures.emplace_back(runs + ": " + what, config::fixed_number(1000.0 * value, 1) + " " + unit + " RMS");
  };
  const auto after = [](const AtHorizon& figure) {
    return " after " + config::fixed_number(figure.horizon_s, 0) + " s";
  };
  if (score.distance_rms_m) add("wheel travel", *score.distance_rms_m, "mm");
  if (score.position_rms_m) add("position" + after(*score.position_rms_m), score.position_rms_m->value, "mm");
  if (score.heading_rms_rad)
    add("heading" + after(*score.heading_rms_rad), score.heading_rms_rad->value, "mrad");
}

// Of the simulator itself; none where its runs were given, by whatever commands.
NamedFigures figures_of(const ComparedSimulation& compared) {
  NamedFigures figures;
  if (compared.train) add_figures("simulator, training runs", *compared.train, figures);
  if (compared.test)
    add_figures("simulator, " + test_runs_text(compared.gap.robot) + " runs", *compared.test, figures);
  return figures;
}

}  // namespace

ordered_json simulation_to_json(const ComparedSimulation& compared) {
  const gap::SimulationGap& gap = compared.gap;
  ordered_json effects = ordered_json::array();
  for (const auto& difference : gap.differences) effects.push_back(difference_to_json(difference));
  ordered_json json = {{"verdict", gap::verdict_name(gap.simulation.verdict)},
                       {"summary", gap.simulation.summary},
                       {"runs", gap.simulation.trained},
                       {"wheel_base_m", gap.simulation.after.linear_part.wheel_base_m},
                       {"check_passed", gap.simulation.check.passed},
                       {"effects", effects},
                       {"remarks", gap.remarks}};
  if (compared.train && compared.test)
    json["gap"] = {{"train", score_to_json(*compared.train)}, {"test", score_to_json(*compared.test)}};
  return json;
}

void print_simulation(std::ostream& out, const ComparedSimulation& compared) {
  for (const auto& [name, value] : figures_of(compared)) out << "  " << name << ": " << value << "\n";
  const auto rows = rows_of(compared.gap);
  if (rows.empty()) return;
  constexpr int width = 34;
  const auto print = [&](const std::string& effect, const std::string& of_simulation,
                         const std::string& of_robot, const std::string& kind) {
    out << std::left << std::setw(width + 6) << effect << std::setw(width) << of_simulation
        << std::setw(width) << of_robot << kind << "\n";
  };
  out << "\n";
  print("effects", "simulation", "robot", "");
  for (const auto& row : rows) print("  " + row[0], row[1], row[2], row[3]);
}

std::string simulation_section(const ComparedSimulation& compared) {
  const gap::SimulationGap& gap = compared.gap;
  std::string text = html::element("h2", "Simulation and robot") +
                     html::element("p", "What the simulation has by its own runs, against a linear model: " +
                                            gap.simulation.summary);
  std::vector<std::vector<std::string>> figures;
  for (const auto& [name, value] : figures_of(compared)) figures.push_back({name, value});
  text += html::table({"the simulator's own runs", "off by"}, figures);
  const auto rows = rows_of(gap);
  if (rows.empty()) return text + html::element("p", "Neither has an effect beyond a linear model.");
  return text + html::table({"effect", "simulation, 95 %", "robot, 95 %", ""}, rows);
}

}  // namespace wheelwright::tools
