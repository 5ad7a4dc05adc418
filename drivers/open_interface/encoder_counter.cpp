#include "drivers/open_interface/encoder_counter.hpp"

#include <algorithm>
#include <cstdlib>

namespace wheelwright::open_interface {
namespace {

// The command acts only after 31-47 ms (GAP.md); in so many samples after it nothing can have turned round.
constexpr std::size_t dead_time_samples = 2;
// With at most one tick in each of so many samples a wheel stands: a robot that rocks still makes one now and
// then.
constexpr int standing_samples_to_trust = 3;
constexpr int standing_ticks = 1;
// So many samples that count against the command show an encoder that knows its direction.
constexpr int samples_to_believe_signs = 3;

}  // namespace

void EncoderCounter::rebase() {
  last_raw_.reset();
  coast_size_ = 0;
  standing_samples_ = 0;
}

bool EncoderCounter::coasts_now(int counted) const {
  return counted != direction_ && standing_samples_ < standing_samples_to_trust &&
         samples_against_command_ < samples_to_believe_signs;
}

bool EncoderCounter::update(std::uint16_t raw, double command, int most_change) {
  const bool first = !last_raw_;
  if (first) last_raw_ = raw;
  const int change = static_cast<std::int16_t>(static_cast<std::uint16_t>(raw - *last_raw_));
  if (std::abs(change) > most_change) return false;
  last_raw_ = raw;
  const int counted = command < 0.0 ? -1 : 1;
  if (first) {
    commanded_ = direction_ = counted;
    return true;
  }

  if (counted != commanded_) {
    commanded_ = counted;
    coast_size_ = 0;
    if (coasts_now(counted)) {
      total_before_coast_ = total_;
      take_coasting(change);
      return true;
    }
    direction_ = counted;
  } else if (coast_size_ > 0) {
    take_coasting(change);
    return true;
  }
  total_ += change;
  if (change * commanded_ < 0) ++samples_against_command_;
  standing_samples_ = std::abs(change) <= standing_ticks ? standing_samples_ + 1 : 0;
  return true;
}

void EncoderCounter::take_coasting(int change) {
  coast_.at(coast_size_++) = change;
  if (coast_size_ > dead_time_samples && change * commanded_ < 0) ++samples_against_command_;
  total_ = total_before_coast_ + coasted();
  if (coast_size_ < longest_coast_samples) return;
  coast_size_ = 0;
  direction_ = commanded_;
  standing_samples_ = 0;
}

// Travel since the command changed sign: in the old direction until the wheel was slowest, then in the new
// one.
std::int64_t EncoderCounter::coasted() const {
  const auto end = coast_.begin() + static_cast<std::ptrdiff_t>(coast_size_);
  std::int64_t sum = 0;
  if (samples_against_command_ >= samples_to_believe_signs) {
    for (auto it = coast_.begin(); it != end; ++it) sum += *it;
    return sum;
  }
  const auto acts = coast_.begin() + static_cast<std::ptrdiff_t>(std::min(coast_size_, dead_time_samples));
  const auto slower = [](int a, int b) { return std::abs(a) < std::abs(b); };
  const auto slowest = std::min_element(acts, end, slower);
  // While it only slows down, the slowest sample is the newest one, and the wheel has not turned round yet.
  const bool turned_round = slowest != end && (slowest + 1 != end || *slowest == 0);
  for (auto it = coast_.begin(); it != end; ++it) {
    if (turned_round && it == slowest) continue;  // there and back
    sum += (turned_round && it > slowest ? commanded_ : direction_) * std::abs(*it);
  }
  return sum;
}

}  // namespace wheelwright::open_interface
