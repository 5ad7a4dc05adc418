#include "tools/wheelwright/export/model_export.hpp"

#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/export/c/c_header.hpp"
#include "tools/wheelwright/export/mujoco.hpp"
#include "tools/wheelwright/export/ros2_control.hpp"
#include "tools/wheelwright/export/sdf.hpp"
#include "tools/wheelwright/logs/log_checks.hpp"

namespace wheelwright::tools {
namespace {

struct TargetOutput {
  const char* format;
  config::OutputKind kind;
};

TargetOutput output_of(ModelTarget target) {
  switch (target) {
    case ModelTarget::c:
      return {"c", config::OutputKind::c_header};
    case ModelTarget::ros2_control:
      return {"ros2_control", config::OutputKind::ros2_control};
    case ModelTarget::sdf:
      return {"sdf", config::OutputKind::sdf};
    case ModelTarget::mujoco:
      return {"mujoco", config::OutputKind::mujoco};
    case ModelTarget::none:
      break;
  }
  throw UsageError("-o, --wheel-radius and --wheel-inertia are for a model; add --to");
}

// What the options must hold, before anything is read.
void check_options(const ModelExport& options, const char* format) {
  const std::string target = std::string("--to ") + format;
  if (options.target == ModelTarget::c) {
    if (!options.wheel_radius_m && !options.wheel_inertia_kg_m2) return;
    throw UsageError(target +
                     " takes neither --wheel-radius nor --wheel-inertia: the model is in m/s throughout");
  }
  if (!options.wheel_radius_m) {
    throw UsageError(target + " needs the radius of a wheel, which no model holds; add --wheel-radius, in m");
  }
  if (options.target == ModelTarget::mujoco && !options.wheel_inertia_kg_m2) {
    throw UsageError(
        target +
        " needs what one motor speeds up, for torques: the wheel's inertia and radius^2 times half of the "
        "robot's mass; add --wheel-inertia, in kg m^2");
  }
  if (options.target == ModelTarget::ros2_control && options.wheel_inertia_kg_m2) {
    throw UsageError(target + " takes no --wheel-inertia: it knows no torques");
  }
}

ModelText text_of(const RobotModel& model, const ModelExport& options) {
  const WheelGeometry wheel{options.wheel_radius_m.value_or(0.0), options.wheel_inertia_kg_m2};
  switch (options.target) {
    case ModelTarget::c:
      return to_c(model);
    case ModelTarget::ros2_control:
      return to_ros2_control(model, wheel.radius_m);
    case ModelTarget::sdf:
      return to_sdf(model, wheel);
    case ModelTarget::mujoco:
      return to_mujoco(model, wheel);
    case ModelTarget::none:
      break;
  }
  return {};
}

ModelText text_of_file(const std::string& model_file, const ModelExport& options) {
  const RobotModel model = config::load_model(model_file);
  try {
    return text_of(model, options);
  } catch (const std::invalid_argument& impossible) {
    throw UsageError(model_file + ": " + impossible.what());
  }
}

nlohmann::ordered_json to_json(const ModelText& text, const char* format, const std::string& file) {
  auto unsaid = nlohmann::ordered_json::array();
  for (const auto& [effect, reason] : text.unsaid) unsaid.push_back({{"effect", effect}, {"reason", reason}});
  const nlohmann::ordered_json written{{"format", format}, {"file", file}, {"bytes", text.text.size()}};
  return {{"wrote", nlohmann::ordered_json::array({written})}, {"unsaid", unsaid}};
}

}  // namespace

void add_model_options(CLI::App& command, ModelExport& options) {
  command
      .add_option("--to", options.target, "Write the model's numbers and effects as this program takes them")
      ->transform(one_of<ModelTarget>({{"c", ModelTarget::c},
                                       {"ros2_control", ModelTarget::ros2_control},
                                       {"sdf", ModelTarget::sdf},
                                       {"mujoco", ModelTarget::mujoco}}));
  command.add_option("-o,--output", options.output, "With --to: file to write, instead of standard output");
  command
      .add_option("--wheel-radius", options.wheel_radius_m,
                  "With --to ros2_control, sdf or mujoco: radius of a wheel, m")
      ->check(number_between(0.001, 10.0, "m"));
  command
      .add_option("--wheel-inertia", options.wheel_inertia_kg_m2,
                  "With --to sdf or mujoco: what one wheel's motor speeds up, at the wheel, kg m^2")
      ->check(number_between(1e-9, 1e4, "kg m^2"));
}

ExitStatus export_model(const std::string& model_file, const ModelExport& options, bool json,
                        Streams streams) {
  const TargetOutput target = output_of(options.target);
  if (json && options.output.empty()) throw UsageError("--json needs -o OUT with --to: the model goes there");
  check_options(options, target.format);
  const config::OutputFile output{options.output, target.kind};
  if (!options.output.empty()) check_output(output, {model_file});
  const ModelText text = text_of_file(model_file, options);
  if (options.output.empty()) {
    streams.out << text.text;
    return ExitStatus::done;
  }
  if (const auto error = config::write_output(output, text.text)) throw UsageError(*error);
  if (json) {
    streams.out << json_text(to_json(text, target.format, options.output)) << "\n";
    return ExitStatus::done;
  }
  for (const auto& [effect, reason] : text.unsaid) {
    streams.out << effect << " cannot be said in this format: " << reason << "\n";
  }
  streams.out << "wrote " << options.output << "\n";
  return ExitStatus::done;
}

}  // namespace wheelwright::tools
