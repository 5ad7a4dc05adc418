// Values of one stream at the times of the rows of another.
#pragma once

#include <cstddef>

#include <span>
#include <vector>

namespace wheelwright::import {

// How the value at a row is had from the rows of its own stream.
enum class Joining {
  held,     // it holds until the next: a command, a voltage
  between,  // on the line between two neighbours: a place, a heading that was unwrapped, a turn rate
};

// `values` at `from_s`, at each of the times `to_s`. Where both clocks start again, or are set back, as
// often, each part is joined to its own (clock_sessions.hpp); rows without a time get nothing. A held value
// counts from the row that is nearest to it in time, so that commands are early as often as late. Nothing is
// interpolated across a hole (more than three usual steps of the stream, and 0.3 s): there, and where the
// stream is sparse, a value goes to the row nearest to it. Not-a-number where there is none.
std::vector<double> join(std::span<const double> from_s, std::span<const double> values,
                         std::span<const double> to_s, Joining joining);

// The rows of several streams on one axis of time: one at each time at which any stream has one. Where all
// clocks start again as often, the parts follow one another.
struct UnitedRows {
  std::vector<double> t_s;
  std::vector<std::vector<std::size_t>> rows;  // by stream, of each of its rows that has a time
};
UnitedRows unite_rows(std::span<const std::vector<double>> times);

}  // namespace wheelwright::import
