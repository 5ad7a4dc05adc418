#include "tools/wheelwright/export/c/c_core.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"

namespace wheelwright::tools {
namespace {

std::vector<double> without_trailing_zeros(std::vector<double> weights) {
  while (!weights.empty() && weights.back() == 0.0) weights.pop_back();
  return weights;
}

// Of the command in force, the first weight; of those before it, the others.
struct Weights {
  double now = 0.0;
  std::vector<double> before;

  explicit Weights(const std::vector<double>& all) : before(without_trailing_zeros(all)) {
    if (before.empty()) return;
    now = before.front();
    before.erase(before.begin());
  }
};

struct Wheel {
  Weights from_left;
  Weights from_right;
  std::vector<double> from_own_past;

  explicit Wheel(const WheelResponse& response)
      : from_left(response.from_left),
        from_right(response.from_right),
        from_own_past(without_trailing_zeros(response.from_own_past)) {}

  std::size_t longest() const {
    return std::max({from_left.before.size(), from_right.before.size(), from_own_past.size()});
  }
};

std::string dot(const std::string& weights, std::size_t count, const std::string& history) {
  if (count == 0) return "0.0";
  return "ww_dot(" + weights + ", " + std::to_string(count) + ", s->" + history + ", s->newest)";
}

std::string arrays_of(const std::string& side, const Wheel& wheel) {
  std::string text;
  const auto add = [&](const std::string& name, const std::vector<double>& weights) {
    if (!weights.empty()) text += c_array("ww_" + side + "_from_" + name, weights);
  };
  add("left_before", wheel.from_left.before);
  add("right_before", wheel.from_right.before);
  add("own_past", wheel.from_own_past);
  return text;
}

std::string speed_of(const std::string& side, const Wheel& wheel) {
  const std::string name = "ww_" + side + "_from_";
  return "  speed." + side + " = (" + config::plain_number(wheel.from_left.now) + " * command.left + " +
         config::plain_number(wheel.from_right.now) + " * command.right) +\n      (" +
         dot(name + "left_before", wheel.from_left.before.size(), "left_commands") + " +\n       " +
         dot(name + "right_before", wheel.from_right.before.size(), "right_commands") + ") +\n      " +
         dot(name + "own_past", wheel.from_own_past.size(), side + "_speeds") + ";\n";
}

}  // namespace

std::string c_array(const std::string& name, const std::vector<double>& values) {
  constexpr std::size_t per_line = 5;
  std::string text = "static const double " + name + "[] = {";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i == 0 ? "" : ",") + std::string(i % per_line == 0 ? "\n    " : " ");
    text += config::plain_number(values[i]);
  }
  return text + "};\n";
}

// In four sums, as model/simulation/linear_model.cpp adds: a wheel that stands at the very edge of sticking
// then does the same in both.
std::string c_core(const LinearModel& linear_part) {
  const Wheel left(linear_part.left);
  const Wheel right(linear_part.right);
  const std::size_t history = std::max<std::size_t>({1, left.longest(), right.longest()});
  return "enum { ww_history = " + std::to_string(history) +
         " }; /* periods that the linear part remembers */\n" + arrays_of("left", left) +
         arrays_of("right", right) + R"c(
/* Of rings of past values, `newest` is the place of the last one. */
typedef struct {
  double left_commands[ww_history], right_commands[ww_history];
  double left_speeds[ww_history], right_speeds[ww_history];
  int newest;
} ww_linear_state;

static inline void ww_linear_reset(ww_linear_state* s) {
  int i;
  for (i = 0; i < ww_history; ++i) {
    s->left_commands[i] = s->right_commands[i] = s->left_speeds[i] = s->right_speeds[i] = 0.0;
  }
  s->newest = 0;
}

static inline double ww_dot(const double* weights, int count, const double* ring, int newest) {
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  int i;
  for (i = 0; i < count; ++i) sums[i % 4] += weights[i] * ring[(newest + i) % ww_history];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

static inline ww_pair ww_linear_step(ww_linear_state* s, ww_pair command) {
  ww_pair speed;
)c" + speed_of("left", left) +
         speed_of("right", right) + R"c(  s->newest = (s->newest + ww_history - 1) % ww_history;
  s->left_commands[s->newest] = command.left;
  s->right_commands[s->newest] = command.right;
  s->left_speeds[s->newest] = speed.left;
  s->right_speeds[s->newest] = speed.right;
  return speed;
}
)c";
}

std::optional<std::string> c_core_inverse(const LinearModel& linear_part) {
  constexpr double least = 1e-9;
  const DcGain left = dc_gain(linear_part.left);
  const DcGain right = dc_gain(linear_part.right);
  const double determinant = left.from_left * right.from_right - left.from_right * right.from_left;
  if (!(std::abs(determinant) > least)) return std::nullopt;
  const auto term = [determinant](double gain) {
    return "(" + config::plain_number(gain / determinant) + ")";
  };
  return "/* The commands that make the linear part settle at these speeds. */\n"
         "static inline ww_pair ww_linear_undo(ww_pair speed) {\n  ww_pair command;\n"
         "  command.left = " +
         term(right.from_right) + " * speed.left + " + term(-left.from_right) +
         " * speed.right;\n"
         "  command.right = " +
         term(-right.from_left) + " * speed.left + " + term(left.from_left) +
         " * speed.right;\n  return command;\n}\n";
}

}  // namespace wheelwright::tools
