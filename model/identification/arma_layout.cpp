#include "model/identification/arma_layout.hpp"

namespace wheelwright {

WheelResponse ArmaLayout::to_response(const Eigen::VectorXd& unknowns) const {
  WheelResponse response;
  response.from_left.assign(order + 1, 0.0);
  response.from_right.assign(order + 1, 0.0);
  Eigen::Index column = 0;
  for (std::size_t i = delay; i <= order; ++i) {
    response.from_left[i] = unknowns[column++];
    response.from_right[i] = unknowns[column++];
  }
  for (std::size_t i = 0; i < order; ++i) response.from_own_past.push_back(unknowns[column++]);
  return response;
}

Eigen::VectorXd ArmaLayout::to_unknowns(const WheelResponse& response) const {
  Eigen::VectorXd unknowns(columns());
  Eigen::Index column = 0;
  for (std::size_t i = delay; i <= order; ++i) {
    unknowns[column++] = response.from_left[i];
    unknowns[column++] = response.from_right[i];
  }
  for (const double weight : response.from_own_past) unknowns[column++] = weight;
  return unknowns;
}

}  // namespace wheelwright
