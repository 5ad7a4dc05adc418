// How far the robot went and turned, by its wheels or, without those, by its commands: what a reference whose
// units nobody states is held against.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/mapping/mapping.hpp"

namespace wheelwright::import {

enum class WayBy { wheels, commands };

// What is known well enough to say how far the robot went in metres.
std::optional<WayBy> way_source(const DriveColumns& columns, const Mapping& mapping);

// How far the middle of the robot went up to each row, in metres, and how far it turned.
struct Ways {
  Column way;
  Column turn;

  explicit Ways(std::size_t rows) : way(rows, 0.0), turn(rows, 0.0) {}

  // Along the straight line from one row to another.
  double chord(std::size_t from, std::size_t to) const;
};

// Positions in `rows` at the ends of windows of a second, from one that is known to another; one flag for
// each row.
struct Window {
  std::size_t from;
  std::size_t to;
};
std::vector<Window> windows_of(const DriveColumns& columns, std::span<const std::size_t> rows,
                               const std::vector<char>& is_known);

// Sums over windows of what the robot did and of what the reference says of it.
struct Agreement {
  double products = 0.0;
  double robot_squares = 0.0;
  double reference_squares = 0.0;
  std::size_t windows = 0;

  void add(double robot, double reference);
  double correlation() const;
  // Whether the two go together.
  bool holds() const;
  double slope() const { return products / robot_squares; }
};

Ways ways_of_robot(const DriveColumns& columns, std::span<const std::size_t> rows, const Mapping& mapping,
                   WayBy source);

}  // namespace wheelwright::import
