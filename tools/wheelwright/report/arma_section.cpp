#include <algorithm>
#include <array>
#include <cmath>

#include "model/prediction/free_run.hpp"
#include "model/prediction/score.hpp"
#include "model/simulation/poles.hpp"
#include "model/statistics/confidence.hpp"
#include "tools/wheelwright/page/html.hpp"
#include "tools/wheelwright/page/number_text.hpp"
#include "tools/wheelwright/page/plot.hpp"
#include "tools/wheelwright/report/calibration_section.hpp"
#include "tools/wheelwright/report/wheel_plots.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;
using Rows = std::vector<std::vector<std::string>>;

constexpr double shown_sequence_s = 15.0;

std::string with_interval(const std::vector<double>& values, const std::vector<double>& errors,
                          std::size_t i) {
  if (i >= values.size()) return "";
  const std::string text = fixed_number(values[i], 4);
  return i < errors.size() ? text + " ± " + fixed_number(deviations_in_ci95 * errors[i], 4) : text;
}

// As the paper's Table I, for both wheels. i counts periods into the past.
std::string weight_table(const ArmaFit& fit) {
  const auto& left = fit.model.left;
  const auto& right = fit.model.right;
  Rows rows;
  for (std::size_t i = 0; i < left.from_left.size(); ++i) {
    const auto past = [i](const WheelResponse& values, const WheelResponse& errors) {
      return i == 0 ? std::string() : with_interval(values.from_own_past, errors.from_own_past, i - 1);
    };
    rows.push_back({std::to_string(i), past(left, fit.left.standard_errors),
                    with_interval(left.from_left, fit.left.standard_errors.from_left, i),
                    past(right, fit.right.standard_errors),
                    with_interval(right.from_right, fit.right.standard_errors.from_right, i)});
  }
  return html::table({"i", "left: own past", "left: left command", "right: own past", "right: right command"},
                     rows) +
         "<p class=\"quiet\">Weights of eq. (12) with 95 % intervals; i counts periods back, its own past "
         "from 1 "
         "on. Weights of the other motor's command are left out of the table.</p>\n";
}

PlotPoints weights(const std::vector<double>& values, const std::vector<double>& errors, std::size_t first,
                   double beside) {
  PlotPoints points;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double error = i < errors.size() ? deviations_in_ci95 * errors[i] : 0.0;
    points.push_back({static_cast<double>(i + first) + beside, values[i], error});
  }
  return points;
}

std::vector<Plot> weight_plots(const ArmaFit& fit) {
  Plot commands("Weights of the wheel's own command, with 95 % intervals.");
  Plot past("Weights of the wheel's own past speed, with 95 % intervals.");
  commands.axes("periods ago", "weight").half();
  past.axes("periods ago", "weight").half();
  constexpr double apart = 0.12;
  const auto& left = fit.left.standard_errors;
  const auto& right = fit.right.standard_errors;
  commands.error_bars("left wheel", Ink::accent,
                      weights(fit.model.left.from_left, left.from_left, 0, -apart));
  commands.error_bars("right wheel", Ink::other,
                      weights(fit.model.right.from_right, right.from_right, 0, apart));
  past.error_bars("left wheel", Ink::accent,
                  weights(fit.model.left.from_own_past, left.from_own_past, 1, -apart));
  past.error_bars("right wheel", Ink::other,
                  weights(fit.model.right.from_own_past, right.from_own_past, 1, apart));
  return {commands, past};
}

PlotPoints pole_points(const WheelResponse& wheel) {
  PlotPoints points;
  for (const auto& pole : poles(wheel)) points.push_back({pole.real(), pole.imag()});
  return points;
}

Plot pole_plot(const LinearModel& model) {
  Plot plot("Poles: inside the circle is stable, near its middle is quick.");
  plot.axes("real part", "imaginary part").half().height(400).equal_scales();
  plot.circle(0.0, 0.0, 1.0);
  plot.line("", Ink::quiet, {{-1.1, 0.0}, {1.1, 0.0}});
  plot.line("", Ink::quiet, {{0.0, -1.1}, {0.0, 1.1}});
  plot.points("left wheel", Ink::accent, pole_points(model.left), 0.8);
  plot.points("right wheel", Ink::other, pole_points(model.right), 0.8);
  return plot;
}

std::optional<OrderSweep> swept(const DriveLog& run) {
  ArmaFitOptions options;
  options.period_s = run.period_s;
  auto fit = fit_arma(std::span(&run, 1), options);
  return fit ? fit->sweep : std::nullopt;
}

}  // namespace

// A model's order may be given by the configuration, and then is not what the sweep would have chosen.
Plot order_plot(const OrderSweep& sweep, std::size_t model_order) {
  const bool is_given = sweep.chosen != model_order;
  Plot plot(std::string("Which order: error of the free run on data that the fit has not seen, with one "
                        "standard error. ") +
            (is_given ? "The model's order was given; 'auto' would take the smallest one"
                      : "Chosen is the smallest order") +
            " within one standard error of the best.");
  plot.axes("order", "held-out error of travel [mm]").half().height(400).from_zero();
  PlotPoints points;
  for (const auto& row : sweep.rows) {
    if (row.refusal) continue;
    points.push_back(
        {static_cast<double>(row.order), 1e3 * row.held_out_distance_rms_m, 1e3 * row.standard_error_m});
  }
  plot.line("", Ink::quiet, points);
  plot.error_bars("", Ink::accent, points);
  const std::string chosen = std::to_string(sweep.chosen);
  plot.mark(static_cast<double>(model_order),
            is_given ? "given: " + std::to_string(model_order) : "chosen: " + chosen);
  if (is_given) plot.mark(static_cast<double>(sweep.chosen), "auto: " + chosen, 0.88);
  return plot;
}

std::string arma_section(const CalibrationMaterial& material, bool sweep) {
  if (material.random.samples.empty()) return "";
  std::string text = html::element("h2", "Calibration C: random drive, ARMA model");
  if (!material.arma) return text;
  const ArmaFit& fit = *material.arma;
  const auto motion = free_run(fit.model, material.random);
  const Score score = score_run(motion, material.random);
  text += html::element(
      "p", "Order " + std::to_string(fit.model.left.from_own_past.size()) + ", largest pole " +
               fixed_number(std::max(fit.left.largest_pole, fit.right.largest_pole), 3) +
               ", free run over the whole " + "drive " +
               fixed_number(1e3 * score.distance_rms_m.value_or(0.0), 2) + " mm RMS off the encoders.");
  std::vector<Plot> plots = sequence_plots(material.random, motion, shown_sequence_s);
  const std::array drawn{DrawnRun{"model", Ink::accent, &motion}};
  plots.push_back(travel_error_plot(material.random, drawn));
  for (auto& plot : weight_plots(fit)) plots.push_back(std::move(plot));
  plots.push_back(pole_plot(fit.model));
  const auto orders = fit.sweep ? fit.sweep : sweep ? swept(material.random) : std::nullopt;
  if (orders) plots.push_back(order_plot(*orders, fit.model.left.from_own_past.size()));
  text += figures_html(draw(plots));
  if (!orders) {
    text += html::element("p", "The picture of orders takes some seconds: wheelwright report --orders.");
  }
  return text + "<details><summary>All weights</summary>" + weight_table(fit) + "</details>\n";
}

}  // namespace wheelwright::tools
