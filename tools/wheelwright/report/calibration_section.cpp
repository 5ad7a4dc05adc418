#include "tools/wheelwright/report/calibration_section.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/calibration/turn_signal.hpp"
#include "model/statistics/confidence.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/number_text.hpp"
#include "tools/wheelwright/page/plot.hpp"
#include "tools/wheelwright/report/response_plots.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

constexpr double grid_ticks = 4.0;  // of the light-bumper signal, as the fit has it

// The sensors whose signals tell the most, strongest first.
std::vector<std::size_t> strongest_sensors(const TurnSignal& signal, std::size_t count) {
  std::array<double, TurnSignal::sensors> power{};
  for (const auto& entry : signal.values) {
    for (std::size_t s = 0; s < power.size(); ++s) power.at(s) += entry.at(s) * entry.at(s);
  }
  std::vector<std::size_t> order(power.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order,
                    [&](std::size_t one, std::size_t other) { return power.at(one) > power.at(other); });
  order.resize(count);
  return order;
}

Plot bumper_plot(const CalibrationMaterial& material) {
  Plot plot(
      "Light bumper over encoder ticks while the robot turns in place: the three strongest of six sensors. "
      "The signal repeats after one full turn, whatever the speed. Turning one way; the way back looks "
      "alike.");
  plot.axes("ticks of turning (half the difference of the wheels)", "reading, mean removed").height(320);
  constexpr std::array names{"left", "front left", "center left", "center right", "front right", "right"};
  constexpr std::array inks{Ink::accent, Ink::other, Ink::third};
  const TurnSignal signal = resample_turn(split_at_reversal(material.turn).first, grid_ticks);
  if (signal.values.size() < 2) return plot;
  const auto strongest = strongest_sensors(signal, inks.size());
  for (std::size_t i = 0; i < inks.size(); ++i) {
    PlotPoints points;
    for (std::size_t k = 0; k < signal.values.size(); ++k) {
      points.push_back({grid_ticks * static_cast<double>(k), signal.values[k].at(strongest[i])});
    }
    plot.line(names.at(strongest[i]), inks.at(i), thinned(points));
  }
  if (!material.scale) return plot;
  const double end = grid_ticks * static_cast<double>(signal.values.size());
  for (int turn = 1; turn * material.scale->ticks_per_turn < end; ++turn) {
    plot.mark(turn * material.scale->ticks_per_turn, turn == 1 ? "1 turn" : std::to_string(turn) + " turns");
  }
  return plot;
}

Plot match_plot(const EncoderScaleFit& scale) {
  Plot plot(
      "How well the six signals match themselves at a distance: 1 is a perfect repetition. The best match "
      "within what is plausible is one full turn.");
  plot.axes("distance [ticks]", "match").height(260);
  PlotPoints points;
  for (const auto& point : scale.curve) points.push_back({point.lag_ticks, point.correlation});
  plot.line("", Ink::accent, thinned(points));
  plot.mark(scale.ticks_per_turn, fixed_number(scale.ticks_per_turn, 1) + " ticks");
  return plot;
}

// What the two ways differ by beyond what they are known to.
std::string drift_sentence(const EncoderScaleFit& scale) {
  constexpr double worth_saying = 0.002;
  if (!scale.drift || std::abs(*scale.drift) < worth_saying) return "";
  return html::element("p", "One way a turn is " + fixed_number(200.0 * std::abs(*scale.drift), 2) +
                                " % longer than the other: the robot slides while it turns, as on a slope. "
                                "The mean of both is taken, in which this cancels.");
}

std::string fit_table(const FirFit& fit) {
  const auto row = [](const std::string& wheel, const WheelFit& quality, double own, double own_error,
                      double other, double other_error) {
    return std::vector<std::string>{
        wheel, fixed_number(own, 4) + " ± " + fixed_number(deviations_in_ci95 * own_error, 4),
        fixed_number(other, 4) + " ± " + fixed_number(deviations_in_ci95 * other_error, 4),
        fixed_number(1e3 * quality.position_noise_m, 2), fixed_number(1e3 * quality.drift_m_per_sqrt_s, 2)};
  };
  const WheelFit& left = fit.left;
  const WheelFit& right = fit.right;
  return html::table(
             {"wheel", "gain, own motor", "gain, other motor", "noise of a reading, mm", "drift, mm/√s"},
             {row("left", left, left.gain.from_left, left.gain_standard_error.from_left, left.gain.from_right,
                  left.gain_standard_error.from_right),
              row("right", right, right.gain.from_right, right.gain_standard_error.from_right,
                  right.gain.from_left, right.gain_standard_error.from_left)}) +
         "<p class=\"quiet\">Gain: m/s reached per m/s commanded, with its 95 % interval.</p>\n";
}

}  // namespace

std::string encoder_scale_section(const CalibrationMaterial& material) {
  if (material.turn.size() < 2) return "";
  std::string text = html::element("h2", "Calibration A: encoder scale");
  std::vector<Plot> plots{bumper_plot(material)};
  if (material.scale) {
    const EncoderScaleFit& scale = *material.scale;
    const double error = deviations_in_ci95 * scale.relative_standard_error;
    text += html::table(
        {"", "value", "95 %", "unit"},
        {{"metres per tick", fixed_number(1e3 * scale.metres_per_tick.left, 5),
          "± " + fixed_number(1e3 * error * scale.metres_per_tick.left, 5), "mm"},
         {"one full turn, each wheel", fixed_number(scale.ticks_per_turn, 1),
          "± " + fixed_number(error * scale.ticks_per_turn, 1), "ticks"},
         {"match of the signal with itself after one turn", fixed_number(scale.correlation, 3), "", "of 1"},
         {"recorded, both ways", fixed_number(scale.turns, 2), "", "turns"}});
    text += drift_sentence(scale);
    plots.push_back(match_plot(scale));
  }
  return text + figures_html(draw(plots));
}

std::string response_section(const CalibrationMaterial& material) {
  if (material.responses.empty()) return "";
  std::string text = html::element("h2", "Calibration B: responses");
  if (!material.fir) return text;
  text += fit_table(*material.fir);
  return text + figures_html(draw(response_plots(material.fir->model, material.responses)));
}

std::string model_section(const RobotModel& model) {
  return html::element("h2", "The model") + figures_html(draw(response_plots(model.linear_part, {})));
}

}  // namespace wheelwright::tools
