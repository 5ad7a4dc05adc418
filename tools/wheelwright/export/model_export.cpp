#include "tools/wheelwright/export/model_export.hpp"

#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "config/load/model_file.hpp"
#include "config/load/output_file.hpp"
#include "tools/option_checks.hpp"
#include "tools/wheelwright/common/json_text.hpp"
#include "tools/wheelwright/common/output.hpp"
#include "tools/wheelwright/export/c/c_header.hpp"
#include "tools/wheelwright/export/mujoco.hpp"
#include "tools/wheelwright/export/patch/mujoco_patch.hpp"
#include "tools/wheelwright/export/patch/ros2_control_patch.hpp"
#include "tools/wheelwright/export/patch/sdf_patch.hpp"
#include "tools/wheelwright/export/patch/write_patch.hpp"
#include "tools/wheelwright/export/ranges.hpp"
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
  throw UsageError("-o, --patch, --ranges, --wheel-radius and --wheel-inertia are for a model; add --to");
}

void refuse_if(bool is_given, const std::string& message) {
  if (is_given) throw UsageError(message);
}

// Options that mean nothing without another.
void check_together(const ModelExport& options, const std::string& target) {
  const bool of_joints = !options.names.left_joint.empty() || !options.names.right_joint.empty();
  refuse_if(options.ranges && !options.patch.empty(),
            "--ranges writes a table, and --patch changes a file; give one of them");
  refuse_if(options.target == ModelTarget::c && !options.patch.empty(),
            target + " takes no --patch: its header is a file of its own; give it another by -o");
  refuse_if(options.patch.empty() && (of_joints || !options.names.within.empty()),
            "--left-joint, --right-joint and --within name things of a file; add --patch");
  refuse_if(options.target == ModelTarget::ros2_control && of_joints,
            target + " takes no joints; name the node by --within");
  refuse_if(options.target == ModelTarget::mujoco && !options.names.within.empty(),
            target + " takes no --within; name the wheels' joints by --left-joint and --right-joint");
  refuse_if(options.target != ModelTarget::mujoco && (options.control_per_rad_s || options.without_delay),
            target + " takes neither --control-per-speed nor --without-delay: they are MuJoCo's");
}

// What the options must hold, before anything is read.
void check_options(const ModelExport& options, const char* format) {
  const std::string target = std::string("--to ") + format;
  check_together(options, target);
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

WheelGeometry wheel_of(const ModelExport& options) {
  return {options.wheel_radius_m.value_or(0.0), options.wheel_inertia_kg_m2};
}

MujocoTarget mujoco_target(const ModelExport& options) {
  MujocoTarget target;
  target.control_per_rad_s = options.control_per_rad_s.value_or(target.control_per_rad_s);
  target.knows_delay = !options.without_delay;
  return target;
}

ModelText text_of(const RobotModel& model, const ModelExport& options) {
  switch (options.target) {
    case ModelTarget::c:
      return to_c(model);
    case ModelTarget::ros2_control:
      return to_ros2_control(model, wheel_of(options).radius_m);
    case ModelTarget::sdf:
      return to_sdf(model, wheel_of(options));
    case ModelTarget::mujoco:
      return to_mujoco(model, wheel_of(options), mujoco_target(options));
    case ModelTarget::none:
      break;
  }
  return {};
}

ModelNumbers numbers_of(const RobotModel& model, const ModelExport& options) {
  if (options.target == ModelTarget::ros2_control)
    return ros2_control_numbers(model, wheel_of(options).radius_m);
  if (options.target == ModelTarget::sdf) return sdf_numbers(model, wheel_of(options));
  return mujoco_numbers(model, wheel_of(options), mujoco_target(options));
}

ModelText ranges_of_model(const RobotModel& model, const ModelExport& options, const char* format) {
  if (options.target == ModelTarget::c) {
    std::vector<Unsaid> unsaid = to_c(model).unsaid;
    return {ranges_to_yaml(model, format, c_ranges(model), unsaid), unsaid};
  }
  const ModelNumbers all = numbers_of(model, options);
  return {ranges_to_yaml(model, format, ranges_of(all.numbers), all.unsaid), all.unsaid};
}

Patch patched(const PatchedFile& file, const RobotModel& model, const ModelExport& options) {
  if (options.target == ModelTarget::ros2_control)
    return patch_ros2_control(file, model, wheel_of(options).radius_m, options.names);
  if (options.target == ModelTarget::sdf) return patch_sdf(file, model, wheel_of(options), options.names);
  const MujocoTarget target = mujoco_target(options);
  return patch_mujoco(file, model, wheel_of(options), {target.control_per_rad_s, target.knows_delay},
                      options.names);
}

// With the model's file where the model does not do for the target.
template <typename Make>
auto made_of(const std::string& model_file, const Make& make) {
  const RobotModel model = config::load_model(model_file);
  try {
    return make(model);
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

ExitStatus patch_with_model(const std::string& model_file, const ModelExport& options, bool json,
                            Streams streams) {
  check_options(options, output_of(options.target).format);
  const PatchPaths paths{model_file, options.patch, options.output};
  check_patch_output(paths);
  return made_of(model_file, [&](const RobotModel& model) {
    const auto patch = [&](const PatchedFile& file) { return patched(file, model, options); };
    return write_patch(paths, patch, json, streams);
  });
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
  command.add_option(
      "--patch", options.patch,
      "With --to ros2_control, sdf or mujoco: file that takes the numbers in place, all else of "
      "it kept; what it was stays as FILE.bak");
  command.add_option("--left-joint", options.names.left_joint,
                     "With --patch: joint of the left wheel; else as the file's names say");
  command.add_option("--right-joint", options.names.right_joint, "With --patch: joint of the right wheel");
  command.add_option(
      "--within", options.names.within,
      "With --patch and --to sdf or ros2_control: the model, or the node of ROS, where there are several");
  command
      .add_option("--control-per-speed", options.control_per_rad_s,
                  "With --to mujoco: control per speed of a wheel, 1/(rad/s); default 1")
      ->check(number_between(1e-6, 1e6, "1/(rad/s)"));
  command.add_flag("--without-delay", options.without_delay,
                   "With --to mujoco: for MuJoCo before 3.5, whose actuators have no delay; it becomes lag");
  command.add_flag("--ranges", options.ranges,
                   "With --to: the 95 % intervals as a table (YAML), to draw a simulation's parameters from");
}

ExitStatus export_model(const std::string& model_file, const ModelExport& options, bool json,
                        Streams streams) {
  const TargetOutput target = output_of(options.target);
  if (!options.patch.empty()) return patch_with_model(model_file, options, json, streams);
  if (json && options.output.empty()) throw UsageError("--json needs -o OUT with --to: the model goes there");
  check_options(options, target.format);
  const config::OutputFile output{options.output, options.ranges ? config::OutputKind::ranges : target.kind};
  if (!options.output.empty()) check_output(output, {model_file});
  const ModelText text = made_of(model_file, [&](const RobotModel& model) {
    return options.ranges ? ranges_of_model(model, options, target.format) : text_of(model, options);
  });
  if (options.output.empty()) {
    streams.out << text.text;
    return ExitStatus::done;
  }
  write(output, text.text);
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
