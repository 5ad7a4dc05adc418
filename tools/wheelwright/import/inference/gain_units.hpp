// What a gain between two columns says of their units.
#pragma once

#include "tools/wheelwright/import/conversion/drive_columns.hpp"

namespace wheelwright::import {

// Within a third of the unit, with its sign.
bool is_near(double gain, double unit);

// Five figures: the gain of a noisy response has no more.
double rounded_gain(double gain);

// The number that stands for all of a duty: 1, 100, 255, ...
double full_scale_of(double largest_duty);

// Largest size of the values of a column; 0 where it has none.
double largest(const Column& column);

}  // namespace wheelwright::import
