#include "model/identification/excitation.hpp"

#include <cmath>

namespace wheelwright {
namespace {

// Below this share of the whole, a direction of the command plane counts as not driven at all.
constexpr double weakest_share = 1e-3;

}  // namespace

std::optional<Refusal> find_missing_excitation(std::span<const DriveLog> logs) {
  double forward = 0.0;  // energy of both wheels together
  double turning = 0.0;  // energy of the wheels against each other
  double left = 0.0;
  double right = 0.0;
  double mixed = 0.0;
  for (const auto& log : logs) {
    for (const auto& sample : log.samples) {
      const auto& u = sample.command_m_s;
      left += u.left * u.left;
      right += u.right * u.right;
      mixed += u.left * u.right;
      forward += 0.5 * (u.left + u.right) * (u.left + u.right);
      turning += 0.5 * (u.left - u.right) * (u.left - u.right);
    }
  }
  const double total = left + right;
  if (total <= 0.0)
    return Refusal{"the robot was never commanded to move; record a run that drives and turns"};
  if (left < weakest_share * total)
    return Refusal{"the left wheel was never driven; add a run that drives it"};
  if (right < weakest_share * total)
    return Refusal{"the right wheel was never driven; add a run that drives it"};
  if (turning < weakest_share * total) {
    return Refusal{
        "both wheels were always commanded alike, so their effects cannot be told apart; add a run that "
        "turns"};
  }
  if (forward < weakest_share * total) {
    return Refusal{"the wheels were always commanded against each other; add a run that drives straight"};
  }
  // The smaller eigenvalue of the Gram matrix of the two commands catches any other fixed ratio.
  const double smaller = 0.5 * (total - std::hypot(left - right, 2.0 * mixed));
  if (smaller < weakest_share * total) {
    return Refusal{"the two commands always kept the same ratio; add a run that turns the other way"};
  }
  return std::nullopt;
}

}  // namespace wheelwright
