// Stamps that say when a row was handled, not when it was measured: rows come in bunches, while the wheels
// show that they were measured at even times.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wheelwright::import {

struct EvenStamps {
  std::vector<double> t_s;  // even times through the stamps, between holes
  double period_s = 0.0;
  double shortest_s = 0.0;  // percentiles 5 and 95 of the steps as they were
  double longest_s = 0.0;

  std::string text() const;  // what was found and done, for a person
};

// Even times for rows whose steps differ by more than a factor of two and whose travel goes by rows rather
// than by stamps; nothing where the stamps are to be believed. `travel` is of one wheel or along one axis, in
// any unit, one value per row; not-a-number where a row has none.
std::optional<EvenStamps> even_stamps(std::span<const double> t_s, std::span<const double> travel);

}  // namespace wheelwright::import
