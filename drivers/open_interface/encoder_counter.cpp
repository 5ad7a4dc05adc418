#include "drivers/open_interface/encoder_counter.hpp"

#include <cstdlib>

namespace wheelwright::open_interface {
namespace {

// A Roomba's wheel stands within 125-140 ms of a stop command (GAP.md, measured on a Create 2).
constexpr int longest_coast_samples = 12;
// The command acts only after this many samples (31-47 ms); until then nothing can turn round.
constexpr int dead_time_samples = 3;
// With at most one tick in each of so many samples it stands: a robot that rocks still makes one now and
// then.
constexpr int standing_samples_to_trust = 3;
constexpr int standing_ticks = 1;

}  // namespace

bool EncoderCounter::update(std::uint16_t raw, double command, int most_change) {
  const int counted = command < 0.0 ? -1 : 1;
  if (!last_raw_) last_raw_ = raw;
  const int change = static_cast<std::int16_t>(static_cast<std::uint16_t>(raw - *last_raw_));
  if (std::abs(change) > most_change) return false;
  last_raw_ = raw;

  // A wheel that stands coasts nowhere, whatever is commanded now.
  if (counted != commanded_) {
    commanded_ = counted;
    const bool stood = standing_samples_ >= standing_samples_to_trust;
    if (direction_ != counted && !stood) coasting_samples_left_ = longest_coast_samples;
    last_coast_change_ = std::abs(change);
  }
  standing_samples_ = std::abs(change) <= standing_ticks ? standing_samples_ + 1 : 0;
  if (coasting_samples_left_ > 0) {
    --coasting_samples_left_;
    const bool command_acts = coasting_samples_left_ < longest_coast_samples - dead_time_samples;
    // The wheel slows down, stands or turns round, and speeds up again.
    const bool turned_round = change == 0 || 2 * std::abs(change) > 3 * last_coast_change_ + 4;
    if (command_acts && turned_round) coasting_samples_left_ = 0;
    if (coasting_samples_left_ == 0) direction_ = counted;
    last_coast_change_ = std::abs(change);
    total_ += direction_ * std::abs(change);
    return true;
  }
  direction_ = counted;
  total_ += change;
  return true;
}

}  // namespace wheelwright::open_interface
