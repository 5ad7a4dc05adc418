// What the figures of a gap say: whether a model's free runs come closer to the measured ones than they were,
// and whether noise explains what is left.
#pragma once

#include <optional>
#include <string_view>

#include "model/prediction/score.hpp"

namespace wheelwright::gap {

// Figure over noise floor from which on something is missing. Clean logs stay below 1.15.
constexpr double more_than_noise = 1.5;
constexpr double far_above_noise = 2.0;

// Before, after and floor of one set of runs.
struct GapFigures {
  Score before;
  Score after;
  Score floor;
};

// A figure (distance, position or heading) of the model after the analysis, in multiples of its noise floor,
// and the share of what stood above the floor before that is gone.
struct Excess {
  std::string_view figure;
  double times = 0.0;
  double closed = 1.0;
};

// The figure that lies furthest above its floor in both sets of runs; `times` and `closed` are the smaller of
// the two. A figure of less than 3 mm of travel, 6 mm of position or 10 mrad of heading does not count. Where
// only a first and a last pose are known, the floor is taken 1.5 times as high.
Excess largest_excess(const GapFigures& train, const GapFigures& test);

// The figure that lies furthest above its floor in the held-out runs and twice as far as in training,
// and that by far more than chance does; none where both are alike.
std::optional<Excess> held_out_alone(const GapFigures& train, const GapFigures& test);

// Whether any figure lies above what noise alone would leave of it, before the analysis.
bool some_figure_above_noise(const GapFigures& figures);

// Whether distance, position and heading are off by so little, before the analysis, that nobody would see it
// in a plot; false where there is none of them.
bool all_figures_negligible(const GapFigures& figures);

// Of the mean square of distance, position or heading before, how much is gone after: the most of the three,
// negative where all rise. One where there is no such figure.
double largest_share_gone(const GapFigures& figures);

// Whether distance, position and heading rise: all that stand above noise (more_than_noise) before or after,
// and the three together (common_fall). False where none stands above noise.
bool goes_further_astray(const GapFigures& figures);

// The floor of a figure, or the figure after the analysis where that is smaller: noise is a part of what is
// left, so a larger floor is an error of the noise model.
Score bounded_floor(const Score& floor, const Score& after);

constexpr double min_fall = 0.03;  // of a figure, that a person would see

// Whether any figure fell by `min_share` of itself. Figures that lay below `above_floor` floors do not
// count.
bool some_figure_falls(const GapFigures& figures, double min_share, double above_floor);

// By which share distance, position and heading fell together: one minus the geometric mean of after over
// before. Negative where they rise; none where there is no such figure.
std::optional<double> common_fall(const GapFigures& figures);

// Whether a gap that was to be seen above the noise became smaller: what a linear effect has to do to be more
// than a better linear model.
bool shows(const GapFigures& figures);

}  // namespace wheelwright::gap
