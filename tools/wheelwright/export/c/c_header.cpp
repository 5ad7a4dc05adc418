#include "tools/wheelwright/export/c/c_header.hpp"

#include <algorithm>
#include <utility>

#include "config/load/text_format.hpp"
#include "model/effects/library/effect_library.hpp"
#include "tools/wheelwright/export/c/c_core.hpp"
#include "tools/wheelwright/export/c/placed_effects.hpp"

namespace wheelwright::tools {
namespace {

std::string in_comment(std::string text) {
  for (std::size_t at = text.find("*/"); at != std::string::npos; at = text.find("*/", at))
    text.insert(at + 1, " ");
  for (std::size_t at = text.find("/*"); at != std::string::npos; at = text.find("/*", at))
    text.insert(at + 1, " ");
  return text;
}

// What of a pair a wheel is, in C.
std::string member_of(WheelSide wheel) {
  return wheel == WheelSide::left ? "left" : "right";
}

std::string head(const RobotModel& model, const PlacedEffects& header) {
  std::string text =
      "/* wheelwright_c_header: 1\n   " + in_comment(origin_of(model)) +
      "\n\n   Units are metres, seconds and radians; commands are those of the model's logs. Periods of "
      "the model last " +
      config::plain_number(model.linear_part.period_s) +
      " s.\n"
      "   Use: wheelwright_init once; wheelwright_step once per period, with the commands of both "
      "wheels;\n"
      "   wheelwright_commands_for says what to send so that the robot moves as commanded.\n";
  for (const PlacedEffect& placed : header.placed) {
    if (placed.wheel == WheelSide::right) continue;  // with the left one
    text += "\n   " + full_name(placed.effect->setting) + ": " + in_comment(with_intervals(*placed.effect)) +
            "\n     Inverse: " + placed.fragment->remark("Inverse:");
  }
  for (const Unsaid& unsaid : header.unsaid) {
    text += "\n   " + unsaid.effect + ": cannot be said in this format: " + unsaid.reason;
  }
  return text + "\n*/\n";
}

std::string fragments_of(const PlacedEffects& header) {
  std::vector<const CFragment*> used;
  std::string text;
  for (const PlacedEffect& placed : header.placed) {
    if (std::ranges::find(used, placed.fragment) != used.end()) continue;
    used.push_back(placed.fragment);
    text += "\n" + std::string(placed.fragment->text);
  }
  return text;
}

std::string numbers_of(const PlacedEffects& header) {
  std::string text;
  for (const PlacedEffect& placed : header.placed) {
    text += "/* " + full_name(placed.effect->setting) +
            (placed.wheel ? ", " + member_of(*placed.wheel) : "") + ":";
    for (const ParameterInfo& parameter : parameters_of(placed.setting)) text += " " + parameter.name;
    text += " */\n" + c_array(placed.numbers, placed.setting.parameters);
  }
  return text;
}

std::string arguments_of(const PlacedEffect& placed, const std::string& context, const std::string& what) {
  return "(" + (placed.state.empty() ? "" : "&m->" + placed.state + ", ") + placed.numbers + ", " +
         std::to_string(placed.variant) + ", " + context + ", " + what + ")";
}

// One effect on `speed` or, of the body, on `twist`.
std::string call(const PlacedEffect& placed, const std::string& what) {
  const std::string name(placed.fragment->name);
  if (placed.wheel_load_variants) {
    return "  at = *around;\n  at.next_speed = speed;\n  twist = ww_floor_twist(around, speed);\n  " + name +
           "_body" + arguments_of(placed, "&at", "&twist") +
           ";\n  speed = ww_counted_wheels(around, twist);\n";
  }
  const std::string function = what == "twist" ? "_body" : "_wheels";
  if (placed.wheel) {
    const std::string wheel = member_of(*placed.wheel);
    return "  {\n    ww_pair one = " + what + ";\n    " + name + function +
           arguments_of(placed, "around", "&one") + ";\n    " + what + "." + wheel + " = one." + wheel +
           ";\n  }\n";
  }
  return "  " + name + function + arguments_of(placed, "around", "&" + what) + ";\n";
}

std::string calls(const PlacedEffects& header, EffectStage stage, const std::string& what) {
  std::string text;
  for (const PlacedEffect& placed : header.placed) {
    if (placed.stage == stage) text += call(placed, what);
  }
  return text;
}

// Those on the wheels, and what loads among them take.
std::string wheel_calls(const PlacedEffects& header) {
  std::string text;
  for (const PlacedEffect& placed : header.placed) {
    if (placed.stage != EffectStage::wheel) continue;
    text += placed.loads_motors ? "  before = speed;\n" + call(placed, "speed") +
                                      "  load.left += before.left - speed.left;\n"
                                      "  load.right += before.right - speed.right;\n"
                                : call(placed, "speed");
  }
  return text + "  around->load = load;\n";
}

std::string undo_call(const PlacedEffect& placed, const std::string& what) {
  const std::string name(placed.fragment->name);
  const bool of_body = placed.wheel_load_variants || what == "twist";
  if (!placed.fragment->has(of_body ? "undo_body" : "undo_wheels")) return "";
  if (placed.wheel_load_variants) {
    return "  twist = ww_floor_twist(around, speed);\n  reached &= " + name + "_undo_body" +
           arguments_of(placed, "around", "&twist") + ";\n  speed = ww_counted_wheels(around, twist);\n";
  }
  if (placed.wheel) {  // what the other wheel cannot reach is not asked of this one
    const std::string wheel = member_of(*placed.wheel);
    return "  {\n    ww_pair one = {0.0, 0.0};\n    one." + wheel + " = " + what + "." + wheel +
           ";\n    reached &= " + name + "_undo_wheels" + arguments_of(placed, "around", "&one") + ";\n    " +
           what + "." + wheel + " = one." + wheel + ";\n  }\n";
  }
  return "  reached &= " + name + (of_body ? "_undo_body" : "_undo_wheels") +
         arguments_of(placed, "around", "&" + what) + ";\n";
}

std::string undo_calls(const PlacedEffects& header, EffectStage stage, const std::string& what) {
  std::string text;
  for (auto placed = header.placed.rbegin(); placed != header.placed.rend(); ++placed) {
    if (placed->stage == stage) text += undo_call(*placed, what);
  }
  return text;
}

std::string model_type(const PlacedEffects& header) {
  std::string text = R"c(
/* The caller owns it. Between two steps, `around.pose` and `around.battery_v` may be set. */
typedef struct {
  ww_around around;
  ww_pair wheel_speed; /* as the encoders see it */
  ww_pair floor_speed; /* as the wheels roll on the floor */
  ww_twist twist;      /* of the middle of the axle */
  ww_linear_state linear;
)c";
  for (const PlacedEffect& placed : header.placed) {
    if (!placed.state.empty())
      text += "  " + std::string(placed.fragment->name) + "_state " + placed.state + ";\n";
  }
  return text + "} wheelwright_model;\n";
}

std::string init_function(const RobotModel& model, const PlacedEffects& header) {
  std::string text = R"c(
/* To rest, at x = y = theta = 0. */
static inline void wheelwright_init(wheelwright_model* m) {
  static const ww_around at_rest = {0.0, 0.0, 0.0, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}, {0.0, 0.0, 0.0}, 0.0};
  m->around = at_rest;
  m->wheel_speed = m->floor_speed = at_rest.speed;
  m->twist.v = m->twist.w = 0.0;
  ww_linear_reset(&m->linear);
)c";
  text += "  m->around.period_s = " + config::plain_number(model.linear_part.period_s) + ";\n";
  text += "  m->around.wheel_base_m = " + config::plain_number(model.linear_part.wheel_base_m) + ";\n";
  for (const PlacedEffect& placed : header.placed) {
    if (!placed.fragment->has("rolling")) continue;
    text += "  m->around.rolling = ww_scaled(m->around.rolling, " + std::string(placed.fragment->name) +
            "_rolling(" + placed.numbers + ", " + std::to_string(placed.variant) + "));\n";
  }
  for (const PlacedEffect& placed : header.placed) {
    if (placed.state.empty()) continue;
    text += "  " + std::string(placed.fragment->name) + "_reset(&m->" + placed.state + ", " + placed.numbers +
            ", " + std::to_string(placed.variant) + ");\n";
  }
  return text + "}\n";
}

std::string step_function(const PlacedEffects& header) {
  const bool loads_wheels = std::ranges::any_of(header.placed, &PlacedEffect::wheel_load_variants);
  const bool loads_motors = std::ranges::any_of(header.placed, [](const PlacedEffect& placed) {
    return placed.loads_motors && placed.stage == EffectStage::wheel;
  });
  return R"c(
/* One period with these commands in force. Speeds, twist and pose are in the model afterwards. */
static inline void wheelwright_step(wheelwright_model* m, double left_command, double right_command) {
  ww_around* around = &m->around;
)c" + std::string(loads_wheels ? "  ww_around at;\n" : "") +
         std::string(loads_motors ? "  ww_pair before;\n" : "") +
         R"c(  ww_pair command, speed, load = {0.0, 0.0};
  ww_twist twist;
  command.left = left_command;
  command.right = right_command;
  around->command = command;
)c" + calls(header, EffectStage::command, "command") +
         "  speed = ww_linear_step(&m->linear, command);\n" + wheel_calls(header) +
         "  m->wheel_speed = around->next_speed = speed;\n" + calls(header, EffectStage::floor, "speed") +
         "  m->floor_speed = speed;\n  twist = ww_twist_of(speed, around->wheel_base_m);\n" +
         calls(header, EffectStage::body, "twist") +
         R"c(  m->twist = twist;
  around->pose = ww_moved(around->pose, twist, around->period_s);
  around->speed = m->wheel_speed;
  around->distance.left += m->wheel_speed.left * around->period_s;
  around->distance.right += m->wheel_speed.right * around->period_s;
  around->time_s += around->period_s;
}
)c";
}

std::string observed_function(const PlacedEffects& header) {
  std::string text = R"c(
/* The pose of the point that an outside reference measures. */
static inline ww_pose wheelwright_observed(const wheelwright_model* m) {
  ww_pose pose = m->around.pose;
)c";
  for (const PlacedEffect& placed : header.placed) {
    if (placed.stage != EffectStage::observation) continue;
    text += "  pose = " + std::string(placed.fragment->name) + "_observed(" + placed.numbers + ", pose);\n";
  }
  return text + "  return pose;\n}\n";
}

std::string inverse_function(const RobotModel& model, const PlacedEffects& header) {
  const auto linear_part = c_core_inverse(model.linear_part);
  if (!linear_part) return "\n/* No inverse: no commands of this model set both wheels' speeds. */\n";
  return "\n" + *linear_part + R"c(
/* What to send so that the robot settles at v (m/s) and w (rad/s), from where the model stands now: heading, time and
   battery count. 1 where it gets there; 0 where it does not, by what stands at the top of each effect. */
static inline int wheelwright_commands_for(const wheelwright_model* m, double v, double w, double* left_command,
                                           double* right_command) {
  const ww_around* around = &m->around;
  int reached = 1;
  ww_twist twist;
  ww_pair speed, command;
  twist.v = v;
  twist.w = w;
)c" + undo_calls(header, EffectStage::body, "twist") +
         "  speed = ww_wheels_of(twist, around->wheel_base_m);\n" +
         undo_calls(header, EffectStage::floor, "speed") + undo_calls(header, EffectStage::wheel, "speed") +
         "  command = ww_linear_undo(speed);\n" + undo_calls(header, EffectStage::command, "command") +
         R"c(  *left_command = command.left;
  *right_command = command.right;
  return reached;
}
)c";
}

}  // namespace

ModelText to_c(const RobotModel& model) {
  PlacedEffects header = place_effects(model);
  std::string text = head(model, header) +
                     "#ifndef WHEELWRIGHT_MODEL_H\n#define WHEELWRIGHT_MODEL_H\n\n#include <math.h>\n\n" +
                     std::string(c_prelude()) + "\n" + c_core(model.linear_part) + fragments_of(header) +
                     "\n" + numbers_of(header) + model_type(header) + init_function(model, header) +
                     step_function(header) + observed_function(header) + inverse_function(model, header) +
                     "\n#endif\n";
  return {std::move(text), std::move(header.unsaid)};
}

}  // namespace wheelwright::tools
