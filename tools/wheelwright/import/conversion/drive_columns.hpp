// The mapped channels of one or more recordings on one axis of rows, in the order of time, before anything is
// converted: as the files say it, in their units.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// One value per row, or empty where the column is not mapped; not-a-number where a row has no value.
using Column = std::vector<double>;

struct DriveColumns {
  Column t_s;                       // in seconds, on the clock of the file
  std::vector<std::size_t> places;  // line of each row in its file; empty where rows of streams were merged
  std::array<Column, 2> command;    // left and right, or linear and angular
  std::array<Column, 2> direction;  // bits beside a duty, left and right
  std::array<Column, 2> wheel;      // left and right, or linear and angular
  Column x;
  Column y;
  Column theta_rad;  // of a quaternion, or of the column in its unit
  Column gyro;
  Column battery;
  bool has_misread_counts = false;      // of which some rows were left out
  std::vector<std::size_t> run_starts;  // rows at which a run begins for sure
  std::vector<std::string> remarks;     // what was done to the time of streams before they were merged

  std::size_t rows() const { return t_s.size(); }
  // "line 12", or "row 12" of merged rows.
  std::string place(std::size_t row) const;
};

// A channel by its name, or by its number from 1; nullptr where there is none, or several.
struct FoundChannel {
  const Stream* stream = nullptr;
  const Channel* channel = nullptr;
};
FoundChannel find_channel(std::span<const Recording> recordings, const ChannelName& name);

// Several streams are merged: the rows are those of the wheels, to which all else is joined
// (join_streams.hpp); without wheels there is one at each time at which any stream has one. Fails, with one
// line, where a mapped channel is not there or there is no time.
tl::expected<DriveColumns, std::string> gather(std::span<const Recording> recordings, const Mapping& mapping);

// The same, of a long table a part from where the robot begins to move: enough to find out units and signs
// from.
tl::expected<DriveColumns, std::string> gather_sample(std::span<const Recording> recordings,
                                                      const Mapping& mapping);

}  // namespace wheelwright::import
