#include "drivers/open_interface/encoder_counter.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace wheelwright::open_interface {
namespace {

// A wheel that makes no more ticks than this in the recent samples stands; one that rocks still makes some,
// and most where it is not driven.
constexpr int standing_ticks = 2;
constexpr int rocking_ticks = 4;
// A command acts only after 31-47 ms (measured on a Create 2), and shows a refresh later; nothing turns round
// before.
constexpr int dead_time_samples = 2;
// By then it has (125-145 ms on a Create 2).
constexpr int longest_turn_samples = 8;
// Without a command the slowest of old motors still creep for so long.
constexpr int longest_coast_samples = 60;
// In so many samples after a command the robot may change the way it counts without the wheel turning round.
constexpr int sign_rule_samples = 4;
// A sign that changes sooner after a command, or between samples that are faster, is not a wheel that turns.
constexpr int soonest_turn_samples = 3;
constexpr int fast_ticks = 3;
constexpr int fast_ticks_of_two = 10;
// After so many samples in which the robot counts the other way it is believed.
constexpr int samples_to_believe = 60;

int sign_of(double value) {
  return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0);
}

}  // namespace

void EncoderCounter::rebase() {
  last_raw_.reset();
  recent_.fill(0);
  last_sign_ = 0;
  doubtful_ = false;
}

void EncoderCounter::forget_signs() {
  recent_.fill(0);
  last_sign_ = 0;
  doubtful_ = false;
  counts_by_rule_ = false;
}

bool EncoderCounter::update(std::uint16_t raw, double command, int max_change) {
  if (!last_raw_) last_raw_ = raw;
  const int change = static_cast<std::int16_t>(static_cast<std::uint16_t>(raw - *last_raw_));
  if (std::abs(change) > max_change) return false;
  last_raw_ = raw;
  counted_ += change;
  note_command(sign_of(command));
  take(change);
  std::shift_right(recent_.begin(), recent_.end(), 1);
  recent_[0] = std::abs(change);
  if (change != 0) last_sign_ = sign_of(change);
  return true;
}

void EncoderCounter::note_command(int wanted) {
  ++samples_since_command_;
  ++samples_since_sought_;
  if (wanted == wanted_) return;
  wanted_ = wanted;
  samples_since_command_ = 0;
  // A robot is behind its commands: what was told to turn round may do so although it is told to stop by now.
  if (wanted == 0 || wanted == sought_) return;
  sought_ = wanted;
  samples_since_sought_ = 0;
  looks_for_turn_ = sought_ != direction_;
  speed_before_turn_ = recent_ticks() / static_cast<int>(recent_.size());
  slowest_ = std::numeric_limits<int>::max();
  ticks_since_slowest_ = 0;
}

int EncoderCounter::recent_ticks() const {
  return std::accumulate(recent_.begin(), recent_.end(), 0);
}

void EncoderCounter::take(int change) {
  const int size = std::abs(change);
  const int sign = sign_of(change);
  samples_against_count_ = sign == -direction_ ? samples_against_count_ + 1 : 0;
  const bool stood = recent_ticks() <= standing_ticks;
  doubtful_ = false;
  counts_by_rule_ = counts_by_rule_ || changed_sign_without_turning(size, sign);
  if (!counts_by_rule_) {
    believe(change);
    return;
  }
  // Where it counts up whatever the wheel does, a wheel that rocks on the spot would count for ever.
  const bool has_come_to_rest =
      rests_ || recent_ticks() <= rocking_ticks || samples_since_command_ > longest_coast_samples;
  rests_ = wanted_ == 0 && size <= standing_ticks && has_come_to_rest;
  if (rests_) return;
  if (stood || samples_against_count_ > samples_to_believe || turned_against_command(size, sign)) {
    believe(change);
    return;
  }
  total_ += direction_ * size;
  doubtful_ = looks_for_turn_ || sign == -direction_;
  if (looks_for_turn_) look_for_turn(size);
}

void EncoderCounter::believe(int change) {
  if (change != 0) direction_ = sign_of(change);
  looks_for_turn_ = looks_for_turn_ && direction_ != sought_;
  total_ += change;
}

bool EncoderCounter::changed_sign_without_turning(int size, int sign) const {
  if (sign != -direction_ || last_sign_ != direction_) return false;
  const bool too_soon = samples_since_command_ < soonest_turn_samples && recent_ticks() > standing_ticks;
  const bool too_fast = std::min(size, recent_[0]) >= fast_ticks && size + recent_[0] >= fast_ticks_of_two;
  return too_soon || too_fast;
}

// A push from outside, or a wheel that swings back: seen by an encoder that knows its direction, whose sign
// changes where the wheel is slow and not because of a command.
bool EncoderCounter::turned_against_command(int size, int sign) const {
  return sign == -direction_ && last_sign_ == direction_ && std::min(size, recent_[0]) <= 1 &&
         samples_since_command_ >= sign_rule_samples;
}

// The wheel slows down, stands or turns round within a sample, and speeds up again.
void EncoderCounter::look_for_turn(int size) {
  const bool slow_from_the_start = speed_before_turn_ < 4;
  if (samples_since_sought_ < dead_time_samples + (slow_from_the_start ? 1 : 0)) return;
  ticks_since_slowest_ += size;
  if (size < slowest_) {
    slowest_ = size;
    ticks_since_slowest_ = 0;
  }
  const bool as_good_as_stands = slowest_ <= speed_before_turn_ / 8;
  const bool speeds_up =
      size >= 2 * slowest_ && size >= slowest_ + 2 && slowest_ <= std::max(speed_before_turn_ / 2, 1);
  const bool must_have_turned = samples_since_sought_ >= longest_turn_samples;
  if (!as_good_as_stands && !speeds_up && !must_have_turned) return;
  // The slowest sample goes there and back, and those since go in the new direction.
  total_ -= direction_ * slowest_;
  total_ -= 2 * direction_ * ticks_since_slowest_;
  direction_ = sought_;
  looks_for_turn_ = false;
}

}  // namespace wheelwright::open_interface
