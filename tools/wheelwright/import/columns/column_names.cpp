#include "tools/wheelwright/import/columns/column_names.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "config/load/ascii_text.hpp"
#include "tools/wheelwright/import/columns/column_shapes.hpp"
#include "tools/wheelwright/import/columns/name_words.hpp"
#include "tools/wheelwright/import/columns/pose_names.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

struct Name {
  NameWords words;
  bool is_command = false;
  NamedSide side = NamedSide::none;
  std::string unit{};
  bool dir_is_a_side = false;
};

bool any_has(const Stream& stream, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(
      stream.channels, [&words](const Channel& channel) { return NameWords(channel.name).has_any(words); });
}

// "dir" is right where "esq" is left, in Portuguese; elsewhere a direction.
bool is_portuguese(const Stream& stream) {
  return any_has(stream, {"esq"});
}

// "g" and "d" are gauche and droite beside these.
bool is_french(const Stream& stream) {
  return any_has(stream, {"consigne", "vitesse", "mesuree", "codeur", "temps"});
}

// "fl" and "fr", or "lf" and "rf", of robots with four wheels.
NamedSide side_of_four(const NameWords& words, const Stream& stream) {
  for (const auto& [left, right] : {std::pair<std::string_view, std::string_view>{"fl", "fr"},
                                    {"rl", "rr"},
                                    {"bl", "br"},
                                    {"lf", "rf"},
                                    {"lr", "rr"},
                                    {"lb", "rb"}}) {
    if (words.has(left) && any_has(stream, {right})) return NamedSide::left;
    if (words.has(right) && any_has(stream, {left})) return NamedSide::right;
  }
  return NamedSide::none;
}

NamedSide side_of(const NameWords& words, const Stream& stream) {
  if (words.has("dir") && is_portuguese(stream)) return NamedSide::right;
  if (words.has_any({"g", "d"}) && is_french(stream))
    return words.has("g") ? NamedSide::left : NamedSide::right;
  // Of a quaternion.
  if (words.last() == "rw" && any_has(stream, {"rx"}) && any_has(stream, {"rz"})) return NamedSide::none;
  // In "p_RS_R_x" (EuRoC) the letters name frames.
  if (words.has("rs")) return NamedSide::none;
  if (words.has_any({"front", "rear", "back"}))
    return words.has("left") ? NamedSide::left : words.has("right") ? NamedSide::right : NamedSide::none;
  if (const auto side = side_of_four(words, stream); side != NamedSide::none) return side;
  if (words.has_any({"left",     "l",         "lft",       "port",   "gauche", "links", "linke", "linkes",
                     "sinistra", "izquierda", "izquierdo", "lhs",    "lw",     "wl",    "izq",   "esq",
                     "esquerda", "esquerdo",  "sinistro",  "linker", "lewy",   "lewe"}))
    return NamedSide::left;
  if (words.has_any({"right",   "r",       "rgt",     "starboard", "stbd",    "droite", "rechts", "rechte",
                     "rechtes", "destra",  "derecha", "derecho",   "rhs",     "rw",     "wr",     "der",
                     "direita", "direito", "droit",   "destro",    "rechter", "prawy",  "prawe"}))
    return NamedSide::right;
  return NamedSide::none;
}

// Of a table whose rows are those of one side each: "left", "motor right".
NamedSide side_of_rows(const std::string& label, const Stream& stream) {
  const NameWords words(label);
  const bool is_side = words.words().size() == 1 ||
                       (words.words().size() == 2 && words.has_any({"motor", "wheel", "encoder", "side"}));
  return is_side ? side_of(words, stream) : NamedSide::none;
}

// "Sollgeschwindigkeit", "sollwert".
bool begins_with_target(const NameWords& words) {
  return std::ranges::any_of(words.words(), [](const std::string& word) { return word.starts_with("soll"); });
}

bool is_command_name(const NameWords& words) {
  return begins_with_target(words) ||
         words.has_any(
             {"consigne", "deseada", "deseado", "gewenst", "gewenste", "wanted", "tgt", "vorgabe"}) ||
         words.has_any({"cmd",       "cmdvel", "command", "commanded", "commands", "set",  "setpoint",
                        "setpoints", "sp",     "target",  "desired",   "des",      "goal", "request",
                        "requested", "req",    "demand",  "input",     "u",        "pwm",  "duty",
                        "ramped",    "slewed", "limited", "actuator",  "actuators"});
}

// The reference of a controller is what it wants of a wheel or a speed; that of a place is where it was.
bool is_controller_reference(const NameWords& words, NamedSide side) {
  return words.has_any({"ref", "reference"}) &&
         (side != NamedSide::none ||
          words.has_any({"v", "w", "vel", "velocity", "speed", "omega", "lin", "linear", "ang", "angular"}));
}

bool is_time(const Name& name) {
  const NameWords& words = name.words;
  const auto last = words.last();
  return name.side == NamedSide::none && !words.has_any({"period", "delay"}) &&
         (words.has_any({"time",     "timestamp", "stamp", "t",       "ts",     "zeit",      "temps",
                         "tiempo",   "sec",       "secs",  "seconds", "millis", "micros",    "nsec",
                         "datetime", "date",      "epoch", "elapsed", "clock",  "timestamps"}) ||
          (words.words().size() == 1 && (last == "ms" || last == "us" || last == "ns" || last == "s")));
}

// "dL", "delta_left": the travel since the row before.
bool are_increments(const NameWords& words) {
  return words.has_any({"delta", "increment", "increments", "inc"}) ||
         (words.words().size() == 2 && words.words().front() == "d");
}

Quantity of_wheel(const Name& name) {
  const NameWords& words = name.words;
  if (words.has_any({"current", "currents", "amp", "amps", "ampere", "torque", "temp", "temperature"}))
    return Quantity::unknown;
  // Turns of the field of a motor, of which nobody knows how many make one of the wheel.
  if (words.has("erpm")) return name.is_command ? Quantity::duty : Quantity::unknown;
  const bool is_speed = words.has_any({"vel", "velocity", "speed", "spd", "v", "rpm", "rps", "omega", "w",
                                       "rate", "geschwindigkeit", "drehzahl", "vitesse", "velocidad",
                                       "velocidade", "snelheid", "velocita"}) ||
                        find_unit(speed_units(), name.unit);
  if (words.has("direction") || (words.has("dir") && !name.dir_is_a_side)) return Quantity::direction;
  if (words.has_any({"pwm", "duty", "power", "throttle", "volt", "volts", "voltage", "effort", "dc", "rc",
                     "servo", "esc", "percent", "pct"})) {
    return Quantity::duty;
  }
  if (name.is_command) return Quantity::command;
  if (is_speed) return Quantity::speed;
  if (find_unit(angle_units(), name.unit)) return Quantity::angle;
  if (find_unit(distance_units(), name.unit)) return Quantity::distance;
  if (words.has_any({"tick",     "ticks",  "dticks", "dcount",    "dcounts",  "dcnt",     "denc",
                     "count",    "counts", "cnt",    "enc",       "encoder",  "encoders", "pulse",
                     "pulses",   "qei",    "pos",    "impulse",   "impulsos", "pulsos",   "codeur",
                     "encodeur", "teller", "tacho",  "tachometer"})) {
    return Quantity::count;
  }
  if (words.has_any({"dist", "distance", "travel", "odo", "odometer"})) return Quantity::distance;
  if (words.has_any({"angle", "ang", "phi", "rot", "rotation", "theta", "th", "position"}))
    return Quantity::angle;
  if (are_increments(words)) return Quantity::count;
  if (words.has_any({"actual", "measured", "feedback", "meas", "ist"})) return Quantity::speed;
  if (words.has("motor") || words.has("wheel")) return Quantity::speed;
  return Quantity::unknown;
}

// Of a vector that lies in the plane of the floor: a robot on two wheels moves along x and turns about z.
bool is_other_axis(const NameWords& words) {
  const auto last = words.last();
  if (words.has_any({"acc", "accel", "acceleration", "force", "torque", "mag", "covariance"})) return true;
  if (words.has("linear")) return last == "y" || last == "z";
  return words.has("angular") && (last == "x" || last == "y");
}

// "MotorA", "motor_1": what is written to it.
bool is_motor_alone(const NameWords& words) {
  return words.words().size() == 2 && words.has_any({"motor", "mot"}) &&
         words.has_any({"a", "b", "0", "1", "2"});
}

// A distance to a wall, and the angle of what looks at it.
bool is_of_a_sensor(const NameWords& words) {
  return words.has_any({"sonar", "ultrasonic", "ultrasound", "us", "lidar", "laser", "range", "sensor",
                        "scan", "servo", "obstacle", "wall", "tof", "ir", "steer", "steering", "front",
                        "camera"});
}

Quantity of_body(const Name& name) {
  const NameWords& words = name.words;
  const auto last = words.last();
  if (is_other_axis(words)) return Quantity::unknown;
  const bool about_z = last == "z" || words.words().size() == 1;
  if (words.has_any({"battery", "bat", "batt", "vbat", "voltage", "volt", "supply"}) &&
      !words.has_any({"percentage", "percent", "current", "charge", "capacity", "temperature"})) {
    return Quantity::battery;
  }
  if ((words.has_any({"gyro", "gyr"}) && about_z) || last == "gz" ||
      (words.has("angular") && words.has("velocity") && last == "z")) {
    return name.is_command ? Quantity::angular_command : Quantity::gyro;
  }
  if (words.has_any({"dir", "direction"})) return Quantity::direction;
  if (words.has_any({"throttle", "thr"}) && !words.has("angle")) return Quantity::throttle;
  if (words.has_any({"steering", "steer"}) && !words.has("angle")) return Quantity::steering;
  if (!name.is_command && name.unit.empty() && (last == "turn" || last == "turning"))
    return Quantity::steering;
  const bool is_angular =
      (words.has("angular") && last != "x" && last != "y") ||
      words.has_any({"w", "omega", "wz", "yawrate", "ang", "rot", "turnrate"}) ||
      (words.has_any({"yaw", "turn", "turning"}) && words.has_any({"rate", "vel", "speed"})) ||
      (name.is_command &&
       words.has_any({"turn", "turning", "steer", "steering", "rotation", "yaw", "ang"})) ||
      find_unit(angular_units(), name.unit);
  if (is_angular) return name.is_command ? Quantity::angular_command : Quantity::angular_speed;
  const bool is_linear = (words.has("linear") && last != "y" && last != "z") ||
                         words.has_any({"v", "vx", "lin", "fwd", "forward", "trans"}) ||
                         (words.has_any({"vel", "velocity", "speed"}) && last != "y" && last != "z") ||
                         find_unit(speed_units(), name.unit);
  if (is_linear) return name.is_command ? Quantity::linear_command : Quantity::linear_speed;
  if (words.has_any({"pwm", "duty", "throttle", "power", "percent", "pct"})) return Quantity::duty;
  if (is_motor_alone(words)) return Quantity::duty;
  if (words.has_any({"curvature", "kappa"})) return Quantity::curvature;
  if (words.has("radius") && !words.has_any({"wheel", "wheels"})) return Quantity::radius;
  if (words.has_any({"encoder", "enc", "ticks", "counts", "tick", "count", "tachometer", "tacho"}))
    return words.has_any({"abs", "diff"}) ? Quantity::unknown : Quantity::count;
  if (!name.is_command && !is_of_a_sensor(words)) {
    if (words.has_any({"distance", "dist", "travel", "travelled", "odometer"})) return Quantity::travelled;
    if (words.has_any({"angle", "turned"})) return Quantity::turned;
  }
  return name.is_command ? Quantity::command : Quantity::unknown;
}

// "joy_x", "left_stick_y", "axes[1]"; not an axis of a drive or of a sensor ("axis0.vel_estimate").
bool is_axis_of_a_stick(const NameWords& words) {
  if (words.has_any({"button", "buttons", "btn", "pressed", "gyro", "acc", "accel", "imu"})) return false;
  if (words.has_any({"joy", "joystick", "gamepad", "joypad", "thumbstick"})) return true;
  return words.has_any({"axis", "axes", "stick"}) &&
         std::ranges::all_of(words.words(), [](const std::string& word) {
           return config::is_digit(word.front()) ||
                  NameWords(word).has_any({"axis", "axes", "stick", "left", "right", "l", "r", "x", "y",
                                           "linear", "angular", "turn", "steer", "steering", "vertical",
                                           "horizontal", "throttle", "forward"});
         });
}

Quantity quantity_of(const Name& name, const Stream& stream) {
  if (is_time(name)) return Quantity::time;
  if (is_axis_of_a_stick(name.words)) return Quantity::stick;
  if (name.side != NamedSide::none) return of_wheel(name);
  if (const auto pose = pose_quantity(name.words, name.is_command, stream)) return *pose;
  const Quantity quantity = of_body(name);
  const auto last = name.words.last();
  const bool is_height = quantity == Quantity::unknown && !is_other_axis(name.words) &&
                         (last == "z" || last == "pz" || last == "tz" || last == "posz" || last == "zpos");
  return is_height ? Quantity::z : quantity;
}

// An ODrive counts turns ("axis0.encoder.vel_estimate"); before its firmware 0.5, edges of the encoder.
std::string unit_of_odrive(const NameWords& words, const Channel& channel) {
  constexpr double most_turns_s = 200.0;
  if (!words.has_any({"axis", "odrv", "odrive"}) || !words.has_any({"estimate", "input"})) return {};
  if (words.has("pos") && !are_whole(channel.values)) return "turn";
  return words.has("vel") && largest(channel.values) < most_turns_s ? "turn/s" : std::string();
}

// "yaw_x10", "heading_x100": whole tenths or hundredths of a degree.
std::string unit_of_tenths(const NameWords& words) {
  if (words.words().size() < 3 || words.words()[words.words().size() - 2] != "x") return {};
  return words.last() == "10" ? "0.1deg" : words.last() == "100" ? "0.01deg" : "";
}

// "data", "value", "data[0]": the topic is the name.
bool says_nothing(const NameWords& words) {
  const auto is_number = [](const std::string& word) { return std::ranges::all_of(word, config::is_digit); };
  return words.has_any({"data", "value", "val"}) &&
         std::ranges::all_of(words.words(), [&](const std::string& word) {
           return is_number(word) || word == "data" || word == "value" || word == "val";
         });
}

bool says_a_side_alone(const NameWords& words) {
  return words.words().size() == 1 && words.has_any({"left", "right", "l", "r"});
}

std::string numbers_of(const std::string& name) {
  std::string numbers;
  for (const char c : name)
    if (config::is_digit(c)) numbers += c;
  return numbers;
}

// Integers under the name of a wheel that say no more are its counts.
bool are_counts_of_a_wheel(const Stream& stream, const Name& name, const NameMeaning& meaning) {
  return meaning.side != NamedSide::none && meaning.unit.empty() && meaning.quantity == Quantity::speed &&
         name.words.has("wheel") &&
         !name.words.has_any({"speed", "spd", "vel", "velocity", "rpm", "rps", "omega", "rate", "v", "w"}) &&
         stream.type.find("Int") != std::string::npos;
}

}  // namespace

NameMeaning meaning_of(const Stream& stream, const Channel& channel) {
  // Transforms and the covariances beside a pose say nothing by their topic.
  const std::string topic = stream.name.substr(0, stream.name.find(':'));
  Name name{.words = NameWords(channel.name)};
  if (name.words.empty()) return {};
  if ((says_nothing(name.words) || says_a_side_alone(name.words)) && !topic.empty())
    name.words =
        NameWords(topic + "_" + (says_a_side_alone(name.words) ? channel.name : numbers_of(channel.name)));
  name.unit = channel.unit.empty() ? name.words.take_unit() : channel.unit;
  if (name.unit == "in") name.unit = "inch";  // a word of many names, but a unit where the file states one
  if (const auto standard = unit_by_spelling(name.unit); !standard.empty()) name.unit = standard;
  if (name.unit.empty()) name.unit = unit_of_odrive(name.words, channel);
  name.side = side_of(name.words, stream);
  if (name.side == NamedSide::none && stream.type.empty()) name.side = side_of_rows(topic, stream);
  name.is_command = is_command_name(name.words) || is_controller_reference(name.words, name.side) ||
                    channel.name.find('*') != std::string::npos || is_command_name(NameWords(topic));
  if (name.words.empty()) return {};
  name.dir_is_a_side = name.words.has("dir") && is_portuguese(stream);

  NameMeaning meaning{Quantity::unknown, name.side, name.unit};
  meaning.quantity = quantity_of(name, stream);
  if (meaning.quantity == Quantity::heading && meaning.unit.empty())
    meaning.unit = unit_of_tenths(name.words);
  if (are_counts_of_a_wheel(stream, name, meaning)) meaning.quantity = Quantity::count;
  // The positions of joints are angles.
  if (meaning.quantity == Quantity::count && stream.type.find("JointState") != std::string::npos) {
    meaning.quantity = Quantity::angle;
  }
  return meaning;
}

}  // namespace wheelwright::import
