// Which unknown of one wheel's ARX equation stands in which column.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "model/simulation/linear_model.hpp"

namespace wheelwright {

// Order n: commands 0 to n periods ago (the leading `delay` of them left out) and speeds 1 to n periods ago.
// Columns: [left i=delay, right i=delay, left i=delay+1, ..., right i=n, own 1, ..., own n].
struct ArmaLayout {
  std::size_t order = 9;
  std::size_t delay = 0;  // at most `order`

  std::size_t lags() const { return order + 1 - delay; }
  Eigen::Index command_columns() const { return static_cast<Eigen::Index>(2 * lags()); }
  Eigen::Index columns() const { return command_columns() + static_cast<Eigen::Index>(order); }

  // Each list of weights at its full length, with zeros for what is left out.
  WheelResponse to_response(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd to_unknowns(const WheelResponse& response) const;
};

}  // namespace wheelwright
