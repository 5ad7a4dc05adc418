#include "tools/wheelwright/export/patch/mujoco_drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "config/load/ascii_text.hpp"
#include "config/load/printable_text.hpp"
#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {
namespace {

using pugi::xml_attribute;
using pugi::xml_node;

using config::lower_case;

std::string name_of(xml_node element) {
  return element.attribute("name").value();
}

struct Elements {
  std::vector<xml_node> actuators;
  std::vector<xml_node> joints;
  std::vector<xml_node> options;
  bool includes = false;
};

bool is_inside(xml_node element, std::string_view name) {
  return element.parent().name() == name;
}

Elements elements_of(const XmlFile& file) {
  Elements all;
  XmlFile::for_each(file.root(), [&all](xml_node element) {
    const std::string_view name = element.name();
    if (is_inside(element, "actuator")) all.actuators.push_back(element);
    if (name == "joint" && is_inside(element, "body")) all.joints.push_back(element);
    if (name == "option") all.options.push_back(element);
    if (name == "include") all.includes = true;
  });
  return all;
}

bool can_be_driven(xml_node actuator) {
  const std::string_view kind = actuator.name();
  return actuator.attribute("joint") && (kind == "velocity" || kind == "general");
}

std::string list_of(const std::vector<xml_node>& actuators) {
  std::string text;
  for (const xml_node one : actuators) {
    const xml_attribute joint = one.attribute("joint");
    text += (text.empty() ? "" : ", ") + std::string(one.name()) +
            (joint ? " of joint " + config::excerpt(joint.value()) : " " + config::excerpt(name_of(one)));
  }
  return text.empty() ? "none" : text;
}

// Where a wheel lies, as its joint's or actuator's name says.
bool is_named(xml_node actuator, const std::string& side) {
  return lower_case(name_of(actuator) + " " + actuator.attribute("joint").value()).find(side) !=
         std::string::npos;
}

std::vector<xml_node> named(const std::vector<xml_node>& actuators, const std::string& side) {
  std::vector<xml_node> found;
  std::ranges::copy_if(actuators, std::back_inserter(found),
                       [&side](xml_node one) { return is_named(one, side); });
  return found;
}

xml_node only_actuator(const XmlFile& file, const Elements& all, const std::string& side,
                       const std::string& wanted_joint) {
  const std::string option = "--" + side + "-joint";
  std::vector<xml_node> found;
  if (wanted_joint.empty()) {
    std::vector<xml_node> drivable;
    std::ranges::copy_if(all.actuators, std::back_inserter(drivable), can_be_driven);
    found = named(drivable, side);
  } else {
    std::ranges::copy_if(all.actuators, std::back_inserter(found),
                         [&](xml_node one) { return wanted_joint == one.attribute("joint").value(); });
  }
  if (found.size() == 1) return found.front();
  const std::string hint = all.includes ? "; it includes other files: name the one that has them" : "";
  if (!wanted_joint.empty()) {
    file.fail("has " + std::to_string(found.size()) + " actuators of joint " + config::excerpt(wanted_joint) +
              ", but must have one; it has " + list_of(all.actuators) + hint);
  }
  file.fail("has " + std::to_string(found.size()) +
            " <velocity> or <general> actuators of a joint that is called " + side +
            ", but must have one; its actuators: " + list_of(all.actuators) +
            "; give the joint one, or name it by " + option + hint);
}

xml_node joint_named(const XmlFile& file, const Elements& all, xml_node actuator) {
  const std::string name = actuator.attribute("joint").value();
  const auto found = std::ranges::find_if(all.joints, [&name](xml_node one) { return name == name_of(one); });
  if (found == all.joints.end()) {
    file.fail(actuator, "drives joint " + config::excerpt(name) + ", which this file does not have" +
                            (all.includes ? "; name the file that has both" : "; give it that joint"));
  }
  return *found;
}

bool is_round(xml_node geom) {
  const std::string_view type = geom.attribute("type").value();
  return type == "cylinder" || type == "sphere" || (type.empty() && !geom.attribute("class"));
}

// The geometry that rolls, where there is no doubt about it.
void find_geom(MujocoWheel& wheel) {
  std::vector<xml_node> sized;
  for (const xml_node geom : wheel.body.children("geom")) {
    if (geom.attribute("size")) sized.push_back(geom);
  }
  if (sized.size() != 1) {
    wheel.no_radius = "the wheel's body has " + std::to_string(sized.size()) +
                      " geoms with a size, so that it is open which one rolls";
  } else if (!is_round(sized.front())) {
    wheel.no_radius = "the wheel's geom is neither a cylinder nor a sphere, whose size begins with a radius";
  } else {
    wheel.geom = sized.front();
  }
}

// One number of a list; nothing where it is not there.
std::optional<double> number_in(const XmlFile& file, xml_node element, const std::string& attribute,
                                std::size_t place) {
  if (!element.attribute(attribute.c_str())) return std::nullopt;
  const Token list = file.value_of(element, attribute);
  const auto tokens = tokens_of(file.text(), list.offset, list.length);
  if (place >= tokens.size()) return std::nullopt;
  const std::string number(file.text().substr(tokens[place].offset, tokens[place].length));
  return std::strtod(number.c_str(), nullptr);
}

std::string why_no_separation(const XmlFile& file, const MujocoDrive& drive) {
  const auto left = number_in(file, drive.left.body, "pos", 1);
  const auto right = number_in(file, drive.right.body, "pos", 1);
  constexpr double alike = 0.01;
  if (drive.left.body.parent() != drive.right.body.parent() || !left || !right)
    return "the wheels' bodies do not both have their pos in one body";
  if (*left * *right < 0.0 && std::abs(*left + *right) <= alike * std::abs(*left)) return "";
  return "the wheels' bodies do not lie at y and -y of one body";
}

double timestep_of(const XmlFile& file, const Elements& all) {
  for (const xml_node option : all.options) {
    if (!option.attribute("timestep")) continue;
    const Token value = file.value_of(option, "timestep");
    const double timestep_s = option.attribute("timestep").as_double();
    if (timestep_s > 0.0 && value.length > 0) return timestep_s;
    file.fail(option, "has a timestep that is no positive number; give it one in s");
  }
  return MujocoTarget{}.timestep_s;
}

MujocoWheel wheel_of(const XmlFile& file, const Elements& all, const std::string& side,
                     const std::string& wanted_joint) {
  MujocoWheel wheel;
  wheel.actuator = only_actuator(file, all, side, wanted_joint);
  wheel.joint = joint_named(file, all, wheel.actuator);
  wheel.body = wheel.joint.parent();
  wheel.joint_name = name_of(wheel.joint);
  wheel.actuator_name = wheel.actuator.attribute("name") ? name_of(wheel.actuator) : wheel.joint_name;
  find_geom(wheel);
  return wheel;
}

}  // namespace

MujocoDrive find_mujoco_drive(const XmlFile& file, const PatchNames& names) {
  const std::string_view root = file.root().name();
  if (root != "mujoco" && root != "mujocoinclude") {
    file.fail(file.root(),
              "is not <mujoco>, with which an MJCF file begins; name such a file, or another --to");
  }
  const Elements all = elements_of(file);
  MujocoDrive drive;
  drive.left = wheel_of(file, all, "left", names.left_joint);
  drive.right = wheel_of(file, all, "right", names.right_joint);
  if (drive.left.joint == drive.right.joint)
    file.fail(drive.left.joint, "is taken for both wheels; name them by --left-joint and --right-joint");
  drive.no_separation = why_no_separation(file, drive);
  drive.timestep_s = timestep_of(file, all);
  return drive;
}

MujocoSide side_of(const XmlFile& file, const MujocoWheel& wheel) {
  const xml_node actuator = wheel.actuator;
  if (!can_be_driven(actuator)) {
    file.fail(actuator, "takes no wheel speed; make it a <velocity> or <general> actuator of that joint");
  }
  const std::string_view dynamics = actuator.attribute("dyntype").value();
  if (!dynamics.empty() && dynamics != "none")
    file.fail(actuator, "has dynamics of its own beside the model's lag; set its dyntype to none");
  MujocoSide found;
  found.is_velocity = std::string_view(actuator.name()) == "velocity";
  found.has_delay = static_cast<bool>(actuator.attribute("delay"));
  found.takes_radius = wheel.no_radius.empty();
  if (actuator.attribute("gear")) found.gear = number_in(file, actuator, "gear", 0).value_or(0.0);
  if (!(std::abs(found.gear) > 0.0))
    file.fail(actuator, "has a gear that is no number, or 0; give it another");
  const auto gain = number_in(file, actuator, "gainprm", 0);
  const auto bias = number_in(file, actuator, "biasprm", 2);
  const bool has_gains = !found.is_velocity && gain && bias && *gain * *bias != 0.0;
  found.control_per_rad_s = has_gains ? -*bias * found.gear / *gain : found.gear;
  return found;
}

}  // namespace wheelwright::tools
