#include "tools/wheelwright/export/patch/sdf_patch.hpp"

#include <algorithm>
#include <string_view>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/export/patch/xml_numbers.hpp"

namespace wheelwright::tools {
namespace {

using pugi::xml_node;

constexpr std::string_view plugin_example =
    "<plugin filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\">";

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool is_diff_drive(xml_node element) {
  if (std::string_view(element.name()) != "plugin") return false;
  const std::string_view file = element.attribute("filename").value();
  const std::string_view name = element.attribute("name").value();
  return contains(file, "diff-drive") || contains(file, "diff_drive") || contains(name, "DiffDrive");
}

std::string text_in(const XmlFile& file, xml_node element) {
  const Token text = file.text_of(element);
  return std::string(file.text().substr(text.offset, text.length));
}

bool drives(const XmlFile& file, xml_node plugin, const std::string& element, const std::string& joint) {
  if (joint.empty()) return true;
  return std::ranges::any_of(plugin.children(element.c_str()),
                             [&](xml_node one) { return text_in(file, one) == joint; });
}

std::string model_of(xml_node plugin) {
  return plugin.parent().attribute("name").value();
}

std::vector<xml_node> plugins_of(const XmlFile& file, const PatchNames& names) {
  std::vector<xml_node> plugins;
  XmlFile::for_each(file.root(), [&](xml_node element) {
    if (is_diff_drive(element) && (names.within.empty() || names.within == model_of(element)) &&
        drives(file, element, "left_joint", names.left_joint) &&
        drives(file, element, "right_joint", names.right_joint))
      plugins.push_back(element);
  });
  return plugins;
}

std::string models_of(const XmlFile& file, const std::vector<xml_node>& plugins) {
  std::string text;
  for (const xml_node one : plugins) {
    text += (text.empty() ? "" : ", ") + config::excerpt(model_of(one)) + " at row " +
            std::to_string(file.row(one));
  }
  return text;
}

// Nothing where a URDF file has none.
xml_node find_plugin(const XmlFile& file, const PatchNames& names, bool is_urdf) {
  const std::vector<xml_node> plugins = plugins_of(file, names);
  if (plugins.size() > 1) {
    file.fail("has " + std::to_string(plugins.size()) + " DiffDrive plugins (of model " +
              models_of(file, plugins) +
              "); name the model by --within, or its joints by --left-joint and --right-joint");
  }
  if (plugins.empty() && is_urdf) return {};
  if (plugins.empty()) {
    file.fail("has no DiffDrive plugin" +
              (names.left_joint.empty() && names.right_joint.empty() && names.within.empty()
                   ? std::string()
                   : " of what is named") +
              "; give the robot's <model> a " + std::string(plugin_example));
  }
  if (plugins.front().child("wheel_diameter") || plugins.front().child("wheelSeparation")) {
    file.fail(plugins.front(),
              "is Gazebo classic's, with other elements; make it a " + std::string(plugin_example));
  }
  return plugins.front();
}

std::string joint_name(const XmlFile& file, xml_node plugin, const std::string& side,
                       const std::string& wanted) {
  const std::string element = side + "_joint";
  if (!wanted.empty()) return wanted;
  if (!plugin) {
    file.fail("has no DiffDrive plugin that names the wheels' joints; name the " + side + " one by --" +
              side + "-joint");
  }
  const xml_node first = plugin.child(element.c_str());
  if (!first)
    file.fail(plugin, "has no <" + element + ">; give it one, or name the joint by --" + side + "-joint");
  if (first.next_sibling(element.c_str())) {
    file.fail(plugin, "drives several " + side +
                          " joints, between which the torque of one is not divided; leave out "
                          "--wheel-inertia, or name one by --" +
                          side + "-joint");
  }
  return text_in(file, first);
}

xml_node find_joint(const XmlFile& file, xml_node scope, const std::string& name) {
  for (const xml_node joint : scope.children("joint")) {
    if (name == joint.attribute("name").value()) return joint;
  }
  file.fail("has no joint " + config::excerpt(name) + " in " + tag_text(scope) +
            "; name the wheels' joints by --left-joint and --right-joint");
}

void put_dynamics(XmlNumbers& patched, const XmlFile& file, xml_node joint, bool is_urdf,
                  const std::vector<PlacedNumber>& numbers) {
  const std::string thing = "joint " + config::printable(joint.attribute("name").value());
  const xml_node owner = is_urdf ? joint : joint.child("axis");
  if (!owner) file.fail(joint, "has no <axis>; give it one");
  const xml_node dynamics = owner.child("dynamics");
  if (is_urdf) {
    if (dynamics) return patched.set_attributes(dynamics, thing, numbers);
    return patched.add_empty_element(owner, "dynamics", thing, numbers);
  }
  if (dynamics) return patched.set_children(dynamics, thing, numbers);
  patched.add_element(owner, "dynamics", "xyz", thing, numbers);
}

}  // namespace

Patch patch_sdf(const PatchedFile& file, const RobotModel& model, const WheelGeometry& wheel,
                const PatchNames& names) {
  const XmlFile xml(file);
  const std::string_view root = xml.root().name();
  if (root != "sdf" && root != "robot") {
    xml.fail(xml.root(),
             "is neither <sdf> nor <robot>, with which SDF and URDF begin; name such a file, or "
             "another --to");
  }
  const bool is_urdf = root == "robot";
  const xml_node plugin = find_plugin(xml, names, is_urdf);
  const ModelNumbers all = sdf_numbers(model, wheel);
  const auto of_left = numbers_of(all.numbers, Part::left_joint);
  const auto of_right = numbers_of(all.numbers, Part::right_joint);
  if (!plugin && of_left.empty()) {
    xml.fail("has no DiffDrive plugin; give the robot a " + std::string(plugin_example) +
             ", or add --wheel-inertia for the dynamics of its joints alone");
  }
  XmlNumbers patched(xml);
  const auto of_plugin = numbers_of(all.numbers, Part::drive_plugin);
  if (plugin) {
    patched.set_children(plugin, "DiffDrive", of_plugin);
  } else {
    patched.leave("DiffDrive", of_plugin,
                  "this file has no such plugin; where ros2_control drives the wheels, "
                  "its YAML file takes them");
  }
  if (!of_left.empty()) {
    const xml_node scope = is_urdf ? xml.root() : plugin.parent();
    const xml_node left = find_joint(xml, scope, joint_name(xml, plugin, "left", names.left_joint));
    const xml_node right = find_joint(xml, scope, joint_name(xml, plugin, "right", names.right_joint));
    if (left == right)
      xml.fail(left, "is taken for both wheels; name them by --left-joint and --right-joint");
    put_dynamics(patched, xml, left, is_urdf, of_left);
    put_dynamics(patched, xml, right, is_urdf, of_right);
  }
  return {patched.text(), patched.changes(), all.unsaid};
}

}  // namespace wheelwright::tools
