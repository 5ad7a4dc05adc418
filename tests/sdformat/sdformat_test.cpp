// What `wheelwright export --to sdf` writes, as the parser of Gazebo reads it.
#include <algorithm>
#include <sdf/sdf.hh>

#include "tests/support/catch.hpp"
#include "tests/support/exported_model.hpp"
#include "tests/support/patch_case.hpp"
#include "tools/wheelwright/export/sdf.hpp"

using namespace wheelwright;
using tools::Part;
using tools::PlacedNumber;

namespace {

const tools::WheelGeometry wheel{0.036, 0.002};
const std::vector<std::string> wheel_options{"--wheel-radius", "0.036", "--wheel-inertia", "0.002"};

std::string link(const std::string& name, double mass_kg) {
  return "<link name=\"" + name + "\"><inertial><mass>" + std::to_string(mass_kg) +
         "</mass></inertial></link>\n";
}

std::string joint(const std::string& side, const std::string& dynamics) {
  return "<joint name=\"" + side + "_wheel_joint\" type=\"revolute\"><parent>body</parent><child>" + side +
         "_wheel</child><axis><xyz>0 1 0</xyz>" + dynamics + "</axis></joint>\n";
}

std::string robot(const std::string& plugin, const std::string& left_dynamics,
                  const std::string& right_dynamics) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n<model name=\"robot\">\n" + link("body", 3.0) +
         link("left_wheel", 0.1) + link("right_wheel", 0.1) + joint("left", left_dynamics) +
         joint("right", right_dynamics) + plugin + "</model>\n</sdf>\n";
}

const std::string bare_plugin =
    "<plugin filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\">\n"
    "<left_joint>left_wheel_joint</left_joint>\n<right_joint>right_wheel_joint</right_joint>\n"
    "<wheel_separation>0.24</wheel_separation>\n<wheel_radius>0.03</wheel_radius>\n</plugin>\n";

const std::string urdf =
    "<robot name=\"robot\">\n"
    "<link name=\"body\"><inertial><mass value=\"3\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" "
    "iyz=\"0\" izz=\"0.1\"/></inertial></link>\n"
    "<link name=\"left_wheel\"><inertial><mass value=\"0.1\"/><inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" "
    "iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/></inertial></link>\n"
    "<link name=\"right_wheel\"><inertial><mass value=\"0.1\"/><inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" "
    "iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/></inertial></link>\n"
    "<joint name=\"left_wheel_joint\" type=\"continuous\"><parent link=\"body\"/><child link=\"left_wheel\"/>"
    "<axis xyz=\"0 1 0\"/></joint>\n"
    "<joint name=\"right_wheel_joint\" type=\"continuous\"><parent link=\"body\"/><child "
    "link=\"right_wheel\"/><axis xyz=\"0 1 0\"/><dynamics damping=\"0.1\"/></joint>\n"
    "<gazebo>\n" +
    bare_plugin + "</gazebo>\n</robot>\n";

// What stands between two marks, the first one after `from`.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    const std::string& from = "") {
  const std::size_t start = text.find(begin, text.find(from));
  const std::size_t stop = text.find(end, start);
  REQUIRE(start != std::string::npos);
  REQUIRE(stop != std::string::npos);
  return text.substr(start, stop + end.size() - start);
}

double value_of(const std::vector<PlacedNumber>& numbers, Part part, const std::string& key) {
  const auto of_part = tools::numbers_of(numbers, part);
  const auto found = std::ranges::find(of_part, key, &PlacedNumber::key);
  REQUIRE(found != of_part.end());
  return std::stod(tools::value_text(*found));
}

void has_dynamics(const sdf::Model& model, const std::string& side, Part part,
                  const std::vector<PlacedNumber>& numbers) {
  INFO(side);
  const sdf::Joint* joint = model.JointByName(side + "_wheel_joint");
  REQUIRE(joint != nullptr);
  REQUIRE(joint->Axis(0) != nullptr);
  CHECK(joint->Axis(0)->Damping() == value_of(numbers, part, "damping"));
  CHECK(joint->Axis(0)->Friction() == value_of(numbers, part, "friction"));
}

void has_plugin(const sdf::Model& model, const std::vector<PlacedNumber>& numbers) {
  const sdf::ElementPtr plugin = model.Element()->FindElement("plugin");
  REQUIRE(plugin != nullptr);
  for (const PlacedNumber& number : tools::numbers_of(numbers, Part::drive_plugin)) {
    INFO(number.key);
    REQUIRE(plugin->HasElement(number.key));
    CHECK(plugin->Get<double>(number.key) == std::stod(tools::value_text(number)));
  }
}

void reads_as_exported(const std::string& text) {
  const auto numbers = tools::sdf_numbers(test::model_with_effects(), wheel).numbers;
  INFO(text);
  sdf::Root root;
  for (const sdf::Error& error : root.LoadSdfString(text)) {
    FAIL_CHECK(error.Message());
  }
  REQUIRE(root.Model() != nullptr);
  has_plugin(*root.Model(), numbers);
  has_dynamics(*root.Model(), "left", Part::left_joint, numbers);
  has_dynamics(*root.Model(), "right", Part::right_joint, numbers);
}

std::string patched(const std::string& name, const std::string& text) {
  const test::PatchCase file(name, test::model_with_effects(), text);
  const auto outcome = file.run("sdf", wheel_options);
  INFO(outcome.err);
  REQUIRE(outcome.status == tools::ExitStatus::done);
  return file.text();
}

}  // namespace

TEST_CASE("Gazebo's parser finds the numbers of an exported model where they belong") {
  const std::string text = tools::to_sdf(test::model_with_effects(), wheel).text;
  const auto dynamics = [&](const std::string& side) {
    return between(text, "<dynamics>", "</dynamics>", "of " + side + "_wheel_joint");
  };
  reads_as_exported(robot(between(text, "<plugin", "</plugin>"), dynamics("left"), dynamics("right")));
}

TEST_CASE("Gazebo's parser finds the numbers in an SDF file that was patched") {
  reads_as_exported(
      patched("sdformat", robot(bare_plugin, "", "<dynamics><damping>0.1</damping></dynamics>")));
}

TEST_CASE("Gazebo's parser finds the numbers in a URDF file that was patched") {
  reads_as_exported(patched("sdformat_urdf", urdf));
}
