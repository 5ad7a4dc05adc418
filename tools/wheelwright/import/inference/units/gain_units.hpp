// What a gain between two columns says of their units.
#pragma once

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"

namespace wheelwright::import {

inline constexpr double near_gain = 1.35;  // a unit is taken where the gain is within this factor of it
// Within that factor of the unit, and of the same sign.
bool is_near(double gain, double unit);

inline constexpr double fastest_m_s = 3.0;  // larger numbers are in no metres per second

// Five figures: the gain of a noisy response has no more.
double rounded_gain(double gain);

// The number that stands for all of a duty: 1, 100, 255, ...
double full_scale_of(double largest_duty);

// The same of numbers about the one at which the wheels rest: 500 us of a pulse, else all that is below it.
double full_scale_about(double neutral, double largest_beyond);

// Of commands that are a duty, by the largest of them, unless it is given.
void set_full_scale(const DriveColumns& columns, const GivenMapping& given, CommandMapping& command);

}  // namespace wheelwright::import
