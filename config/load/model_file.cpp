#include "config/load/model_file.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "config/load/model_effects.hpp"
#include "config/load/one_line_text.hpp"
#include "config/load/output_file.hpp"
#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

constexpr std::size_t max_taps = 200;
constexpr double largest_stable_pole = 1.0 - 1e-9;  // an integrator comes out below 1 by rounding
constexpr Range weight{-1e6, 1e6};
constexpr Range gain{-100.0, 100.0};  // no drive reaches a hundred times what it is told
constexpr Range deviation{0.0, 1e6};

std::vector<double> weights(YamlReader& wheel, std::string_view key) {
  std::vector<double> values = wheel.numbers(key, weight);
  if (values.empty()) wheel.fail(key, "is empty, but must hold at least one weight");
  if (values.size() > max_taps) {
    wheel.fail(key, "holds " + std::to_string(values.size()) + " weights, but at most " +
                        std::to_string(max_taps) + " are allowed");
  }
  return values;
}

WheelFit wheel_fit(YamlReader fit) {
  WheelFit result;
  result.gain.from_left = fit.number("gain_from_left", gain);
  result.gain_standard_error.from_left = fit.number("gain_from_left_standard_error", deviation);
  result.gain.from_right = fit.number("gain_from_right", gain);
  result.gain_standard_error.from_right = fit.number("gain_from_right_standard_error", deviation);
  result.position_noise_m = fit.number("position_noise_m", deviation);
  result.drift_m_per_sqrt_s = fit.number("drift_m_per_sqrt_s", deviation);
  fit.finish();
  return result;
}

YamlReader required_section(YamlReader& parent, std::string_view key) {
  auto section = parent.section(key);
  if (!section) parent.fail(key, "is missing here; it must hold keys below it");
  return std::move(*section);
}

// A steady command's speed, in m/s per m/s.
double steady_gain(const std::vector<double>& from_command, const std::vector<double>& from_own_past) {
  return std::accumulate(from_command.begin(), from_command.end(), 0.0) /
         (1.0 - std::accumulate(from_own_past.begin(), from_own_past.end(), 0.0));
}

void check_gain(const YamlReader& wheel, std::string_view key, const std::vector<double>& from_command,
                const std::vector<double>& from_own_past) {
  const double reached = steady_gain(from_command, from_own_past);
  if (std::abs(reached) <= gain.maximum) return;
  wheel.fail(key, "makes the wheel reach " + plain_number(reached) +
                      " m/s per m/s commanded, but a model of a robot lies within -100 and 100");
}

void read_wheel(YamlReader wheel, ModelType type, WheelResponse& response, std::optional<WheelFit>& fit) {
  response.from_left = weights(wheel, "from_left");
  response.from_right = weights(wheel, "from_right");
  if (response.from_right.size() != response.from_left.size()) {
    wheel.fail("from_right", "holds " + std::to_string(response.from_right.size()) +
                                 " weights, but 'from_left' " + std::to_string(response.from_left.size()) +
                                 "; give both the same number");
  }
  if (type == ModelType::arma) {
    response.from_own_past = weights(wheel, "from_own_past");
    const double pole = largest_pole(response);
    if (pole >= largest_stable_pole) {
      wheel.fail("from_own_past", "makes the wheel's speed run away (largest pole " + plain_number(pole) +
                                      "); it must be below 1");
    }
  } else if (wheel.has("from_own_past")) {
    wheel.fail("from_own_past", "belongs to type 'arma', but this model is of type 'fir'");
  }
  check_gain(wheel, "from_left", response.from_left, response.from_own_past);
  check_gain(wheel, "from_right", response.from_right, response.from_own_past);
  if (auto section = wheel.section("fit")) fit = wheel_fit(std::move(*section));
  wheel.finish();
}

void read_linear_part(YamlReader linear_part, RobotModel& model) {
  if (!linear_part.has("type")) linear_part.fail("type", "is missing here; it must be fir or arma");
  model.linear_part.type =
      linear_part.choice("type", {{"fir", ModelType::fir}, {"arma", ModelType::arma}}, ModelType::fir);
  read_wheel(required_section(linear_part, "left"), model.linear_part.type, model.linear_part.left,
             model.left_fit);
  read_wheel(required_section(linear_part, "right"), model.linear_part.type, model.linear_part.right,
             model.right_fit);
  const WheelResponse& left = model.linear_part.left;
  const WheelResponse& right = model.linear_part.right;
  if (left.from_left.size() != right.from_left.size() ||
      left.from_own_past.size() != right.from_own_past.size()) {
    linear_part.fail("right", "holds lists of other lengths than 'left'; fill the shorter ones with zeros");
  }
  linear_part.finish();
}

EncoderScale read_encoder_scale(YamlReader scale) {
  EncoderScale result;
  result.metres_per_tick.left = scale.number("metres_per_tick_left", {1e-9, 1.0, "m"});
  result.metres_per_tick.right = scale.number("metres_per_tick_right", {1e-9, 1.0, "m"});
  result.ticks_per_turn = scale.number("ticks_per_turn", {1.0, 1e9, "ticks"});
  result.relative_standard_error = scale.number("relative_standard_error", {0.0, 1.0});
  scale.finish();
  return result;
}

RobotModel read_model(YamlReader file) {
  const auto version = file.integer("wheelwright_model", {1, 1000000});
  if (version != 1) {
    file.fail("wheelwright_model", "is " + std::to_string(version) + ", but only version 1 is known");
  }
  RobotModel model;
  model.robot = one_line_text(file, "robot", "");
  model.created = file.text("created", "");
  model.source = file.texts("source");
  model.linear_part.wheel_base_m = file.number("wheel_base_m", {0.001, 10.0, "m"});
  model.linear_part.period_s = file.number("period_s", {0.0001, 10.0, "s"});
  if (auto scale = file.section("encoder_scale")) model.encoder_scale = read_encoder_scale(std::move(*scale));
  read_linear_part(required_section(file, "core"), model);
  model.effects = read_effects(file);
  file.finish();
  return model;
}

std::string line(int indent, const std::string& key, const std::string& value,
                 const std::string& comment = "") {
  std::string text(static_cast<std::size_t>(indent), ' ');
  text += key + ": " + value;
  return text + (comment.empty() ? "" : "  # " + comment) + "\n";
}

std::string flow_list(const std::vector<double>& values) {
  constexpr std::size_t per_line = 4;
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += i % per_line == 0 ? ",\n      " : ", ";
    text += plain_number(values[i]);
  }
  return text + "]";
}

std::string wheel_to_yaml(const std::string& key, const WheelResponse& wheel,
                          const std::optional<WheelFit>& fit) {
  std::string text = "  " + key + ":\n";
  text += line(4, "from_left", flow_list(wheel.from_left));
  text += line(4, "from_right", flow_list(wheel.from_right));
  if (!wheel.from_own_past.empty()) text += line(4, "from_own_past", flow_list(wheel.from_own_past));
  if (!fit) return text;
  text += "    fit:\n";
  text += line(6, "gain_from_left", plain_number(fit->gain.from_left), "m/s reached per m/s commanded");
  text += line(6, "gain_from_left_standard_error", plain_number(fit->gain_standard_error.from_left));
  text += line(6, "gain_from_right", plain_number(fit->gain.from_right));
  text += line(6, "gain_from_right_standard_error", plain_number(fit->gain_standard_error.from_right));
  text += line(6, "position_noise_m", plain_number(fit->position_noise_m), "of one reading of wheel travel");
  text += line(6, "drift_m_per_sqrt_s", plain_number(fit->drift_m_per_sqrt_s),
               "random walk of wheel travel against the model at first; may fade");
  return text;
}

std::string linear_part_to_yaml(const RobotModel& model) {
  std::string text =
      "\n# How the wheels answer to commands. The speed of a wheel over one period is the sum of\n"
      "#   from_left[i]     x the left command, i periods ago  (i = 0: the period itself), and\n"
      "#   from_right[i]    x the right command, i periods ago";
  text += model.linear_part.type == ModelType::arma
              ? ", and\n#   from_own_past[i] x the wheel's own speed, i+1 periods ago.\n"
              : ".\n";
  text += "# `fit` says how well it is known: one standard error of what the data gave.\ncore:\n";
  text += line(2, "type", model.linear_part.type == ModelType::arma ? "arma" : "fir");
  text += wheel_to_yaml("left", model.linear_part.left, model.left_fit);
  text += wheel_to_yaml("right", model.linear_part.right, model.right_fit);
  return text;
}

}  // namespace

RobotModel load_model(const std::filesystem::path& path) {
  return read_model(YamlReader::load(path));
}

RobotModel parse_model(const std::string& text, const std::string& name) {
  return read_model(YamlReader::parse(text, name));
}

std::string model_to_yaml(const RobotModel& model) {
  std::string text =
      "# The model of one robot: commanded wheel speeds in, wheel speeds on the floor out.\n"
      "# Metres, seconds, radians; wheel speeds and commands in m/s.\n";
  text += line(0, "wheelwright_model", "1", "version of this format");
  text += line(0, "robot", quoted(model.robot));
  text += line(0, "created", quoted(model.created));
  text += "source:" + std::string(model.source.empty() ? " []" : "") + "  # what it was made from\n";
  for (const auto& source : model.source) text += "  - " + quoted(source) + "\n";
  text += "\n# The one given constant, and the time step of the model.\n";
  text +=
      line(0, "wheel_base_m", plain_number(model.linear_part.wheel_base_m), "distance between the wheels");
  text += line(0, "period_s", plain_number(model.linear_part.period_s));
  if (const auto& scale = model.encoder_scale) {
    text += "\n# What a wheel rolls per encoder tick, found by turning in place. It depends on the floor.\n";
    text += "encoder_scale:\n";
    text += line(2, "metres_per_tick_left", plain_number(scale->metres_per_tick.left));
    text += line(2, "metres_per_tick_right", plain_number(scale->metres_per_tick.right));
    text += line(2, "ticks_per_turn", plain_number(scale->ticks_per_turn),
                 "of one wheel, full turn of the robot");
    text += line(2, "relative_standard_error", plain_number(scale->relative_standard_error));
  }
  return text + linear_part_to_yaml(model) + effects_to_yaml(model.effects);
}

void save_model(const RobotModel& model, const std::filesystem::path& path) {
  const std::string text = model_to_yaml(model);
  parse_model(text, path.string());
  if (const auto error = write_output({path, OutputKind::model}, text)) throw ConfigError(*error);
}

}  // namespace wheelwright::config
