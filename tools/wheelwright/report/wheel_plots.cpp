#include "tools/wheelwright/report/wheel_plots.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wheelwright::tools {
namespace {

constexpr double speed_window_s = 0.1;

double of(const WheelPair& pair, Side side) {
  return side == Side::left ? pair.left : pair.right;
}

double travel_m(const DriveLog& log, const WheelTicks& ticks, Side side) {
  return side == Side::left ? static_cast<double>(ticks.left) * log.metres_per_tick->left
                            : static_cast<double>(ticks.right) * log.metres_per_tick->right;
}

// Mean speed over a window around each row, from counts.
PlotPoints measured_speed(const DriveLog& log, Side side, double end_s) {
  PlotPoints points;
  std::size_t first = 0;
  for (std::size_t last = 0; last < log.samples.size() && log.samples[last].t_s <= end_s; ++last) {
    if (!log.samples[last].ticks) continue;
    while (first < last &&
           (!log.samples[first].ticks || log.samples[last].t_s - log.samples[first].t_s > speed_window_s)) {
      ++first;
    }
    const double dt = log.samples[last].t_s - log.samples[first].t_s;
    if (dt <= 0.0) continue;
    const double way =
        travel_m(log, *log.samples[last].ticks, side) - travel_m(log, *log.samples[first].ticks, side);
    points.push_back({0.5 * (log.samples[last].t_s + log.samples[first].t_s), way / dt});
  }
  return points;
}

Plot sequence_plot(const DriveLog& log, const std::vector<PredictedMotion>& motion, double longest_s,
                   Side side) {
  const std::string name = side == Side::left ? "Left" : "Right";
  Plot plot(name + " wheel: commanded speed" + (log.has_ticks() ? ", measured speed (mean over 0.1 s)" : "") +
            (motion.empty() ? "" : ", and the speed that the model predicts from the commands alone"));
  plot.axes("time [s]", "speed [m/s]").height(280);
  const double end_s = log.samples.front().t_s + longest_s;
  PlotPoints commands;
  PlotPoints predicted;
  for (std::size_t k = 0; k < log.samples.size() && log.samples[k].t_s <= end_s; ++k) {
    commands.push_back({log.samples[k].t_s, of(log.samples[k].command_m_s, side)});
    if (k < motion.size()) predicted.push_back({motion[k].t_s, of(motion[k].speed_m_s, side)});
  }
  plot.line("command", Ink::quiet, thinned(commands));
  if (log.has_ticks()) plot.line("measured", Ink::text, thinned(measured_speed(log, side, end_s)));
  if (!motion.empty()) plot.line("model", Ink::accent, thinned(predicted));
  return plot;
}

}  // namespace

std::vector<Plot> sequence_plots(const DriveLog& log, const std::vector<PredictedMotion>& motion,
                                 double longest_s) {
  return {sequence_plot(log, motion, longest_s, Side::left),
          sequence_plot(log, motion, longest_s, Side::right)};
}

Plot travel_error_plot(const DriveLog& log, std::span<const DrawnRun> runs) {
  Plot plot(log.name + ": predicted minus measured travel of each wheel (solid: left, dashed: right)");
  plot.axes("time [s]", "error of travel [mm]").height(280);
  const auto begin =
      std::ranges::find_if(log.samples, [](const DriveSample& sample) { return sample.ticks.has_value(); });
  const auto start = static_cast<std::size_t>(begin - log.samples.begin());
  for (const DrawnRun& run : runs) {
    for (const Side side : {Side::left, Side::right}) {
      PlotPoints points;
      for (std::size_t i = start; i < log.samples.size(); ++i) {
        if (!log.samples[i].ticks) continue;
        const double measured =
            travel_m(log, *log.samples[i].ticks, side) - travel_m(log, *begin->ticks, side);
        const double predicted =
            of((*run.motion)[i].distance_m, side) - of((*run.motion)[start].distance_m, side);
        points.push_back({log.samples[i].t_s, 1e3 * (predicted - measured)});
      }
      const bool left = side == Side::left;
      plot.line(left ? run.name : "", run.ink, thinned(points), left ? 1 : 2);
    }
  }
  return plot;
}

Plot path_plot(const DriveLog& log, std::span<const DrawnRun> runs) {
  Plot plot(log.name + (runs.empty() ? ": measured path on the floor"
                                     : ": path on the floor by the model, beside the measured one"));
  plot.axes("x [m]", "y [m]").height(480).equal_scales();
  const std::size_t stride = std::max<std::size_t>(1, log.samples.size() / 1500);
  PlotPoints reference;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    const auto& sample = log.samples[i];
    const bool measured = sample.reference_x_m && sample.reference_y_m;
    if (measured && (i % stride == 0 || i + 1 == log.samples.size())) {
      reference.push_back({*sample.reference_x_m, *sample.reference_y_m});
    }
  }
  plot.dotted_line("measured", Ink::text, reference);
  for (const DrawnRun& run : runs) {
    PlotPoints points;
    for (std::size_t i = 0; i < run.motion->size(); i += stride) {
      points.push_back({(*run.motion)[i].pose.x_m, (*run.motion)[i].pose.y_m});
    }
    plot.line(run.name, run.ink, points);
  }
  return plot;
}

// From one heading to the next, errors are taken to change by less than half a turn.
Plot heading_error_plot(const DriveLog& log, std::span<const DrawnRun> runs) {
  Plot plot(log.name + ": predicted minus measured heading");
  plot.axes("time [s]", "error of heading [mrad]").height(280);
  for (const DrawnRun& run : runs) {
    PlotPoints points;
    std::optional<double> first_rad;
    double error_rad = 0.0;
    for (std::size_t i = 0; i < log.samples.size(); ++i) {
      const auto& measured_rad = log.samples[i].reference_theta_rad;
      if (!measured_rad) continue;
      const double apart_rad = (*run.motion)[i].pose.theta_rad - *measured_rad;
      if (!first_rad) first_rad = apart_rad;
      error_rad += wrap_angle(apart_rad - *first_rad - error_rad);
      points.push_back({log.samples[i].t_s, 1e3 * error_rad});
    }
    plot.line(run.name, run.ink, thinned(points));
  }
  return plot;
}

bool has_headings(const DriveLog& log) {
  constexpr int enough_for_a_line = 10;
  return std::ranges::count_if(log.samples, [](const DriveSample& sample) {
           return sample.reference_theta_rad.has_value();
         }) >= enough_for_a_line;
}

bool has_path(const DriveLog& log) {
  return std::ranges::count_if(
             log.samples, [](const DriveSample& sample) { return sample.reference_pose().has_value(); }) >= 2;
}

}  // namespace wheelwright::tools
