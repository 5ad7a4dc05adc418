#include "model/gap/data_gate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include "model/command_timeline.hpp"
#include "model/identification/known_stretches.hpp"

namespace wheelwright::gap {
namespace {

constexpr double impossible_command_m_s = 3.0;  // no wheel that is counted in these logs goes that fast
constexpr double garbage_over_usual = 4.0;      // a few commands so far above all others are garbage
constexpr std::size_t few_rows = 3;
constexpr double impossible_speed_m_s = 2.0;  // of a wheel or the body between two rows
constexpr double shortest_freeze_s = 0.05;
constexpr double expected_counts_in_freeze = 10.0;
constexpr double surely_turning_m_s = 0.05;  // a slower wheel may stick
constexpr double window_s = 0.5;
constexpr double forgetting_s = 1.0;  // until a command from before is of no consequence

std::string number(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

class Gate {
 public:
  explicit Gate(const DriveLog& log) : result_{log, {}, {}, {}} {}

  GatedLog run() {
    remove_garbage_commands();
    const std::size_t rows = result_.log.samples.size();
    result_.flags = {std::vector<char>(rows, 0), std::vector<char>(rows, 0)};
    if (result_.log.has_ticks()) {
      leave_out_holes();
      find_jumps();
      find_dropouts();
      check_sides_and_signs();
    }
    remove_reference_jumps();
    check_reference();
    return std::move(result_);
  }

 private:
  std::size_t line(std::size_t row) const {
    return lines_.empty() ? result_.log.first_line + row : lines_[row];
  }
  void fault(std::size_t row, const std::string& what, bool explains = false) {
    result_.faults.push_back({result_.log.name, line(row), what, false, explains});
  }

  void remove_garbage_commands();
  void leave_out_holes();
  void find_jumps();
  void find_dropouts();
  void find_dropouts_of(bool left);
  struct Gains;
  std::optional<Gains> gains(const CommandTimeline& commands, double delay_s) const;
  void check_sides_and_signs();
  void remove_reference_jumps();
  void check_reference();
  double travel(std::size_t row, bool left) const {
    const DriveSample& sample = result_.log.samples[row];
    return left ? static_cast<double>(sample.ticks->left) * result_.log.metres_per_tick->left
                : static_cast<double>(sample.ticks->right) * result_.log.metres_per_tick->right;
  }

  GatedLog result_;
  std::vector<std::size_t> lines_;  // of the rows that are left
};

double size_of(const WheelPair& command) {
  return std::max(std::abs(command.left), std::abs(command.right));
}

void Gate::remove_garbage_commands() {
  auto& samples = result_.log.samples;
  std::vector<double> sizes;
  sizes.reserve(samples.size());
  for (const auto& sample : samples) sizes.push_back(size_of(sample.command_m_s));
  std::ranges::sort(sizes);
  const double usual = sizes[sizes.size() * 98 / 100];
  const double limit =
      usual > 0.0 ? std::min(impossible_command_m_s, garbage_over_usual * usual) : impossible_command_m_s;
  const auto above =
      static_cast<std::size_t>(std::ranges::count_if(sizes, [&](double size) { return size > limit; }));
  if (above == 0) return;
  if (above > few_rows) {
    if (usual > impossible_command_m_s) {
      fault(0,
            "commands are up to " + number(sizes.back(), 3) + " m/s; are they in mm/s? the format wants m/s",
            true);
    }
    return;
  }
  std::vector<DriveSample> kept;
  std::vector<std::size_t> lines;  // not yet lines_: faults are still told by the rows as they were
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (size_of(samples[i].command_m_s) > limit) {
      fault(i, "a command of " + number(size_of(samples[i].command_m_s), 4) +
                   " m/s where no other is above " + number(usual, 3) + " m/s; the row was left out");
      result_.faults.back().distorts = true;
    } else {
      kept.push_back(samples[i]);
      lines.push_back(result_.log.first_line + i);
    }
  }
  for (auto& column : result_.log.extra_columns) column = {column.name, {}, {}};
  samples = std::move(kept);
  lines_ = std::move(lines);
}

// The robot went on, with commands that no row tells: what it does until they are forgotten is no model's
// fault.
void Gate::leave_out_holes() {
  const auto& samples = result_.log.samples;
  for (const auto& hole : find_holes(result_.log)) {
    fault(hole.row,
          "no rows for " + number(hole.duration_s, 4) + " s; the first second behind them was left out");
    const double known_s = samples[hole.row].t_s + forgetting_s;
    for (std::size_t i = hole.row; i < samples.size() && samples[i].t_s < known_s; ++i) {
      result_.flags.counts[i] = 1;
      result_.flags.restart[i] = 1;
    }
  }
}

void Gate::find_jumps() {
  const auto& samples = result_.log.samples;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!samples[i].ticks || !samples[i - 1].ticks) continue;
    const double duration = samples[i].t_s - samples[i - 1].t_s;
    for (const bool left : {true, false}) {
      const double jump = travel(i, left) - travel(i - 1, left);
      if (std::abs(jump) <= impossible_speed_m_s * duration + 0.01) continue;
      result_.flags.restart[i] = 1;
      const auto ticks = left ? samples[i].ticks->left - samples[i - 1].ticks->left
                              : samples[i].ticks->right - samples[i - 1].ticks->right;
      fault(i, std::string(left ? "ticks_left" : "ticks_right") + " jumps by " + std::to_string(ticks) +
                   " in " + number(duration, 3) + " s" +
                   (std::abs(std::abs(static_cast<double>(ticks)) - 65536.0) < 2000.0
                        ? " (a 16-bit counter that was not unwrapped?)"
                        : "") +
                   "; the counts were taken up again behind it");
    }
  }
}

void Gate::find_dropouts() {
  const auto& samples = result_.log.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {  // no counts at all
    if (samples[i].ticks) continue;
    std::size_t end = i;
    while (end < samples.size() && !samples[end].ticks) ++end;
    const double duration = samples[std::min(end, samples.size() - 1)].t_s - samples[i].t_s;
    result_.dropouts.push_back({samples[i].t_s, duration});
    fault(i, "no counts for " + number(duration, 3) + " s; the rows were left out");
    i = end;
  }
  find_dropouts_of(true);
  find_dropouts_of(false);
}

// Counts of one wheel that stand still between two moments at which the wheel surely turned.
void Gate::find_dropouts_of(bool left) {
  const auto& samples = result_.log.samples;
  const double tick = left ? result_.log.metres_per_tick->left : result_.log.metres_per_tick->right;
  const auto speed = [&](std::size_t from, std::size_t to) {
    return (travel(to, left) - travel(from, left)) / (samples[to].t_s - samples[from].t_s);
  };
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    if (!samples[i].ticks || !samples[i - 1].ticks || travel(i, left) != travel(i - 1, left)) continue;
    std::size_t end = i;
    while (end + 1 < samples.size() && samples[end + 1].ticks && travel(end + 1, left) == travel(i, left))
      ++end;
    const std::size_t first = i - 1;
    i = end;
    const double duration = samples[end].t_s - samples[first].t_s;
    if (duration < shortest_freeze_s || first < 3 || end + 4 >= samples.size()) continue;
    if (!samples[first - 3].ticks || !samples[end + 4].ticks) continue;
    const double before = speed(first - 3, first);
    // What comes with the first reading behind the freeze may be all that was held back.
    const double after = speed(end + 1, end + 4);
    // A wheel that stops by itself slows down first, and speeds up afterwards; counts that are lost do not.
    const double last = speed(first - 1, first);
    const double next = speed(end + 1, end + 2);
    const double least =
        std::min({std::abs(before), std::abs(after), std::abs(last) / 0.6, std::abs(next) / 0.6});
    if (last * before <= 0.0 || next * before <= 0.0) continue;
    if (before * after <= 0.0 || least < surely_turning_m_s ||
        least * duration < expected_counts_in_freeze * tick)
      continue;
    // A wheel that was told to stand may have stood.
    bool told_to_stand = false;
    for (std::size_t k = first > 20 ? first - 20 : 0; k <= end; ++k) {
      const double command = left ? samples[k].command_m_s.left : samples[k].command_m_s.right;
      if (command * before <= 0.0 || std::abs(command) < 0.25 * std::abs(before)) told_to_stand = true;
    }
    if (told_to_stand) continue;
    for (std::size_t k = first + 1; k <= end; ++k) result_.flags.counts[k] = 1;
    result_.dropouts.push_back({samples[first].t_s, duration});
    fault(first + 1, std::string(left ? "ticks_left" : "ticks_right") + " stand still for " +
                         number(duration, 3) + " s while the wheel turns; the rows were left out");
  }
}

// Commands against travel over windows of half a second: gains of each counter from each command, with the
// commands taken `delay_s` earlier.
struct Gate::Gains {
  double left_own = 0.0;
  double left_other = 0.0;
  double right_own = 0.0;
  double right_other = 0.0;
  double explained = 0.0;  // sum of squares of the travel
};

std::optional<Gate::Gains> Gate::gains(const CommandTimeline& commands, double delay_s) const {
  const auto& samples = result_.log.samples;
  Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d travels = Eigen::Matrix2d::Zero();  // one column per counter
  std::size_t from = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double duration = samples[i].t_s - samples[from].t_s;
    if (duration < window_s) continue;
    if (samples[from].ticks && samples[i].ticks && samples[from].t_s >= delay_s + samples[0].t_s) {
      const Eigen::Vector2d moved(travel(i, true) - travel(from, true),
                                  travel(i, false) - travel(from, false));
      const WheelPair mean = commands.mean_m_s(samples[from].t_s - delay_s, samples[i].t_s - delay_s);
      const Eigen::Vector2d commanded = duration * Eigen::Vector2d(mean.left, mean.right);
      if (moved.cwiseAbs().maxCoeff() < impossible_speed_m_s * window_s) {
        products += commanded * commanded.transpose();
        travels += commanded * moved.transpose();
      }
    }
    from = i;
  }
  const double left = products(0, 0);
  const double right = products(1, 1);
  if (!(products.determinant() > 0.02 * left * right) || left < 1e-4 || right < 1e-4) return std::nullopt;
  const Eigen::Matrix2d gains = products.inverse() * travels;
  return Gains{gains(0, 0), gains(1, 0), gains(1, 1), gains(0, 1), gains.cwiseProduct(travels).sum()};
}

void Gate::check_sides_and_signs() {
  // A slow answer is an effect, not a fault: judged with the delay that explains most.
  const CommandTimeline commands(result_.log);
  std::optional<Gains> best;
  for (const double delay_s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto found = gains(commands, delay_s);
    if (found && (!best || found->explained > 1.1 * best->explained)) best = found;
  }
  if (!best) return;
  if (best->left_other > 0.5 && best->right_other > 0.5 &&
      std::abs(best->left_own) < 0.3 * best->left_other &&
      std::abs(best->right_own) < 0.3 * best->right_other) {
    fault(0, "ticks_left follows the right command and ticks_right the left one: the sides are swapped",
          true);
    return;
  }
  const auto check = [&](double gain, const std::string& name) {
    const std::string unit = ": check metres_per_tick and the unit of the commands";
    if (gain < -0.2) {
      fault(0, name + " counts against its command (gain " + number(gain, 3) + "): its sign is wrong", true);
    } else if (gain > 4.0) {
      fault(0, name + " gives " + number(gain, 3) + " times the commanded travel" + unit, true);
    } else if (gain >= 0.0 && gain < 0.15) {
      fault(0, name + " gives only " + number(gain, 2) + " of the commanded travel" + unit, true);
    }
  };
  check(best->left_own, "ticks_left");
  check(best->right_own, "ticks_right");
}

// A reference that leaps and comes back was never there.
void Gate::remove_reference_jumps() {
  auto& samples = result_.log.samples;
  std::optional<std::size_t> last;
  std::size_t in_a_row = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].reference_x_m || !samples[i].reference_y_m) continue;
    if (last) {
      const double duration = samples[i].t_s - samples[*last].t_s;
      const double moved = std::hypot(*samples[i].reference_x_m - *samples[*last].reference_x_m,
                                      *samples[i].reference_y_m - *samples[*last].reference_y_m);
      const double turned =
          samples[i].reference_theta_rad && samples[*last].reference_theta_rad
              ? std::abs(wrap_angle(*samples[i].reference_theta_rad - *samples[*last].reference_theta_rad))
              : 0.0;
      const bool impossible =
          moved > impossible_speed_m_s * duration + 0.05 || turned > 12.0 * duration + 0.3;
      if (impossible && in_a_row < 5) {
        if (in_a_row == 0) {
          fault(i, "the reference jumps by " + number(moved, 3) + " m and " + number(turned, 3) + " rad in " +
                       number(duration, 3) + " s; the row was left out");
        }
        ++in_a_row;
        samples[i].reference_x_m.reset();
        samples[i].reference_y_m.reset();
        samples[i].reference_theta_rad.reset();
        continue;
      }
    }
    in_a_row = 0;
    last = i;
  }
}

// The reference's turns and travel against what odometry (or, without counts, the commands) say.
void Gate::check_reference() {
  const DriveLog& log = result_.log;
  const auto& samples = log.samples;
  double ww = 0.0, wr = 0.0, vv = 0.0, vf = 0.0, vm = 0.0;
  std::optional<std::size_t> from;
  double forward = 0.0;
  double turn = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    if (from && i > 0) {
      const double duration = samples[i].t_s - samples[i - 1].t_s;
      double left = samples[i - 1].command_m_s.left * duration;
      double right = samples[i - 1].command_m_s.right * duration;
      if (log.has_ticks() && sample.ticks && samples[i - 1].ticks) {
        left = travel(i, true) - travel(i - 1, true);
        right = travel(i, false) - travel(i - 1, false);
      }
      forward += 0.5 * (left + right);
      turn += (right - left) / log.wheel_base_m;
    }
    if (!sample.reference_x_m || !sample.reference_y_m || !sample.reference_theta_rad) continue;
    if (from && sample.t_s - samples[*from].t_s < window_s) continue;
    if (from && sample.t_s - samples[*from].t_s < 3.0 * window_s) {
      const auto& before = samples[*from];
      const double turned = wrap_angle(*sample.reference_theta_rad - *before.reference_theta_rad);
      const double middle = *before.reference_theta_rad + 0.5 * turned;
      const double dx = *sample.reference_x_m - *before.reference_x_m;
      const double dy = *sample.reference_y_m - *before.reference_y_m;
      if (std::abs(turn) < 1.5) {
        ww += turn * turn;
        wr += turn * turned;
        vv += forward * forward;
        vf += forward * (dx * std::cos(middle) + dy * std::sin(middle));
        vm += forward * (dx * std::cos(middle) - dy * std::sin(middle));
      }
    }
    from = i;
    forward = turn = 0.0;
  }
  if (vv > 0.02) {
    const double gain = vf / vv;
    if (std::abs(gain) > 20.0) {
      fault(0,
            "the reference moves " + number(gain, 3) +
                " times as far as the wheels: is it in mm or cm? the format wants m",
            true);
    } else if (gain < -0.3) {
      fault(0,
            "the reference moves backward where the wheels roll forward: its heading is turned by half a "
            "turn, or the commands' sign is wrong",
            true);
    } else if (gain < 0.5 * vm / vv && vm / vv > 0.5) {
      fault(0,
            "the reference moves along its mirrored heading: x, y and heading do not belong to one "
            "right-handed frame",
            true);
    }
  }
  if (ww > 0.3) {
    const double gain = wr / ww;
    if (gain < -0.3) {
      fault(
          0,
          "the reference turns against the wheels: left and right, or the sign of the heading, are exchanged",
          true);
    }
  }
}

}  // namespace

GatedLog gate(const DriveLog& log) {
  return Gate(log).run();
}

}  // namespace wheelwright::gap
