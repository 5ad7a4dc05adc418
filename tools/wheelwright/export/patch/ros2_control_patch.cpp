#include "tools/wheelwright/export/patch/ros2_control_patch.hpp"

#include <algorithm>
#include <iterator>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/export/patch/yaml_numbers.hpp"

namespace wheelwright::tools {
namespace {

struct RosNode {
  std::string name;
  YAML::Node parameters;
};

// The bounds of a YAML file hold its levels down.
void collect(const YAML::Node& mapping, std::vector<RosNode>& nodes) {
  if (!mapping.IsMap()) return;
  for (const auto& entry : mapping) {
    if (!entry.second.IsMap() || !entry.first.IsScalar()) continue;
    const YAML::Node below = entry.second;
    if (const YAML::Node parameters = below["ros__parameters"]; parameters && parameters.IsMap())
      nodes.push_back({entry.first.Scalar(), parameters});
    collect(below, nodes);
  }
}

bool has_any(const YAML::Node& parameters, std::initializer_list<const char*> keys) {
  return std::ranges::any_of(keys, [&](const char* key) { return static_cast<bool>(parameters[key]); });
}

bool is_controller(const RosNode& node) {
  return has_any(node.parameters, {"wheel_separation", "wheel_radius", "left_wheel_names",
                                   "right_wheel_names", "wheel_separation_multiplier"});
}

bool is_smoother(const RosNode& node) {
  return node.name.find("velocity_smoother") != std::string::npos ||
         has_any(node.parameters, {"smoothing_frequency", "deadband_velocity"});
}

std::string names_of(const YamlNumbers& file, const std::vector<RosNode>& nodes) {
  constexpr std::size_t most = 8;
  std::string text;
  for (const RosNode& node : nodes) {
    if (&node == nodes.data() + most) return text + " and " + std::to_string(nodes.size() - most) + " more";
    text += (text.empty() ? "" : ", ") + config::excerpt(node.name) + " at row " +
            std::to_string(file.row(node.parameters));
  }
  return text.empty() ? "none" : text;
}

// Copies, since to assign a YAML::Node changes what it stands for.
std::vector<RosNode> only(const YamlNumbers& file, const std::vector<RosNode>& nodes,
                          bool (*is_wanted)(const RosNode&), const std::string& what,
                          const std::string& name) {
  std::vector<RosNode> found;
  std::ranges::copy_if(nodes, std::back_inserter(found), [&](const RosNode& node) {
    return is_wanted(node) && (name.empty() || node.name == name);
  });
  if (found.size() > 1) {
    file.fail("has several nodes that may be the " + what + " (" + names_of(file, found) + "); " +
              (what == "velocity smoother" ? "leave one of them" : "name one by --within"));
  }
  return found;
}

}  // namespace

Patch patch_ros2_control(const PatchedFile& file, const RobotModel& model, double wheel_radius_m,
                         const PatchNames& names) {
  YamlNumbers patched(file);
  std::vector<RosNode> nodes;
  collect(patched.root(), nodes);
  const auto controller = only(patched, nodes, is_controller, "diff_drive_controller", names.within);
  const auto smoother = only(patched, nodes, is_smoother, "velocity smoother", "");
  if (controller.empty() && (smoother.empty() || !names.within.empty())) {
    patched.fail("has no diff_drive_controller " +
                 (names.within.empty() ? std::string("(ros__parameters with wheel_separation)")
                                       : "of the name " + config::excerpt(names.within)) +
                 "; nodes with ros__parameters: " + names_of(patched, nodes) +
                 "; give it one, as `export` without --patch writes it");
  }
  const ModelNumbers all = ros2_control_numbers(model, wheel_radius_m);
  struct Owner {
    const std::vector<RosNode>& node;
    Part part;
    std::string kind;
  };
  for (const Owner& owner : {Owner{controller, Part::controller, "diff_drive_controller"},
                             Owner{smoother, Part::smoother, "velocity_smoother"}}) {
    const auto numbers = numbers_of(all.numbers, owner.part);
    if (owner.node.empty()) {
      patched.leave(owner.kind, numbers, "this file has no " + owner.kind + "; patch the one that has it");
    } else {
      patched.set(owner.node.front().parameters, config::printable(owner.node.front().name), numbers);
    }
  }
  return {patched.text(), patched.changes(), all.unsaid};
}

}  // namespace wheelwright::tools
