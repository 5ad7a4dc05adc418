// One wheel's encoder counts, unwrapped and given the sign of the true motion.
//
// Counts are 16 bits and roll over. By the documents the encoder is not quadrature (Create 2 OI p30): counts
// go in the direction that is commanded, and up where the command is zero, whatever the wheel does. While a
// wheel still coasts in its old direction after the command changed sign, counts then go the wrong way. For
// that short while they are turned round up to the moment at which the wheel was slowest, and marked as
// doubtful.
//
// A robot whose counts go against the command more than once has an encoder that knows better (recorded
// Create 2 do); from then on its signs are believed.
#pragma once

#include <array>
#include <cstddef>
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
  void rebase();

  // Forgets what was learnt of this encoder's signs: the commands it was told belonged to the other wheel.
  void forget_signs() { samples_against_command_ = 0; }

  std::int64_t total() const { return total_; }
  // The last samples may yet be given another sign.
  bool doubtful() const { return coast_size_ > 0; }

 private:
  // A Roomba's wheel stands within 125-145 ms of a stop command, and has turned round as soon (GAP.md).
  static constexpr std::size_t longest_coast_samples = 12;

  bool coasts_now(int counted) const;
  void take_coasting(int change);
  std::int64_t coasted() const;

  std::optional<std::uint16_t> last_raw_;
  std::int64_t total_ = 0;
  int direction_ = 1;  // in which the wheel moved last
  int commanded_ = 1;  // in which the robot counts: the sign of the last command, up for zero
  int standing_samples_ = 0;
  int samples_against_command_ = 0;

  std::array<int, longest_coast_samples> coast_{};  // raw changes since the command changed sign
  std::size_t coast_size_ = 0;
  std::int64_t total_before_coast_ = 0;
};

}  // namespace wheelwright::open_interface
