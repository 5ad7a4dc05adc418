// The part of `wheelwright export` that takes a model: --to.
#pragma once

#include <optional>
#include <string>

#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/export/patch/patch.hpp"

namespace wheelwright::tools {

enum class ModelTarget { none, c, ros2_control, sdf, mujoco };

struct ModelExport {
  ModelTarget target = ModelTarget::none;
  std::string output;  // standard output where it is empty
  std::optional<double> wheel_radius_m;
  std::optional<double> wheel_inertia_kg_m2;
  std::string patch;  // a file of somebody else's that takes the numbers
  PatchNames names;
  std::optional<double> control_per_rad_s;
  bool without_delay = false;
  bool ranges = false;

  bool is_asked_for() const {
    return target != ModelTarget::none || !output.empty() || wheel_radius_m || wheel_inertia_kg_m2 ||
           !patch.empty() || ranges;
  }
};

void add_model_options(CLI::App& command, ModelExport& options);

// Throws UsageError where the target needs what neither the model nor the options hold.
ExitStatus export_model(const std::string& model_file, const ModelExport& options, bool json,
                        Streams streams);

}  // namespace wheelwright::tools
