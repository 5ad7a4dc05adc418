#include "model/identification/arma_accumulator.hpp"

#include <algorithm>

namespace wheelwright {

ArmaAccumulator::ArmaAccumulator(const ArmaLayout& layout)
    : layout_(layout),
      left_{LeastSquaresAccumulator(layout.columns(), 1), Eigen::RowVectorXd::Zero(layout.columns())},
      right_{left_},
      commands_(Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(2 * (layout.order + 1)))) {
  start_from_rest();
}

void ArmaAccumulator::start_from_rest() {
  left_.row.setZero();
  right_.row.setZero();
  commands_.setZero();
  commands_known_ = layout_.order + 1;
  speeds_known_ = layout_.order;
}

void ArmaAccumulator::lose_past() {
  commands_known_ = 0;
  speeds_known_ = 0;
}

void ArmaAccumulator::add(const WheelPair& command_m_s, const std::optional<WheelPair>& speed_m_s) {
  remember_command(command_m_s);
  if (speed_m_s && commands_known_ > layout_.order && speeds_known_ >= layout_.order) {
    add_row(left_, speed_m_s->left);
    add_row(right_, speed_m_s->right);
  }
  speeds_known_ = speed_m_s ? std::min(speeds_known_ + 1, layout_.order) : 0;
  remember_speed(left_, speed_m_s ? speed_m_s->left : 0.0);
  remember_speed(right_, speed_m_s ? speed_m_s->right : 0.0);
}

void ArmaAccumulator::remember_command(const WheelPair& command_m_s) {
  std::copy_backward(commands_.data(), commands_.data() + commands_.size() - 2,
                     commands_.data() + commands_.size());
  commands_[0] = command_m_s.left;
  commands_[1] = command_m_s.right;
  commands_known_ = std::min(commands_known_ + 1, layout_.order + 1);
}

void ArmaAccumulator::remember_speed(Wheel& wheel, double speed_m_s) {
  if (layout_.order == 0) return;
  double* newest = wheel.row.data() + layout_.command_columns();
  double* end = wheel.row.data() + wheel.row.size();
  std::copy_backward(newest, end - 1, end);
  *newest = speed_m_s;
}

void ArmaAccumulator::add_row(Wheel& wheel, double speed_m_s) {
  wheel.row.head(layout_.command_columns()) = commands_.tail(layout_.command_columns());
  wheel.equations.add_row(wheel.row, Eigen::RowVector<double, 1>(speed_m_s));
}

}  // namespace wheelwright
