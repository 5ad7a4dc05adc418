// Faults of wheels and encoders by name, and how they are told.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace wheelwright {

enum class FaultKind : std::uint8_t {
  none,
  misfit,    // readings are discarded; why is not known yet, or cannot be told
  dropped,   // part of the counts is missing, or all of them for less than 0.25 s
  frozen,    // no counts while the wheel turns
  spike,     // the counter jumped and goes on soundly, from there or from where it was
  stuck_at,  // the counter jumped and stays where it is
  swapped,   // left and right exchanged
  drifting,  // metres per tick change slowly, of one encoder
  stalled,   // the wheel does not turn although its motor pulls
  lifted,    // a wheel hangs in the air
  slipping,  // the wheels turn as told, with far more current than they need to roll: something holds the
             // robot
};
std::string_view name_of(FaultKind kind);

// Whether it is the counts that are wrong, and not how the wheel turns.
constexpr bool is_of_encoder(FaultKind kind) {
  switch (kind) {
    case FaultKind::dropped:
    case FaultKind::frozen:
    case FaultKind::spike:
    case FaultKind::stuck_at:
    case FaultKind::swapped:
    case FaultKind::drifting:
      return true;
    case FaultKind::none:
    case FaultKind::misfit:
    case FaultKind::stalled:
    case FaultKind::lifted:
    case FaultKind::slipping:
      break;
  }
  return false;
}

enum class FaultyWheel : std::uint8_t { left, right, both };

struct FaultEvent {
  enum class Stage : std::uint8_t {
    began,  // the first reading was discarded or the test gave alarm; the kind may still be `misfit`
    named,  // what it is
    ended,  // readings are used again
  };
  Stage stage = Stage::began;
  FaultKind kind = FaultKind::none;
  FaultyWheel wheel = FaultyWheel::left;
  std::int64_t tick = 0;
  // How far the readings are off: the innovation when it began, the travel kept out of the pose when it
  // ended. Signed, metres of wheel travel. Amperes too many for `stalled` and `slipping`.
  double size = 0.0;
};

// The events of one tick. What does not fit is counted, not kept.
class FaultEvents {
 public:
  void add(const FaultEvent& event) {
    if (count_ < events_.size()) {
      events_[count_++] = event;
    } else {
      ++lost_;
    }
  }
  const FaultEvent* begin() const { return events_.data(); }
  const FaultEvent* end() const { return events_.data() + count_; }
  bool empty() const { return count_ == 0; }
  std::size_t lost() const { return lost_; }

 private:
  std::array<FaultEvent, 8> events_{};
  std::size_t count_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace wheelwright
