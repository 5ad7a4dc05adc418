// Numbers of a model put into an SDF or URDF file that is there already.
#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/exported_model.hpp"
#include "tests/support/patch_case.hpp"

using namespace wheelwright;
using test::PatchCase;
using tools::ExitStatus;

namespace {

const std::string plugin =
    "    <plugin filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\">\n"
    "      <left_joint>left_hinge</left_joint>\n"
    "      <right_joint>right_hinge</right_joint>\n"
    "      <wheel_separation> 0.24 </wheel_separation>  <!-- by tape -->\n"
    "      <wheel_radius>0.0360144058</wheel_radius>\n"
    "      <topic>cmd_vel</topic>\n"
    "    </plugin>\n";

const std::string sdf =
    "<?xml version=\"1.0\" ?>\n"
    "<sdf version=\"1.9\">\n"
    "  <model name=\"robot\">\n"
    "    <joint name=\"left_hinge\" type=\"revolute\">\n"
    "      <axis>\n"
    "        <xyz>0 1 0</xyz>\n"
    "      </axis>\n"
    "    </joint>\n"
    "    <joint name=\"right_hinge\" type=\"revolute\">\n"
    "      <axis>\n"
    "        <xyz>0 1 0</xyz>\n"
    "        <dynamics><damping>0.1</damping></dynamics>\n"
    "      </axis>\n"
    "    </joint>\n" +
    plugin +
    "  </model>\n"
    "</sdf>\n";

const std::string urdf =
    "<robot name=\"robot\">\n"
    "  <joint name=\"left_hinge\" type=\"continuous\">\n"
    "    <axis xyz=\"0 1 0\"/>\n"
    "    <dynamics damping=\"0.1\"/>\n"
    "  </joint>\n"
    "  <joint name=\"right_hinge\" type=\"continuous\"><axis xyz=\"0 1 0\"/></joint>\n"
    "  <gazebo>\n" +
    plugin +
    "  </gazebo>\n"
    "</robot>\n";

const std::vector<std::string> radius{"--wheel-radius", "0.036"};
const std::vector<std::string> inertia{"--wheel-radius", "0.036", "--wheel-inertia", "0.002"};

std::string without(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.substr(0, at) + text.substr(at + part.size());
}

void refused(const std::string& text, const std::vector<std::string>& options, const std::string& what) {
  const PatchCase robot_case("sdf_patch_refused", test::model_with_effects(), text);
  const auto outcome = robot_case.run("sdf", options);
  INFO(what << "\n" << outcome.err);
  CHECK(outcome.status == ExitStatus::bad_input);
  CHECK(test::is_one_line(outcome.err));
  CHECK_THAT(outcome.err, ContainsSubstring(what));
  CHECK(robot_case.text() == text);
}

}  // namespace

TEST_CASE("The DiffDrive plugin of an SDF file gets its numbers, and the limits that it lacks") {
  const PatchCase patched("sdf_patch", test::model_with_effects(), sdf);
  const auto outcome = patched.run("sdf", radius);
  INFO(outcome.err << outcome.out << patched.text());
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(patched.text(),
             ContainsSubstring("wheels 0.25 m apart the robot turns as one whose wheels are 0.26 m apart: "));
  CHECK_THAT(patched.text(), ContainsSubstring("; effective_track of 2026-02-03T00:00:00Z -->\n"
                                               "      <wheel_separation> 0.240384615 </wheel_separation>  "
                                               "<!-- by tape -->\n"));
  CHECK_THAT(patched.text(), ContainsSubstring("      <max_linear_velocity>0.4</max_linear_velocity>\n"));
  CHECK_THAT(patched.text(), ContainsSubstring("\n      <topic>cmd_vel</topic>\n    </plugin>\n"));
  CHECK_THAT(outcome.out, ContainsSubstring("DiffDrive wheel_radius: already 0.0360144058"));
  CHECK_THAT(outcome.out,
             ContainsSubstring("robot:18: DiffDrive wheel_separation: changed from 0.24 to 0.240384615"));
  CHECK_THAT(outcome.out, ContainsSubstring("coulomb_friction cannot be said in this format"));
  const std::string once = patched.text();
  CHECK_THAT(patched.run("sdf", radius).out, ContainsSubstring("nothing to change"));
  CHECK(patched.text() == once);
}

TEST_CASE("Joints of an SDF or URDF file get damping and friction, where there are dynamics and where not") {
  for (const std::string& text : {sdf, urdf}) {
    const PatchCase patched("sdf_patch_joints", test::model_with_effects(), text);
    const auto outcome = patched.run("sdf", inertia);
    INFO(outcome.err << outcome.out << patched.text());
    REQUIRE(outcome.status == ExitStatus::done);
    CHECK_THAT(outcome.out, ContainsSubstring("hinge damping: changed from 0.1 to 0.0222222222"));
    CHECK_THAT(outcome.out, ContainsSubstring("joint left_hinge friction: added 0.00740740741"));
    CHECK_THAT(outcome.out, ContainsSubstring("joint right_hinge friction: added 0.00740740741"));
    const std::string once = patched.text();
    CHECK_THAT(patched.run("sdf", inertia).out, ContainsSubstring("nothing to change"));
    CHECK(patched.text() == once);
  }
}

TEST_CASE("A URDF file without the plugin takes the dynamics of its joints, and the rest is told") {
  const PatchCase patched("urdf_patch", test::model_with_effects(), without(urdf, plugin));
  auto options = inertia;
  options.insert(options.end(), {"--left-joint", "left_hinge", "--right-joint", "right_hinge"});
  const auto outcome = patched.run("sdf", options);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(outcome.out,
             ContainsSubstring("DiffDrive wheel_separation: 0.240384615 cannot be said here: this file"));
  CHECK_THAT(outcome.out, ContainsSubstring("joint left_hinge friction: added"));
  refused(without(urdf, plugin), inertia, "name the left one by --left-joint");
  refused(without(urdf, plugin), radius, "has no DiffDrive plugin");
}

TEST_CASE("An SDF file without the place for the numbers is left as it is, and told what it lacks") {
  refused(without(sdf, plugin), radius, "has no DiffDrive plugin; give the robot's <model> a <plugin");
  refused(without(sdf, "name=\"left_hinge\""), inertia, "has no joint left_hinge in <model name=\"robot\">");
  refused(without(sdf, "      <left_joint>left_hinge</left_joint>\n"), inertia, "has no <left_joint>");
  refused(sdf.substr(0, sdf.find(plugin)) + plugin + sdf.substr(sdf.find(plugin)), radius,
          "has 2 DiffDrive plugins (of model robot at row 15, robot at row 22); name the model by --within");
  refused(without(sdf, " 0.24 "), radius, "<wheel_separation> holds no number");
  refused("<mujoco/>", radius, "<mujoco> is neither <sdf> nor <robot>");
}

TEST_CASE("With several robots whose joints are called alike the model that is named is meant") {
  std::string both = sdf;
  std::string second = sdf.substr(sdf.find("  <model"), sdf.find("</sdf>") - sdf.find("  <model"));
  second.replace(second.find("name=\"robot\""), 12, "name=\"other\"");
  both.insert(both.find("</sdf>"), second);
  const PatchCase patched("sdf_patch_models", test::model_with_effects(), both);
  auto options = inertia;
  options.insert(options.end(), {"--within", "robot"});
  const auto outcome = patched.run("sdf", options);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(patched.text(), ContainsSubstring(second));
  refused(both, radius, "(of model robot at row 15, other at row");
  refused(both, {"--wheel-radius", "0.036", "--within", "third"}, "has no DiffDrive plugin of what is named");
}

TEST_CASE("With several DiffDrive plugins the one of the joints that are named is meant") {
  std::string other = plugin;
  for (std::size_t at = other.find("hinge"); at != std::string::npos; at = other.find("hinge", at + 1))
    other.replace(at, 5, "wheel");
  std::string both = sdf;
  both.insert(both.find(plugin), other);
  const PatchCase patched("sdf_patch_several", test::model_with_effects(), both);
  auto options = radius;
  options.insert(options.end(), {"--left-joint", "left_hinge"});
  const auto outcome = patched.run("sdf", options);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(patched.text(), ContainsSubstring(other));
}
