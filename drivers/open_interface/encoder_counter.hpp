// One wheel's encoder counts, unwrapped and given the sign of the true motion.
//
// Counts are 16 bits and roll over. The encoder is not quadrature (Create 2 OI p30): counts go in the
// direction that is commanded, and up where the command is zero, whatever the wheel does. While a wheel still
// coasts in its old direction after the command changed sign, counts therefore go the wrong way; here they
// are turned round until the wheel has come to a stop, and marked as doubtful.
#pragma once

#include <cstdint>
#include <optional>

namespace wheelwright::open_interface {

class EncoderCounter {
 public:
  // Takes the raw count of a sample and the command (any unit, only its sign matters) in force before it.
  // Returns false, and takes nothing, where the change is more than `most_change` ticks: no wheel moves so
  // fast.
  bool update(std::uint16_t raw, double command, int most_change);

  // Forgets where the raw count was; the next sample continues from the same total.
  void rebase() { last_raw_.reset(); }

  std::int64_t total() const { return total_; }
  bool doubtful() const { return coasting_samples_left_ > 0; }

 private:
  std::optional<std::uint16_t> last_raw_;
  std::int64_t total_ = 0;
  int direction_ = 1;  // in which the wheel moved last
  int commanded_ = 1;  // in which the robot counts: the sign of the last command, up for zero
  int coasting_samples_left_ = 0;
  int last_coast_change_ = 0;
  int standing_samples_ = 3;  // in a row; a robot that was just met stands
};

}  // namespace wheelwright::open_interface
