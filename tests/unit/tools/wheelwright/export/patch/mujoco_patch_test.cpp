// Numbers of a model put into an MJCF file that is there already.
#include <algorithm>
#include <sstream>

#include "tests/support/catch.hpp"
#include "tests/support/exported_model.hpp"
#include "tests/support/patch_case.hpp"
#include "tools/wheelwright/common/json_text.hpp"

using namespace wheelwright;
using test::PatchCase;
using tools::ExitStatus;

namespace {

const std::string robot =
    "<?xml version=\"1.0\"?>\n"
    "<!-- my robot; <joint name=\"left\"/> is no joint -->\n"
    "<mujoco model='two  wheels'>\n"
    "\t<option   timestep=\"0.001\"/>\n"
    "  <worldbody>\n"
    "    <body name=\"chassis\">\n"
    "      <body name=\"left\" pos=\"0.01  0.12 0\">\n"
    "        <joint name=\"left_hinge\" axis=\"0 1 0\" damping=\"0.5\"/>\n"
    "        <geom type=\"cylinder\" size=\"0.04 0.01\"/>\n"
    "      </body>\n"
    "      <body name=\"right\" pos=\"0.01 -0.12 0\">\n"
    "        <!-- a squeaky one --><joint name=\"right_hinge\" axis=\"0 1 0\"/>\n"
    "        <geom type=\"cylinder\" size=\"0.04 0.01\"/>\n"
    "      </body>\n"
    "    </body>\n"
    "  </worldbody>\n"
    "  <actuator>\n"
    "    <velocity name=\"left\"  joint='left_hinge' kv='7'/> <!-- guessed -->\n"
    "    <velocity name=\"right\" joint=\"right_hinge\" kv=\"7\"/>\n"
    "  </actuator>\n"
    "</mujoco>\n";

const std::vector<std::string> wheel{"--wheel-radius", "0.036", "--wheel-inertia", "0.002"};

std::vector<std::string> with(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.end(), more.begin(), more.end());
  return options;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

void refused(const std::string& text, const std::vector<std::string>& more, const std::string& what) {
  const PatchCase robot_case("mujoco_patch_refused", test::model_with_effects(), text);
  const auto outcome = robot_case.run("mujoco", with(wheel, more));
  INFO(what << "\n" << outcome.err);
  CHECK(outcome.status == ExitStatus::bad_input);
  CHECK(test::is_one_line(outcome.err));
  CHECK_THAT(outcome.err, ContainsSubstring(what));
  CHECK(robot_case.text() == text);
  CHECK_FALSE(std::filesystem::exists(robot_case.beside("robot.bak")));
}

}  // namespace

TEST_CASE("A patch of an MJCF file changes its numbers and keeps every other byte") {
  const PatchCase patched("mujoco_patch", test::model_with_effects(), robot);
  const auto outcome = patched.run("mujoco", wheel);
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  const std::string text = patched.text();
  INFO(text);
  CHECK_THAT(text, ContainsSubstring("<body name=\"left\" pos=\"0.01  0.13 0\">"));
  CHECK_THAT(text, ContainsSubstring("<body name=\"right\" pos=\"0.01 -0.13 0\">"));
  CHECK_THAT(text,
             ContainsSubstring("<joint name=\"left_hinge\" axis=\"0 1 0\" damping=\"0\" frictionloss=\""));
  CHECK_THAT(text, ContainsSubstring("<geom type=\"cylinder\" size=\"0.03525120 0.01\"/>") ||
                       ContainsSubstring("<geom type=\"cylinder\" size=\"0.0352512 0.01\"/>"));
  CHECK_THAT(text, ContainsSubstring("joint='left_hinge' kv='"));
  CHECK_THAT(text, ContainsSubstring("/> <!-- guessed -->\n"));
  CHECK_THAT(text, ContainsSubstring("ctrlrange=\""));
  CHECK_THAT(text, ContainsSubstring(" delay=\""));
  CHECK_THAT(text, ContainsSubstring("95 % interval 0.1295 to 0.131"));
  CHECK_THAT(text, ContainsSubstring("coulomb_friction of 2026-02-03T00:00:00Z"));
  CHECK_THAT(outcome.out, ContainsSubstring("joint left_hinge damping: changed from 0.5 to 0\n"));
  CHECK_THAT(outcome.out, ContainsSubstring("joint right_hinge damping: added 0\n"));
  CHECK_THAT(outcome.out, ContainsSubstring("dead_zone cannot be said in this format"));
  CHECK(test::file_text(patched.beside("robot.bak")) == robot);
  // What is not ours is there as it was, in order.
  std::istringstream lines(robot);
  std::size_t at = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("pos=") != std::string::npos || line.find("hinge") != std::string::npos ||
        line.find("size=") != std::string::npos)
      continue;
    at = text.find(line + "\n", at);
    INFO(line);
    REQUIRE(at != std::string::npos);
  }
}

TEST_CASE("A second patch with the same model changes nothing and says so") {
  const PatchCase patched("mujoco_patch_twice", test::model_with_effects(), robot);
  REQUIRE(patched.run("mujoco", wheel).status == ExitStatus::done);
  const std::string once = patched.text();
  const auto outcome = patched.run("mujoco", wheel);
  CHECK(patched.text() == once);
  CHECK_THAT(outcome.out, ContainsSubstring("nothing to change"));
  CHECK_THAT(outcome.out, !ContainsSubstring("changed from"));
  CHECK_FALSE(std::filesystem::exists(patched.beside("robot.bak2")));
}

TEST_CASE("Another model replaces numbers and comments, adds none, and keeps the older backup") {
  const PatchCase patched("mujoco_patch_other", test::model_with_effects(), robot);
  REQUIRE(patched.run("mujoco", wheel).status == ExitStatus::done);
  const std::string once = patched.text();
  REQUIRE(patched.run("mujoco", {"--wheel-radius", "0.04", "--wheel-inertia", "0.003"}).status ==
          ExitStatus::done);
  const std::string other = patched.text();
  CHECK(other != once);
  CHECK(std::ranges::count(other, '\n') == std::ranges::count(once, '\n'));
  CHECK(test::file_text(patched.beside("robot.bak")) == robot);
  CHECK(test::file_text(patched.beside("robot.bak2")) == once);
  REQUIRE(patched.run("mujoco", wheel).status == ExitStatus::done);
  CHECK(patched.text() == once);
}

TEST_CASE("With an output the patched file itself stays, and nobody else's file is lost") {
  const PatchCase patched("mujoco_patch_output", test::model_with_effects(), robot);
  const std::string out = patched.beside("out.xml").string();
  REQUIRE(patched.run("mujoco", with(wheel, {"-o", out})).status == ExitStatus::done);
  CHECK(patched.text() == robot);
  CHECK(test::file_text(out) != robot);
  CHECK_FALSE(std::filesystem::exists(patched.beside("robot.bak")));
  const auto again = patched.run("mujoco", with(wheel, {"-o", out}));
  CHECK(again.status == ExitStatus::bad_input);
  CHECK_THAT(again.err, ContainsSubstring("is there already"));
}

TEST_CASE("As JSON a patch says of each number where it is, what it was and is, and how well it is known") {
  const PatchCase patched("mujoco_patch_json", test::model_with_effects(), robot);
  const auto json = tools::parse_json(patched.run("mujoco", with(wheel, {"--json"})).out);
  CHECK(json["changed"] == true);
  CHECK_THAT(json["backup"].get<std::string>(), ContainsSubstring("robot.bak"));
  CHECK(json["unsaid"].size() == 2);
  const auto numbers = json["numbers"];
  const auto friction = std::ranges::find_if(
      numbers, [](const auto& number) { return number["place"] == "joint left_hinge frictionloss"; });
  REQUIRE(friction != numbers.end());
  CHECK((*friction)["status"] == "added");
  CHECK((*friction)["row"] == 8);
  CHECK((*friction)["unit"] == "N m");
  CHECK((*friction)["ci95"][0] < (*friction)["ci95"][1]);
}

TEST_CASE("Lines that end by CR LF, attributes in lines of their own, and all in one line are kept so") {
  std::string windows;
  for (const char letter : robot) windows += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  std::string one_line = robot.substr(robot.find("<mujoco"));
  std::ranges::replace(one_line, '\n', ' ');
  for (const std::string& text : {windows, one_line, "\xef\xbb\xbf" + robot}) {
    const PatchCase patched("mujoco_patch_layout", test::model_with_effects(), text);
    const auto outcome = patched.run("mujoco", wheel);
    INFO(outcome.err);
    REQUIRE(outcome.status == ExitStatus::done);
    const std::string once = patched.text();
    CHECK(std::ranges::count(once, '\r') == (text == windows ? std::ranges::count(once, '\n') : 0));
    if (text == one_line) CHECK(std::ranges::count(once, '\n') == 0);
    CHECK_THAT(patched.run("mujoco", wheel).out, ContainsSubstring("nothing to change"));
  }
}

TEST_CASE("A general actuator keeps its gear, and gets the torque that it needs with it") {
  const std::string general = replaced(replaced(robot, "<velocity name=\"left\"  joint='left_hinge' kv='7'/>",
                                                "<general name=\"left\" joint=\"left_hinge\" gear=\"50\"/>"),
                                       "<velocity name=\"right\" joint=\"right_hinge\" kv=\"7\"/>",
                                       "<general name=\"right\" joint=\"right_hinge\" gear=\"50\"/>");
  refused(general, {}, "at a control of 50, not of 1.11111111; add --control-per-speed 50");
  const PatchCase patched("mujoco_patch_gear", test::linear_model(), general);
  const auto outcome = patched.run("mujoco", with(wheel, {"--control-per-speed", "50"}));
  INFO(outcome.err << outcome.out);
  REQUIRE(outcome.status == ExitStatus::done);
  CHECK_THAT(patched.text(), ContainsSubstring("gear=\"50\" gaintype=\"fixed\" gainprm=\""));
}

TEST_CASE("Which wheels are meant is found by their names, or has to be said") {
  const std::string nameless = replaced(
      replaced(robot, "<velocity name=\"left\"  joint='left_hinge' kv='7'/>", "<velocity joint='a' kv='7'/>"),
      "name=\"left_hinge\"", "name=\"a\"");
  refused(nameless, {},
          "its actuators: velocity of joint a, velocity of joint right_hinge; give the joint one, or name it "
          "by --left-joint");
  const PatchCase patched("mujoco_patch_named", test::model_with_effects(), nameless);
  CHECK(patched.run("mujoco", with(wheel, {"--left-joint", "a"})).status == ExitStatus::done);
  refused(nameless, {"--left-joint", "b"}, "has 0 actuators of joint b");
  refused(robot, {"--left-joint", "right_hinge"}, "is taken for both wheels");
}

TEST_CASE("An MJCF file without the place for the numbers is left as it is, and told what it lacks") {
  refused(replaced(robot, "name=\"left_hinge\"", "name=\"other\""), {},
          "drives joint left_hinge, which this file does not have");
  refused(replaced(replaced(robot, "<velocity name=\"left\"", "<motor name=\"left\""), "kv='7'", ""), {},
          "has 0 <velocity> or <general> actuators of a joint that is called left");
  refused(replaced(robot, "kv='7'", "kv='${gain}'"), {}, "xacro");
  refused(replaced(robot, "kv='7'", "kv='7' kv='8'"), {}, "has kv twice");
  refused("<sdf/>", {}, ":1: <sdf> is not <mujoco>");
}

TEST_CASE("A file that is no sound XML is refused with its row") {
  refused(replaced(robot, "</actuator>", "</actuators>"), {}, ":20: is broken XML");
  refused(robot + "<mujoco/>", {}, ":22: <mujoco> is a second root element");
  refused("", {}, "is broken XML");
  refused("hello\n", {}, "is broken XML");
  refused(replaced(robot, "two  wheels", "two \xe4 wheels"), {}, "is not UTF-8");
  refused(replaced(robot, "two  wheels", std::string("two \0 wheels", 12)), {}, "is not UTF-8");
  std::string deep = "<mujoco>";
  for (int i = 0; i < 100'000; ++i) deep += "<body>";
  for (int i = 0; i < 100'000; ++i) deep += "</body>";
  refused(deep + "</mujoco>", {}, "is deeper than 256 levels");
  refused(std::string((8U << 20U) + 1, ' '), {}, "8 MiB");
}

TEST_CASE("A link, a folder or a device in the place of a file is refused") {
  const PatchCase patched("mujoco_patch_link", test::model_with_effects(), robot);
  const auto real = patched.beside("real.xml");
  std::filesystem::rename(patched.file(), real);
  std::filesystem::create_symlink(real, patched.file());
  CHECK_THAT(patched.run("mujoco", wheel).err, ContainsSubstring("is a symbolic link"));
  CHECK(test::file_text(real) == robot);
  std::filesystem::remove(patched.file());
  std::filesystem::create_directory(patched.file());
  CHECK_THAT(patched.run("mujoco", wheel).err, ContainsSubstring("is a folder"));
  std::filesystem::remove(patched.file());
  CHECK(patched.run("mujoco", wheel).status == ExitStatus::bad_input);
}
