#include "tools/wheelwright/export/patch/mujoco_patch.hpp"

#include <algorithm>
#include <iterator>

#include "tools/wheelwright/export/patch/mujoco_drive.hpp"
#include "tools/wheelwright/export/patch/xml_numbers.hpp"

namespace wheelwright::tools {
namespace {

struct PatchSide {
  const MujocoWheel& wheel;
  const MujocoSide& given;
  Part joint_part;
  Part actuator_part;
  Part wheel_part;
  double gain;
};

// What is far from it means controls of another unit than was given.
void check_control(const XmlFile& file, const PatchSide& side, double right) {
  constexpr double largest_change = 1.5;
  const double now = side.given.control_per_rad_s;
  if (now / right > 1.0 / largest_change && now / right < largest_change) return;
  file.fail(side.wheel.actuator, "turns its wheel with 1 rad/s at a control of " + nine_digits(now) +
                                     ", not of " + nine_digits(right) + "; add --control-per-speed " +
                                     nine_digits(now) +
                                     " where controls are so, or mend its gear or its gains");
}

std::vector<PlacedNumber> with_key(const std::vector<PlacedNumber>& numbers, const std::string& key) {
  std::vector<PlacedNumber> own;
  std::ranges::copy_if(numbers, std::back_inserter(own),
                       [&key](const PlacedNumber& number) { return number.key == key; });
  return own;
}

void put_geometry(XmlNumbers& file, const PatchSide& side, const MujocoDrive& drive,
                  const std::vector<PlacedNumber>& numbers) {
  const auto own = numbers_of(numbers, side.wheel_part);
  const std::string body = "body of joint " + side.wheel.joint_name;
  if (drive.no_separation.empty()) {
    file.set_attributes(side.wheel.body, body, with_key(own, "pos"));
  } else {
    file.leave(body, with_key(own, "pos"), drive.no_separation);
  }
  if (side.wheel.no_radius.empty()) {
    file.set_attributes(side.wheel.geom, "geom of joint " + side.wheel.joint_name, with_key(own, "size"));
  } else {
    file.leave("geom of joint " + side.wheel.joint_name, with_key(own, "size"), side.wheel.no_radius);
  }
}

}  // namespace

Patch patch_mujoco(const PatchedFile& file, const RobotModel& model, const WheelGeometry& wheel,
                   const MujocoChoice& choice, const PatchNames& names) {
  const XmlFile xml(file);
  const MujocoDrive drive = find_mujoco_drive(xml, names);
  const MujocoTarget target{.left = side_of(xml, drive.left),
                            .right = side_of(xml, drive.right),
                            .timestep_s = drive.timestep_s,
                            .control_per_rad_s = choice.control_per_rad_s,
                            .knows_delay = choice.knows_delay};
  const ModelNumbers all = mujoco_numbers(model, wheel, target);
  const WheelPair gain = drive_figures(model).gain;
  XmlNumbers patched(xml);
  for (const PatchSide& side : {PatchSide{drive.left, target.left, Part::left_joint, Part::left_actuator,
                                          Part::left_wheel, gain.left},
                                PatchSide{drive.right, target.right, Part::right_joint, Part::right_actuator,
                                          Part::right_wheel, gain.right}}) {
    check_control(xml, side, choice.control_per_rad_s / side.gain);
    put_geometry(patched, side, drive, all.numbers);
    patched.set_attributes(side.wheel.joint, "joint " + side.wheel.joint_name,
                           numbers_of(all.numbers, side.joint_part));
    patched.set_attributes(side.wheel.actuator, "actuator " + side.wheel.actuator_name,
                           numbers_of(all.numbers, side.actuator_part));
  }
  return {patched.text(), patched.changes(), all.unsaid};
}

}  // namespace wheelwright::tools
