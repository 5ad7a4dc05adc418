#include "model/gap/error_sources/error_sources.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <map>
#include <numbers>
#include <sstream>

#include "model/gap/runs/short_name.hpp"
#include "model/statistics/order_statistics.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

// One moment of a run as a regime looks at it.
struct Moment {
  std::size_t run = 0;
  double gap = 0.0;
  double time_s = 0.0;
  double since_reversal_s = 0.0;
  double command = 0.0;       // largest of both wheels
  double min_command = 0.0;   // of the wheels that are told to move
  double speed = 0.0;         // of the body, signed
  double acceleration = 0.0;  // of the wheel that changes the most, along its motion
  double turn_rate = 0.0;
  double battery_v = 0.0;
  Pose pose;
  bool place_known = false;  // by references, not only by the model
};

std::string number(double value) {
  return in_digits(value, 2);
}

std::vector<std::vector<Moment>> moments_of(const FitProblem& problem, const TrialModel& model) {
  std::vector<std::vector<Moment>> all;
  for (std::size_t r = 0; r < problem.runs().size(); ++r) {
    const GapRun& run = problem.runs()[r];
    const auto states = model_states(model, run);
    std::vector<Moment> moments;
    double last_reversal = -10.0;
    double direction = 0.0;
    std::size_t reference = 0;
    for (std::size_t k = 0; k < states.size(); ++k) {
      Moment m;
      m.run = r;
      m.time_s = run.period_s * static_cast<double>(k);
      const WheelPair& u = run.commands_m_s[k];
      m.command = std::max(std::abs(u.left), std::abs(u.right));
      const double l = u.left == 0.0 ? 1e9 : std::abs(u.left);
      const double s = u.right == 0.0 ? 1e9 : std::abs(u.right);
      m.min_command = std::min(l, s) > 1e8 ? 0.0 : std::min(l, s);
      m.speed = states[k].twist.v_m_s;
      m.turn_rate = states[k].twist.w_rad_s;
      if (k > 0) {
        const auto along = [&](double now, double before) {
          return (std::abs(now) - std::abs(before)) / run.period_s;
        };
        const double left = along(states[k].wheel_m_s.left, states[k - 1].wheel_m_s.left);
        const double right = along(states[k].wheel_m_s.right, states[k - 1].wheel_m_s.right);
        m.acceleration = std::abs(left) > std::abs(right) ? left : right;
      }
      if (std::abs(m.speed) > 0.01) {
        if (direction * m.speed < 0.0) last_reversal = m.time_s;
        direction = m.speed;
      }
      m.since_reversal_s = m.time_s - last_reversal;
      m.battery_v = run.battery_v[k];
      while (reference + 1 < run.references.size() && run.references[reference + 1].at.period <= k)
        ++reference;
      m.pose = states[k].pose;
      if (!run.references.empty()) {
        m.place_known = !run.heading_alone;
        if (m.place_known) m.pose = run.references[reference].pose;
        m.pose.theta_rad = run.references[reference].pose.theta_rad;
      }
      moments.push_back(m);
    }
    all.push_back(std::move(moments));
  }
  return all;
}

struct Cell {
  std::string name;
  std::function<bool(const Moment&)> holds;
};

void add_quantiles(std::vector<Cell>& cells, const std::vector<Moment>& moments, const std::string& name,
                   const std::string& unit, const std::function<double(const Moment&)>& value) {
  constexpr double negligible = 1e-3;  // of the largest: what has all but settled
  double largest = 0.0;
  for (const auto& moment : moments) largest = std::max(largest, value(moment));  // not-a-number: unknown
  const double least = negligible * largest;
  std::vector<double> values;
  for (const auto& moment : moments) {
    if (value(moment) > least) values.push_back(value(moment));
  }
  if (values.size() < 50) return;
  for (const double share : {0.5, 0.8}) {
    const double limit = quantile(values, share);
    cells.push_back({name + " > " + number(limit) + unit, [=](const Moment& m) { return value(m) > limit; }});
  }
  const double low = quantile(values, 0.25);
  cells.push_back({name + " < " + number(low) + unit,
                   [=](const Moment& m) { return value(m) > least && value(m) < low; }});
}

std::vector<Cell> cells_for(const FitProblem& problem, const std::vector<Moment>& moments) {
  std::vector<Cell> cells;
  add_quantiles(cells, moments, "|command|", " m/s", [](const Moment& m) { return m.command; });
  add_quantiles(cells, moments, "smaller |command|", " m/s", [](const Moment& m) { return m.min_command; });
  add_quantiles(cells, moments, "|turn rate|", " rad/s",
                [](const Moment& m) { return std::abs(m.turn_rate); });
  add_quantiles(cells, moments, "speeding up by", " m/s^2", [](const Moment& m) { return m.acceleration; });
  add_quantiles(cells, moments, "slowing down by", " m/s^2", [](const Moment& m) { return -m.acceleration; });
  add_quantiles(cells, moments, "time since start", " s", [](const Moment& m) { return m.time_s; });
  add_quantiles(cells, moments, "battery", " V", [](const Moment& m) { return m.battery_v; });
  cells.push_back({"driving forward", [](const Moment& m) { return m.speed > 0.01; }});
  cells.push_back({"driving backward", [](const Moment& m) { return m.speed < -0.01; }});
  cells.push_back({"turning on the spot",
                   [](const Moment& m) { return std::abs(m.speed) < 0.02 && std::abs(m.turn_rate) > 0.1; }});
  cells.push_back({"within 0.5 s of a reversal", [](const Moment& m) { return m.since_reversal_s < 0.5; }});
  constexpr std::array headings{"heading along x", "heading along y", "heading against x",
                                "heading against y"};
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double middle = 0.5 * std::numbers::pi * static_cast<double>(i);
    cells.push_back({headings[i], [=](const Moment& m) {
                       return std::abs(m.speed) > 0.01 &&
                              std::abs(wrap_angle(m.pose.theta_rad - middle)) < 0.25 * std::numbers::pi;
                     }});
  }
  std::map<std::pair<int, int>, int> visits;
  for (const auto& m : moments) {
    if (!m.place_known) continue;
    ++visits[{static_cast<int>(std::floor(2.0 * m.pose.x_m)),
              static_cast<int>(std::floor(2.0 * m.pose.y_m))}];
  }
  for (const auto& [tile, count] : visits) {
    if (visits.size() > 60 || count < 100) continue;
    cells.push_back({"x " + number(0.5 * tile.first) + " to " + number(0.5 * tile.first + 0.5) + " m, y " +
                         number(0.5 * tile.second) + " to " + number(0.5 * tile.second + 0.5) + " m",
                     [tile = tile](const Moment& m) {
                       return static_cast<int>(std::floor(2.0 * m.pose.x_m)) == tile.first &&
                              static_cast<int>(std::floor(2.0 * m.pose.y_m)) == tile.second;
                     }});
  }
  if (problem.runs().size() > 1) {
    for (std::size_t r = 0; r < problem.runs().size(); ++r) {
      cells.push_back({"run " + short_name(r, problem.runs()), [r](const Moment& m) { return m.run == r; }});
    }
  }
  return cells;
}

}  // namespace

std::vector<Regime> regimes(const FitProblem& problem, const TrialModel& model,
                            std::span<const double> before, std::span<const double> after, std::size_t most) {
  auto runs = moments_of(problem, model);
  const auto& indices = problem.indices();
  for (std::size_t i = 0; i < before.size(); ++i) {
    auto& run = runs[indices[i].run];
    if (run.empty()) continue;
    // An error shows a little after its cause: a reading tells of the motion before it.
    const std::size_t k = std::min(indices[i].period > 0 ? indices[i].period - 1 : 0, run.size() - 1);
    run[k].gap += before[i] * before[i] - (after.empty() ? 1.0 : after[i] * after[i]);
  }
  std::vector<Moment> moments;
  for (auto& run : runs) moments.insert(moments.end(), run.begin(), run.end());
  double whole = 0.0;
  for (const auto& moment : moments) whole += moment.gap;
  if (!(whole > 0.0)) return {};
  std::vector<Regime> found;
  for (const auto& cell : cells_for(problem, moments)) {
    Regime regime{cell.name, 0.0, 0.0};
    for (const auto& moment : moments) {
      if (!cell.holds(moment)) continue;
      regime.share_of_gap += moment.gap / whole;
      regime.share_of_time += 1.0 / static_cast<double>(moments.size());
    }
    regime.share_of_gap = std::clamp(regime.share_of_gap, 0.0, 1.0);
    if (regime.share_of_gap > 1.15 * regime.share_of_time && regime.share_of_gap > 0.1)
      found.push_back(regime);
  }
  // A regime is telling where much of the gap falls into little of the time.
  std::ranges::sort(found, std::greater<>{}, [](const Regime& regime) {
    return regime.share_of_gap * std::log(regime.share_of_gap / std::max(regime.share_of_time, 1e-3));
  });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace wheelwright::gap
