#include "tools/wheelwright/report/run_section.hpp"

#include <algorithm>
#include <cmath>

#include "config/load/text_format.hpp"
#include "model/uncertainty/pose_uncertainty.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/plot.hpp"
#include "tools/wheelwright/report/true_path.hpp"
#include "tools/wheelwright/report/wheel_plots.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using Rows = std::vector<std::vector<std::string>>;
using Ticks = std::vector<mcap::TickValues>;

constexpr std::size_t max_events = 40;

Ticks route_of(const Ticks& ticks) {
  Ticks route;
  for (const auto& tick : ticks) {
    if (tick.state && tick.state->activity == "route") route.push_back(tick);
  }
  return route;
}

template <typename Pick>
PlotPoints path(const Ticks& ticks, Pick pick) {
  const std::size_t stride = std::max<std::size_t>(1, ticks.size() / 1500);
  PlotPoints points;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const std::optional<Pose>& pose = pick(ticks[i]);
    if (pose && (i % stride == 0 || i + 1 == ticks.size())) points.push_back({pose->x_m, pose->y_m});
  }
  return points;
}

// What a recording holds of a covariance, as far as the position goes.
Eigen::Matrix3d position_covariance(const std::array<double, 6>& recorded) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() << recorded[0], recorded[1], recorded[1], recorded[2];
  return covariance;
}

// Of the position by the model alone where the drive ended; nothing where the model states no uncertainty.
PlotPoints end_ellipse(const Ticks& ticks) {
  if (ticks.empty() || !ticks.back().model || !ticks.back().model_covariance) return {};
  const Eigen::Matrix3d covariance = position_covariance(*ticks.back().model_covariance);
  if (covariance.isZero()) return {};
  PlotPoints points;
  for (const Pose& corner : ellipse95_outline(*ticks.back().model, covariance, 60))
    points.push_back({corner.x_m, corner.y_m});
  return points;
}

Plot poses_plot(const RunMaterial& run, const Ticks& ticks, const PlotPoints& truth) {
  const bool has_route = run.config && run.config->route;
  Plot plot(has_route ? "The route as each source of the pose has it; numbers are checkpoints."
                      : "Where the robot was, as each source of the pose has it.");
  plot.axes("x [m], forward at the start", "y [m], left at the start").height(500).equal_scales();
  const auto has_reference =
      std::ranges::any_of(ticks, [](const auto& tick) { return tick.reference.has_value(); });
  if (has_route) {
    PlotPoints checkpoints;
    int number = 0;
    for (const Checkpoint& point : run.config->route->checkpoints) {
      checkpoints.push_back({point.x_m, point.y_m});
      plot.label(point.x_m, point.y_m, std::to_string(++number));
    }
    plot.points("checkpoints", Ink::quiet, checkpoints, 0.8);
  }
  plot.line("odometry", Ink::other, path(ticks, [](const auto& tick) { return tick.odometry; }), 2);
  plot.line("hybrid", Ink::third, path(ticks, [](const auto& tick) { return tick.hybrid; }));
  plot.line("model", Ink::accent, path(ticks, [](const auto& tick) { return tick.model; }));
  if (has_reference)
    plot.line("reference", Ink::text, path(ticks, [](const auto& tick) { return tick.reference; }));
  plot.line("true path", Ink::text, truth);
  plot.line("model, 95 % ellipse of the end", Ink::accent, end_ellipse(ticks), 2);
  return plot;
}

// The mean over a window around each point: a period holds a handful of ticks, and sometimes two refreshes.
PlotPoints smoothed(const PlotPoints& points) {
  constexpr double half_window_s = 0.063;  // seven periods in all, in which a Roomba's refreshes even out
  PlotPoints result;
  std::size_t first = 0;
  std::size_t last = 0;
  double sum = 0.0;
  for (const PlotPoint& point : points) {
    for (; last < points.size() && points[last].x <= point.x + half_window_s; ++last) sum += points[last].y;
    for (; points[first].x < point.x - half_window_s; ++first) sum -= points[first].y;
    result.push_back({point.x, sum / static_cast<double>(last - first)});
  }
  return result;
}

Plot speed_plot(const Ticks& ticks, Side side) {
  const bool left = side == Side::left;
  Plot plot(std::string(left ? "Left" : "Right") +
            " wheel: commanded speed, measured by the encoder (mean over 0.13 s), and by the model.");
  plot.axes("time [s]", "speed [m/s]").height(260);
  const auto over_time = [&](auto pick) {
    PlotPoints points;
    for (const auto& tick : ticks) {
      const std::optional<WheelPair>& pair = pick(tick);
      if (pair) points.push_back({tick.t_s, left ? pair->left : pair->right});
    }
    return points;
  };
  const auto measured = over_time([](const auto& tick) { return tick.measured_m_s; });
  plot.line("measured", Ink::text, thinned(smoothed(measured)));
  plot.line("command", Ink::quiet, thinned(over_time([](const auto& tick) { return tick.command_m_s; })));
  plot.line("model", Ink::accent, thinned(over_time([](const auto& tick) { return tick.predicted_m_s; })));
  return plot;
}

// How far two poses are apart: 1e3 times metres or radians.
template <typename Distance>
PlotPoints apart(const Ticks& ticks, Distance distance) {
  PlotPoints points;
  for (const auto& tick : ticks) {
    if (const std::optional<double> value = distance(tick)) points.push_back({tick.t_s, 1e3 * *value});
  }
  return thinned(points);
}

std::optional<double> position_apart(const std::optional<Pose>& one, const std::optional<Pose>& other) {
  if (!one || !other) return std::nullopt;
  return distance_between_m(*one, *other);
}

std::optional<double> heading_apart(const std::optional<Pose>& one, const std::optional<Pose>& other) {
  if (!one || !other) return std::nullopt;
  return wrap_angle(one->theta_rad - other->theta_rad);
}

std::optional<double> radius95(const std::optional<std::array<double, 6>>& values) {
  if (!values) return std::nullopt;
  return position_radius95_m(position_covariance(*values));
}

std::vector<Plot> residual_plots(const Ticks& ticks) {
  Plot position(
      "Model against the encoders: distance between the pose from commands alone and the other sources. "
      "Dashed: how far off filter and model may be (95 %).");
  Plot heading("The same for the heading: model minus the other source.");
  position.axes("time [s]", "distance [mm]").height(260);
  heading.axes("time [s]", "heading [mrad]").height(260);
  position.line("odometry", Ink::other,
                apart(ticks, [](const auto& tick) { return position_apart(tick.model, tick.odometry); }));
  position.line("hybrid", Ink::third,
                apart(ticks, [](const auto& tick) { return position_apart(tick.model, tick.hybrid); }));
  position.line("", Ink::third, apart(ticks, [](const auto& tick) { return radius95(tick.covariance); }), 2);
  position.line("", Ink::accent,
                apart(ticks, [](const auto& tick) { return radius95(tick.model_covariance); }), 2);
  heading.line("odometry", Ink::other,
               apart(ticks, [](const auto& tick) { return heading_apart(tick.model, tick.odometry); }));
  heading.line("hybrid", Ink::third,
               apart(ticks, [](const auto& tick) { return heading_apart(tick.model, tick.hybrid); }));
  return {position, heading};
}

std::vector<Plot> power_plots(const Ticks& ticks) {
  Plot battery("Battery voltage.");
  Plot current("Motor currents.");
  battery.axes("time [s]", "voltage [V]").half();
  current.axes("time [s]", "current [A]").half();
  PlotPoints volts;
  PlotPoints left;
  PlotPoints right;
  for (const auto& tick : ticks) {
    if (!tick.sensors) continue;
    if (tick.sensors->battery_v) volts.push_back({tick.t_s, *tick.sensors->battery_v});
    if (!tick.sensors->motor_current_a) continue;
    left.push_back({tick.t_s, tick.sensors->motor_current_a->left});
    right.push_back({tick.t_s, tick.sensors->motor_current_a->right});
  }
  battery.line("", Ink::accent, thinned(volts));
  current.line("left", Ink::accent, thinned(left));
  current.line("right", Ink::other, thinned(right));
  return {battery, current};
}

// Calibration actions follow each other dozens of times: what repeats is one row.
std::string timeline(const Ticks& ticks) {
  Rows rows;
  std::string last;
  double since_s = 0.0;
  const auto kind = [](const std::string& activity) {
    const bool response = activity.starts_with("left_o") || activity.starts_with("right_o");
    return response ? std::string("response actions") : activity;
  };
  const auto close = [&](double now_s) {
    if (!last.empty()) rows.push_back({last, fixed_number(since_s, 2), fixed_number(now_s - since_s, 2)});
  };
  for (const auto& tick : ticks) {
    const std::string activity = tick.state ? kind(tick.state->activity) : "";
    if (activity == last) continue;
    close(tick.t_s);
    last = activity;
    since_s = tick.t_s;
  }
  if (!ticks.empty()) close(ticks.back().t_s);
  return rows.empty()
             ? ""
             : html::element("h3", "What it did") + html::table({"activity", "from [s]", "for [s]"}, rows);
}

std::string events(const Ticks& ticks) {
  Rows rows;
  std::string stop = "none";
  bool due = false;
  for (const auto& tick : ticks) {
    const std::string t = fixed_number(tick.t_s, 2);
    if (!tick.events.empty()) rows.push_back({t, tick.events});
    if (!tick.state) continue;
    if (!tick.state->stop.empty() && tick.state->stop != stop) {
      stop = tick.state->stop;
      if (stop != "none") rows.push_back({t, "stopped: " + stop});
    }
    if (tick.state->recalibration_due && !due)
      rows.push_back({t, "the model does not fit any more: calibrate again"});
    due = tick.state->recalibration_due;
  }
  std::string text = html::element("h3", "Events and faults");
  if (rows.empty()) return text + html::element("p", "None.");
  const std::size_t all = rows.size();
  rows.resize(std::min(all, max_events));
  text += html::table({"time [s]", "what"}, rows);
  if (all > max_events)
    text += html::element("p", "and " + std::to_string(all - max_events) + " more in the pose log");
  return text;
}

std::string end_row(const std::optional<Pose>& pose) {
  return pose ? fixed_number(std::hypot(pose->x_m, pose->y_m), 4) : "-";
}

std::string route_table(const RunMaterial& run, const Ticks& route, const std::optional<TruePath>& truth) {
  const mcap::TickValues& last = route.back();
  const auto source = run.metadata.find("pose_source");
  Rows rows;
  if (source != run.metadata.end()) rows.push_back({"steered by", source->second, ""});
  if (run.config && run.config->route) {
    rows.push_back({"checkpoints visited",
                    std::to_string(last.state->checkpoints_visited) + " of " +
                        std::to_string(run.config->route->checkpoints.size()),
                    ""});
  }
  rows.push_back({"from start to end, by the model", end_row(last.model), "m"});
  rows.push_back({"by odometry", end_row(last.odometry), "m"});
  if (last.hybrid) rows.push_back({"by the filter", end_row(last.hybrid), "m"});
  if (truth) rows.push_back({"truly", fixed_number(truth->closure_m, 4), "m"});
  return html::table({"the route", "", ""}, rows);
}

}  // namespace

std::string run_section(const RunMaterial& run, const std::optional<config::CsvTable>& truth) {
  const bool any_pose =
      std::ranges::any_of(run.ticks, [](const auto& tick) { return tick.model || tick.odometry; });
  if (!any_pose) return "";
  const Ticks route = route_of(run.ticks);
  const Ticks& shown = route.empty() ? run.ticks : route;
  const auto true_route = truth ? std::optional(true_path(*truth)) : std::nullopt;
  std::string text = html::element("h2", "The run");
  if (!route.empty()) text += route_table(run, route, true_route);
  std::vector<Plot> plots{poses_plot(run, shown, true_route ? true_route->points : PlotPoints{}),
                          speed_plot(shown, Side::left), speed_plot(shown, Side::right)};
  for (auto& plot : residual_plots(shown)) plots.push_back(std::move(plot));
  for (auto& plot : power_plots(run.ticks)) plots.push_back(std::move(plot));
  return text + figures_html(draw(plots)) + events(run.ticks) + timeline(run.ticks);
}

}  // namespace wheelwright::tools
