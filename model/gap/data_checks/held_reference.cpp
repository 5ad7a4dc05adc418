#include "model/gap/data_checks/held_reference.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "model/statistics/order_statistics.hpp"
#include "model/statistics/significant_digits.hpp"

namespace wheelwright::gap {
namespace {

constexpr double share_of_held =
    0.3;  // of the rows on which it moves; a slow robot between two digits has less
constexpr std::size_t enough_rows = 20;

bool is_reading(const DriveSample& sample) {
  return sample.reference_x_m || sample.reference_y_m || sample.reference_theta_rad;
}

bool same_pose(const DriveSample& one, const DriveSample& other) {
  return one.reference_x_m == other.reference_x_m && one.reference_y_m == other.reference_y_m &&
         one.reference_theta_rad == other.reference_theta_rad;
}

// By its counts, or where there are none by what it was told.
bool moves(const DriveSample& from, const DriveSample& to) {
  if (from.ticks && to.ticks) {
    return from.ticks->left != to.ticks->left || from.ticks->right != to.ticks->right;
  }
  return from.command_m_s.left != 0.0 || from.command_m_s.right != 0.0;
}

}  // namespace

void leave_out_repeated_poses(GateState& gate) {
  auto& samples = gate.result.log.samples;
  std::vector<std::size_t> repeated;  // rows
  std::vector<double> apart_s;        // of poses that differ
  std::size_t moving = 0;
  std::size_t held = 0;
  const DriveSample* last = nullptr;
  const DriveSample* changed = nullptr;
  for (std::size_t row = 0; row < samples.size(); ++row) {
    const DriveSample& sample = samples[row];
    if (!is_reading(sample)) continue;
    const bool same = last != nullptr && same_pose(*last, sample);
    if (last != nullptr && moves(*last, sample)) {
      ++moving;
      if (same) ++held;
    }
    if (same) repeated.push_back(row);
    if (!same && changed != nullptr) apart_s.push_back(sample.t_s - changed->t_s);
    if (!same) changed = &sample;
    last = &sample;
  }
  if (moving < enough_rows || apart_s.empty() ||
      static_cast<double>(held) < share_of_held * static_cast<double>(moving))
    return;
  gate.treated_fault(
      repeated.front(),
      "the reference repeats its last pose until the next one, " + in_digits(median(apart_s), 2) + " s later",
      std::to_string(repeated.size()) + " repeated poses were left out");
  for (const std::size_t row : repeated) {
    samples[row].reference_x_m.reset();
    samples[row].reference_y_m.reset();
    samples[row].reference_theta_rad.reset();
  }
}

}  // namespace wheelwright::gap
