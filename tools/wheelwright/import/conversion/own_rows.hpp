// Tables in which topics that came at times of their own stand below each other, as PlotJuggler and joins of
// tables write them: a row has values of one topic, and nothing of the others.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tools/wheelwright/import/conversion/join_streams.hpp"

namespace wheelwright::import {

// The rows in which `wheel` has a value, where most of the others are rows of `others`. Nothing where a row
// is one of all columns, and a value that is not there is a value that was lost.
std::optional<std::vector<std::size_t>> rows_of_its_own(std::span<const double> wheel,
                                                        std::span<const std::vector<double>* const> others);

std::vector<double> at_rows(std::span<const double> values, std::span<const std::size_t> rows);

// `values` at the times of `rows`: their own where each row has one, else joined from the rows that have one.
std::vector<double> join_own_rows(std::span<const double> t_s, std::span<const double> values,
                                  std::span<const std::size_t> rows, Joining joining);

}  // namespace wheelwright::import
