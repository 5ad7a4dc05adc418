// Whether a robot that the host cannot see any more comes to rest, and how long that takes.
#pragma once

#include <algorithm>
#include <optional>

#include "tests/support/soak/soak_figures.hpp"

namespace wheelwright::soak {

class RestWatch {
 public:
  // Blind is who has had no sound reading for longer than `limit_s`.
  explicit RestWatch(double limit_s) : limit_s_(limit_s) {}

  void sound_reading(double now_s) {
    last_sound_s_ = now_s;
    in_segment_ = false;
  }

  void look(double now_s, bool at_rest, bool armed, bool hears) {
    if (!in_segment_ && seen_moving_ && now_s - last_sound_s_ > limit_s_) {
      in_segment_ = true;
      ++segments_;
      judged_since_s_ = at_rest ? std::nullopt : std::optional(now_s);
    }
    seen_moving_ = armed || (seen_moving_ && !at_rest);
    if (judged_since_s_ && !hears) judged_since_s_.reset();
    if (judged_since_s_ && (at_rest || now_s - *judged_since_s_ > longest_braking_s)) {
      longest_to_rest_s_ = std::max(longest_to_rest_s_, now_s - *judged_since_s_);
      not_at_rest_ += at_rest ? 0 : 1;
      judged_since_s_.reset();
    }
    if (returned_at_s_ && (at_rest || armed)) {
      if (!armed) longest_after_return_s_ = std::max(longest_after_return_s_, now_s - *returned_at_s_);
      returned_at_s_.reset();
    }
  }

  void link_returned(double now_s, bool at_rest) {
    if (at_rest || now_s - last_sound_s_ <= limit_s_) return;
    ++runaways_;
    returned_at_s_ = now_s;
  }

  void report(SoakFigures& figures) const {
    figures.blind_segments = segments_;
    figures.not_at_rest_when_blind = not_at_rest_;
    figures.longest_to_rest_s = longest_to_rest_s_;
    figures.runaways = runaways_;
    figures.longest_rest_after_return_s = longest_after_return_s_;
  }

 private:
  static constexpr double longest_braking_s = 0.8;

  double limit_s_;
  double last_sound_s_ = 0.0;
  bool seen_moving_ = false;
  bool in_segment_ = false;
  std::optional<double> judged_since_s_;
  std::optional<double> returned_at_s_;
  std::int64_t segments_ = 0;
  std::int64_t not_at_rest_ = 0;
  std::int64_t runaways_ = 0;
  double longest_to_rest_s_ = 0.0;
  double longest_after_return_s_ = 0.0;
};

}  // namespace wheelwright::soak
