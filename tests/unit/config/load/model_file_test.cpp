#include "config/load/model_file.hpp"

#include <filesystem>
#include <limits>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using config::ConfigError;
using config::model_to_yaml;
using config::parse_model;

namespace {

RobotModel example_model(ModelType type) {
  RobotModel model;
  model.robot = "Roomba \"560\" no. 1 \\ \xc3\xa9";
  model.created = "2026-01-02T03:04:05Z";
  model.source = {"run 1.csv", "a: b # c"};
  model.encoder_scale = EncoderScale{{0.000444565, 0.1 + 0.2}, 1660.7, 0.0021};
  model.linear_part = {type,
                       0.018,
                       1.0 / 3.0,
                       {{1.0 / 7.0, -2e-17, 5e-324}, {0.0, -0.0, 1.0}, {}},
                       {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {}}};
  if (type == ModelType::arma) {
    model.linear_part.left.from_own_past = {0.5, 0.1};
    model.linear_part.right.from_own_past = {-0.3, 0.2};
  }
  model.left_fit = WheelFit{{1.1, 0.01}, {0.001, 0.002}, 1.0 / 6000.0, 0.0004};
  return model;
}

bool same(const WheelResponse& a, const WheelResponse& b) {
  return a.from_left == b.from_left && a.from_right == b.from_right && a.from_own_past == b.from_own_past;
}

std::string error_of(const std::string& text) {
  try {
    parse_model(text, "robot.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

// A valid file, so that a test can spoil one thing of it.
std::string small_model(const std::string& type, const std::string& left, const std::string& right) {
  return "wheelwright_model: 1\nwheel_base_m: 0.235\nperiod_s: 0.018\ncore:\n  type: " + type +
         "\n  left: {" + left + "}\n  right: {" + right + "}\n";
}

const std::string wheel = "from_left: [1, 0], from_right: [0, 1]";

std::string many_weights(std::size_t count) {
  std::string list = "0";
  for (std::size_t i = 1; i < count; ++i) list += ", 0";
  return "from_left: [" + list + "], from_right: [" + list + "]";
}

}  // namespace

TEST_CASE("A model comes back from its file exactly as it was saved") {
  for (const ModelType type : {ModelType::fir, ModelType::arma}) {
    const RobotModel model = example_model(type);
    const auto path = test::temporary_folder() / "wheelwright_saved_model.yaml";
    config::save_model(model, path);
    const RobotModel back = config::load_model(path);
    std::filesystem::remove(path);
    CHECK(back.robot == model.robot);
    CHECK(back.created == model.created);
    CHECK(back.source == model.source);
    REQUIRE(back.encoder_scale);
    CHECK(back.encoder_scale->metres_per_tick.right == model.encoder_scale->metres_per_tick.right);
    CHECK(back.encoder_scale->relative_standard_error == model.encoder_scale->relative_standard_error);
    CHECK(back.linear_part.type == type);
    CHECK(back.linear_part.period_s == model.linear_part.period_s);
    CHECK(back.linear_part.wheel_base_m == model.linear_part.wheel_base_m);
    CHECK(same(back.linear_part.left, model.linear_part.left));
    CHECK(same(back.linear_part.right, model.linear_part.right));
    REQUIRE(back.left_fit);
    CHECK(back.left_fit->gain_standard_error.from_right == model.left_fit->gain_standard_error.from_right);
    CHECK(back.left_fit->position_noise_m == model.left_fit->position_noise_m);
    CHECK_FALSE(back.right_fit);
    CHECK(model_to_yaml(back) == model_to_yaml(model));
  }
}

TEST_CASE("A small model is accepted without the parts that only a fit knows") {
  const RobotModel model = parse_model(small_model("fir", wheel, wheel), "robot.yaml");
  CHECK(model.linear_part.right.from_right == std::vector<double>{0.0, 1.0});
  CHECK_FALSE(model.encoder_scale);
}

TEST_CASE("A stiff caster of a file from before it had a lag is accepted, and has none") {
  const std::string file = small_model("fir", wheel, wheel) +
                           "effects:\n  - name: caster_kick\n    variant: swivel\n"
                           "    parameters: {push: 0.01, trail: 0.02, arm: 0.12}\n"
                           "    ci95: {push: [0.009, 0.011], trail: [0.01, 0.03], arm: [0.1, 0.14]}\n";
  const AddedEffect caster = parse_model(file, "robot.yaml").effects.front();
  CHECK(caster.setting.parameters == std::vector<double>{0.01, 0.02, 0.12, 0.0, 0.7});
  CHECK(caster.intervals[3].lower == 0.0);
  CHECK(caster.intervals[3].upper == 0.0);
  CHECK_THAT(error_of(small_model("fir", wheel, wheel) +
                      "effects: [{name: caster_kick, variant: swivel, parameters: {push: 0.01}}]\n"),
             ContainsSubstring("trail"));
}

TEST_CASE("Every fault of a model file is refused with its place") {
  CHECK_THAT(error_of("wheelwright_model: 2\n"),
             ContainsSubstring("robot.yaml:1:20: 'wheelwright_model' is 2"));
  CHECK_THAT(error_of("robot: a\n"), ContainsSubstring("'wheelwright_model' is missing"));
  CHECK_THAT(error_of("wheelwright_model: 1\nwheel_base_m: 0.2\nperiod_s: 0.018\n"),
             ContainsSubstring("'core' is missing"));
  CHECK_THAT(error_of(small_model("fir", "from_left: [1, 0], from_right: [0]", wheel)),
             ContainsSubstring("robot.yaml:6:41: 'from_right' holds 1 weights, but 'from_left' 2"));
  CHECK_THAT(error_of(small_model("fir", wheel, "from_left: [1], from_right: [0]")),
             ContainsSubstring("robot.yaml:7:10: 'right' holds lists of other lengths"));
  CHECK_THAT(error_of(small_model("fir", "from_left: [], from_right: []", wheel)),
             ContainsSubstring("is empty"));
  CHECK_THAT(error_of(small_model("fir", "from_left: [.nan, 0], from_right: [0, 1]", wheel)),
             ContainsSubstring("robot.yaml:6:22: 'from_left' is '.nan'"));
  CHECK_THAT(error_of(small_model("fir", "from_left: [.inf, 0], from_right: [0, 1]", wheel)),
             ContainsSubstring("must be a number"));
  CHECK(error_of(small_model("fir", many_weights(200), many_weights(200))) == "no error");
  CHECK_THAT(error_of(small_model("fir", many_weights(201), wheel)), ContainsSubstring("holds 201 weights"));
  CHECK_THAT(error_of(small_model("ar", wheel, wheel)), ContainsSubstring("must be one of: fir, arma"));
  CHECK_THAT(error_of(small_model("fir", wheel + ", from_own_past: [0.5]", wheel)),
             ContainsSubstring("belongs to type 'arma'"));
  CHECK_THAT(error_of(small_model("arma", wheel, wheel)), ContainsSubstring("'from_own_past' is missing"));
}

TEST_CASE("A recursion that runs away is refused") {
  const std::string stable = wheel + ", from_own_past: [0.5, 0.4]";
  CHECK(error_of(small_model("arma", stable, stable)) == "no error");
  CHECK_THAT(error_of(small_model("arma", stable, wheel + ", from_own_past: [0.5, 0.5]")),
             ContainsSubstring("'from_own_past' makes the wheel's speed run away"));
}

TEST_CASE("An unknown key of a model file is refused with the nearest right one") {
  CHECK_THAT(error_of(small_model("fir", wheel, wheel) + "robt: x\n"),
             ContainsSubstring("unknown key 'robt'; did you mean 'robot'?"));
  CHECK_THAT(error_of(small_model("fir", wheel + ", from_lft: [1]", wheel)),
             ContainsSubstring("did you mean 'from_left'?"));
  CHECK_THAT(error_of(small_model("fir", wheel, wheel) + "effects: {dead_zone: {}}\n"),
             ContainsSubstring("'effects' is a mapping, but must be a list"));
}

TEST_CASE("A model that could not be loaded again is not written") {
  RobotModel model = example_model(ModelType::fir);
  model.linear_part.left.from_left[0] = std::numeric_limits<double>::quiet_NaN();
  const auto path = test::temporary_folder() / "wheelwright_bad_model.yaml";
  CHECK_THROWS_AS(config::save_model(model, path), ConfigError);
  CHECK_FALSE(std::filesystem::exists(path));
}
