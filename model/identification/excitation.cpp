#include "model/identification/excitation.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "model/log/command_timeline.hpp"
#include "model/log/run_periods.hpp"

namespace wheelwright {
namespace {

// Of the energy of all commands: a direction of the command plane that holds less is looked at twice.
constexpr double weakest_share = 1e-3;
// Of a gain, in m/s per m/s: a standard error above it says nothing of the wheels.
constexpr double gain_of_interest = 0.05;

// Commanded and measured distances over windows of a second.
class DistanceWindows {
 public:
  void add(const DriveLog& log) {
    if (!log.has_ticks()) return;
    constexpr double window_s = 1.0;
    const CommandTimeline commands(log);
    const auto& rows = log.samples;
    std::size_t from = 0;
    for (std::size_t k = 1; k < rows.size(); ++k) {
      if (!rows[k].ticks) continue;
      const bool hole = rows[k].t_s - rows[k - 1].t_s > longest_step_periods * log.period_s;
      if (!hole && rows[k].t_s - rows[from].t_s < window_s) continue;
      if (!hole) add(log, commands, from, k);
      from = k;
    }
  }

  // Of the gain of either wheel by commands in this direction (of length 1): by the information of the
  // windows, and the scatter that is left of them.
  double standard_error(const Eigen::Vector2d& direction) const {
    constexpr double min_windows = 5.0;
    const double energy = direction.dot(commanded_ * direction);
    if (count_ < min_windows || !(energy > 0.0)) return std::numeric_limits<double>::infinity();
    const Eigen::Matrix2d gains = commanded_.fullPivLu().solve(products_);
    const Eigen::Vector2d left = travelled_ - gains.cwiseProduct(products_).colwise().sum().transpose();
    return std::sqrt(std::max(0.0, left.maxCoeff()) / (count_ - 2.0) / energy);
  }

 private:
  void add(const DriveLog& log, const CommandTimeline& commands, std::size_t from, std::size_t to) {
    const WheelPair begin = commands.distance_m(log.samples[from].t_s);
    const WheelPair end = commands.distance_m(log.samples[to].t_s);
    const WheelTicks& first = *log.samples[from].ticks;
    const WheelTicks& last = *log.samples[to].ticks;
    const Eigen::Vector2d commanded(end.left - begin.left, end.right - begin.right);
    const Eigen::Vector2d travelled(
        static_cast<double>(last.left - first.left) * log.metres_per_tick->left,
        static_cast<double>(last.right - first.right) * log.metres_per_tick->right);
    commanded_ += commanded * commanded.transpose();
    products_ += commanded * travelled.transpose();
    travelled_ += travelled.cwiseAbs2();
    count_ += 1.0;
  }

  Eigen::Matrix2d commanded_ = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d products_ = Eigen::Matrix2d::Zero();  // one column for each wheel that travelled
  Eigen::Vector2d travelled_ = Eigen::Vector2d::Zero();
  double count_ = 0.0;
};

}  // namespace

std::optional<Refusal> find_missing_excitation(std::span<const DriveLog> logs) {
  double left = 0.0;
  double right = 0.0;
  double mixed = 0.0;
  DistanceWindows windows;
  for (const auto& log : logs) {
    for (const auto& sample : log.samples) {
      const auto& u = sample.command_m_s;
      left += u.left * u.left;
      right += u.right * u.right;
      mixed += u.left * u.right;
    }
    windows.add(log);
  }
  const double total = left + right;
  if (total <= 0.0)
    return Refusal{"the robot was never commanded to move; record a run that drives and turns"};
  const auto is_lacking = [&](double energy, double along_left, double along_right) {
    const Eigen::Vector2d direction = Eigen::Vector2d(along_left, along_right).normalized();
    return energy < weakest_share * total && windows.standard_error(direction) > gain_of_interest;
  };
  if (is_lacking(left, 1.0, 0.0)) return Refusal{"the left wheel was never driven; add a run that drives it"};
  if (is_lacking(right, 0.0, 1.0))
    return Refusal{"the right wheel was never driven; add a run that drives it"};
  if (is_lacking(0.5 * (left + right) - mixed, 1.0, -1.0)) {
    return Refusal{
        "both wheels were always commanded alike, so their effects cannot be distinguished; add a run that "
        "turns"};
  }
  if (is_lacking(0.5 * (left + right) + mixed, 1.0, 1.0)) {
    return Refusal{"the wheels were always commanded against each other; add a run that drives straight"};
  }
  // The smaller eigenvalue of the Gram matrix of the two commands catches any other fixed ratio.
  const double smaller = 0.5 * (total - std::hypot(left - right, 2.0 * mixed));
  const double angle = 0.5 * std::atan2(2.0 * mixed, left - right);  // of the larger one's direction
  if (is_lacking(smaller, -std::sin(angle), std::cos(angle))) {
    return Refusal{"the two commands always kept the same ratio; add a run that turns the other way"};
  }
  return std::nullopt;
}

}  // namespace wheelwright
