// The calibrations of a run, for a person: figures of the paper's calibrations A, B and C.
#pragma once

#include <string>

#include "tools/wheelwright/page/plot.hpp"
#include "tools/wheelwright/report/run_material.hpp"

namespace wheelwright::tools {

// Calibration A: the light bumper over ticks, and the period found (eq. 13 of the source paper).
std::string encoder_scale_section(const CalibrationMaterial& material);
// Calibration B: step responses and the four transfer functions (eq. 2-10).
std::string response_section(const CalibrationMaterial& material);
// Calibration C: random sequence, weights with intervals, poles, free run (eq. 12). With `sweep` also the
// order against the error on held-out data, which takes some seconds.
std::string arma_section(const CalibrationMaterial& material, bool sweep);
// A model that was made elsewhere: its responses and, for ARMA, its weights and poles.
std::string model_section(const RobotModel& model);

// Which orders were tried, which one would be chosen, and which one the model has.
Plot order_plot(const OrderSweep& sweep, std::size_t model_order);

}  // namespace wheelwright::tools
