// One wheel's encoder counts, unwrapped and given the sign of the true motion.
//
// Counts are 16 bits and roll over. By the documents the encoder is not quadrature (Create 2 OI p30): counts
// go in the direction that is commanded, and up where the command is zero, whatever the wheel does. Recorded
// Create 2 count in the direction in which the motor pushes, which while braking is the wrong one. Others may
// know the true direction. So the counter starts by trusting the sign. If a sign changes when the wheel
// cannot have turned round (it is too fast, or a new command is too recent), only the size of a change counts
// from then on while the wheel moves, and the direction may change only where the wheel is slow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace wheelwright::open_interface {

class EncoderCounter {
 public:
  // Takes the raw count of a sample and the command (any unit, only its sign matters) in force before it.
  // Returns false, and takes nothing, where the change is more than `max_change` ticks: no wheel moves so
  // fast.
  bool update(std::uint16_t raw, double command, int max_change);

  // Forgets where the raw count was; the next sample continues from the same total.
  void rebase();

  // Forgets in which direction the wheel moved: the commands so far belonged to the other wheel. The next
  // sign counts.
  void forget_signs();

  std::int64_t total() const { return total_; }
  // As the robot counts, only unwrapped: with its own signs.
  std::int64_t counted() const { return counted_; }
  // The sign of the last sample is inferred against what the robot counted, or may yet be given another.
  bool doubtful() const { return doubtful_; }

 private:
  void note_command(int wanted);
  void take(int change);
  void believe(int change);
  bool changed_sign_without_turning(int size, int sign) const;
  void look_for_turn(int size);
  bool turned_against_command(int size, int sign) const;
  int recent_ticks() const;

  std::optional<std::uint16_t> last_raw_;
  std::int64_t total_ = 0;
  std::int64_t counted_ = 0;
  int direction_ = 1;  // in which the wheel moves, or moved last
  int wanted_ = 0;     // the sign of the command
  int sought_ = 0;     // the sign of the last command that was not zero
  int last_sign_ = 0;  // of the last change that was not zero, as the robot counted it
  bool doubtful_ = false;
  bool counts_by_rule_ = false;  // of command or motor, not by the true direction
  bool looks_for_turn_ = false;
  bool rests_ = false;  // not driven, and at most rocking on the spot

  std::array<int, 4> recent_{};    // sizes of the last changes, newest first
  int samples_since_command_ = 0;  // changed its sign
  int samples_since_sought_ = 0;
  int samples_against_count_ = 0;  // in a row, in which the robot counted the other way

  int speed_before_turn_ = 0;  // ticks in a sample
  int slowest_ = 0;            // ticks in a sample, since the command wants the other direction
  int ticks_since_slowest_ = 0;
};

}  // namespace wheelwright::open_interface
