#include "model/filter/fault_detector.hpp"

#include <algorithm>
#include <cmath>

namespace wheelwright {
namespace {

constexpr double drift_gate = 7.0;
// The other wheel leaves the model too: then it is the model.
constexpr double shared_drift = 0.4;
constexpr double swap_least_difference_m = 0.010;
constexpr double swap_fit = 0.25;  // of that difference
constexpr double both_misfit_s = 2.0;
constexpr double misfits_fade_s = 60.0;
constexpr double too_many_misfits = 3.5;
constexpr double slip_excess_a = 0.25;
constexpr double slip_after_s = 0.5;

FaultyWheel side_of(std::size_t wheel) {
  return wheel == 0 ? FaultyWheel::left : FaultyWheel::right;
}

}  // namespace

FaultDetector::FaultDetector(double period_s) : period_s_(period_s), sides_{Side(period_s), Side(period_s)} {}

void FaultDetector::look_for_misfit(std::size_t wheel, const TickEvidence& evidence, FaultEvents& events) {
  Side& side = sides_[wheel];
  const WheelEvidence& seen = evidence.wheels[wheel];
  const auto tell = [&](FaultEvent::Stage stage, double size) {
    events.add({stage, side.kind, side_of(wheel), evidence.tick, size});
  };
  if (side.kind == FaultKind::none) {
    if (!seen.suspended) return side.classifier.watch(seen);
    side.kind = FaultKind::misfit;
    side.recent_misfits += 1.0;
    side.classifier.open();
    side.classifier.take(seen);
    return tell(FaultEvent::Stage::began, seen.innovation_m);
  }
  side.classifier.take(seen);
  if (side.kind == FaultKind::misfit) {
    if (seen.resynchronised) {
      side.kind = side.classifier.name_at_end(seen.kept_out_m);
    } else {
      side.kind = side.classifier.is_stall() ? FaultKind::stalled : side.classifier.name_by_now();
    }
    const double size = side.kind == FaultKind::stalled ? seen.excess_a : seen.innovation_m;
    if (side.kind != FaultKind::misfit) tell(FaultEvent::Stage::named, size);
  } else if (side.kind == FaultKind::frozen && side.classifier.is_stall()) {
    side.kind = FaultKind::stalled;
    tell(FaultEvent::Stage::named, seen.excess_a);
  }
  if (!seen.resynchronised && evidence.driven) return;
  if (side.kind == FaultKind::stalled && evidence.driven) return;
  tell(FaultEvent::Stage::ended, seen.kept_out_m);
  side.kind = FaultKind::none;
}

// Each encoder shows what the other wheel was to do, and the wheels were to do different things.
bool FaultDetector::are_swapped(const TickEvidence& evidence) const {
  const FaultClassifier& left = sides_[0].classifier;
  const FaultClassifier& right = sides_[1].classifier;
  const auto open = [](FaultKind kind) { return kind == FaultKind::misfit || kind == FaultKind::dropped; };
  if (!open(sides_[0].kind) || !open(sides_[1].kind)) return false;
  const double difference_m = std::abs(left.predicted_m() - right.predicted_m());
  const double noise_m = std::max(evidence.wheels[0].reading_sd_m, evidence.wheels[1].reading_sd_m);
  if (difference_m < std::max(swap_least_difference_m, 8.0 * noise_m)) return false;
  const double allowed_m = swap_fit * difference_m + 2.0 * noise_m;
  return std::abs(left.counted_m() - right.predicted_m()) < allowed_m &&
         std::abs(right.counted_m() - left.predicted_m()) < allowed_m;
}

// Two encoders do not drift at once: where both wheels leave the model, it is the model. The second of them
// may do so in steps of any size.
void FaultDetector::look_for_drift(const TickEvidence& evidence, FaultVerdict& verdict, FaultEvents& events) {
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    Side& side = sides_[wheel];
    if (side.kind != FaultKind::none) continue;
    const double statistic = evidence.drift_statistic[wheel];
    const double other = evidence.drift_statistic[1 - wheel];
    const bool drifts = std::abs(statistic) > drift_gate;
    const bool alike = other * statistic > 0.0 && std::abs(other) > shared_drift * std::abs(statistic);
    const bool follows = sides_[1 - wheel].kind == FaultKind::drifting &&
                         std::abs(evidence.whole_drift_statistic[wheel]) > drift_gate;
    if (follows || (drifts && alike)) {
      verdict.model_is_off = true;
      continue;
    }
    if (!drifts) continue;
    side.kind = FaultKind::drifting;
    verdict.take_out_m[wheel] = evidence.drift_collected_m[wheel];
    for (const auto stage : {FaultEvent::Stage::began, FaultEvent::Stage::named}) {
      events.add({stage, side.kind, side_of(wheel), evidence.tick, evidence.drift_collected_m[wheel]});
    }
  }
}

void FaultDetector::look_for_stall_end(std::size_t wheel, const TickEvidence& evidence, FaultEvents& events) {
  Side& side = sides_[wheel];
  const WheelEvidence& seen = evidence.wheels[wheel];
  constexpr double fade = 0.9;
  if (side.kind != FaultKind::stalled) {
    side.predicted_m = side.turned_m = 0.0;
    return;
  }
  side.predicted_m = fade * side.predicted_m + std::abs(seen.predicted_m);
  side.turned_m = fade * side.turned_m + std::abs(seen.counted_m);
  if (side.predicted_m < 0.005 || side.turned_m < 0.6 * side.predicted_m) return;
  events.add({FaultEvent::Stage::ended, side.kind, side_of(wheel), evidence.tick, seen.excess_a});
  side.kind = FaultKind::none;
}

// What was taken for drifting encoders was the model.
void FaultDetector::end_drifts(const TickEvidence& evidence, FaultEvents& events) {
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    if (sides_[wheel].kind != FaultKind::drifting) continue;
    events.add({FaultEvent::Stage::ended, FaultKind::drifting, side_of(wheel), evidence.tick,
                evidence.drift_collected_m[wheel]});
    sides_[wheel].kind = FaultKind::none;
  }
}

// Faults come to one wheel at a time. Where both misfit for long, or again and again, it is the model.
bool FaultDetector::both_misfit(const TickEvidence& evidence) {
  bool open = evidence.driven;
  bool often = evidence.driven;
  for (Side& side : sides_) {
    open = open && side.kind != FaultKind::none && side.kind != FaultKind::swapped;
    side.recent_misfits *= 1.0 - period_s_ / misfits_fade_s;
    often = often && side.recent_misfits > too_many_misfits;
  }
  both_open_s_ = open ? both_open_s_ + period_s_ : 0.0;
  return often || both_open_s_ > both_misfit_s;
}

void FaultDetector::look_for_slip(const TickEvidence& evidence, FaultEvents& events) {
  const auto& [left, right] = evidence.wheels;
  const bool held = left.excess_a > slip_excess_a && right.excess_a > slip_excess_a && left.accepted &&
                    right.accepted && evidence.driven;
  held_s_ = held ? held_s_ + period_s_ : 0.0;
  const double size = std::max(left.excess_a, right.excess_a);
  if (!slips_ && held_s_ > slip_after_s) {
    slips_ = true;
    for (const auto stage : {FaultEvent::Stage::began, FaultEvent::Stage::named}) {
      events.add({stage, FaultKind::slipping, FaultyWheel::both, evidence.tick, size});
    }
  } else if (slips_ && !held) {
    slips_ = false;
    events.add({FaultEvent::Stage::ended, FaultKind::slipping, FaultyWheel::both, evidence.tick, size});
  }
}

void FaultDetector::look_for_lift(const TickEvidence& evidence, FaultEvents& events) {
  if (lifted_ == evidence.wheel_drop) return;
  lifted_ = evidence.wheel_drop;
  const FaultEvent event{FaultEvent::Stage::ended, FaultKind::lifted, FaultyWheel::both, evidence.tick, 0.0};
  if (lifted_) {
    for (const auto stage : {FaultEvent::Stage::began, FaultEvent::Stage::named}) {
      events.add({stage, event.kind, event.wheel, event.tick, event.size});
    }
  } else {
    events.add(event);
  }
}

// The robot stops itself before a misfit has grown: what its motor says then is enough, if the wheel stands.
void FaultDetector::look_for_overcurrent(const TickEvidence& evidence, FaultEvents& events) {
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    Side& side = sides_[wheel];
    const WheelEvidence& seen = evidence.wheels[wheel];
    const bool stands = std::abs(seen.counted_m) < 0.5 * std::abs(seen.predicted_m);
    const bool began = evidence.overcurrent[wheel] && !side.overcurrent;
    side.overcurrent = evidence.overcurrent[wheel];
    if (!began || !stands || side.kind == FaultKind::stalled) continue;
    if (side.kind == FaultKind::none) {
      events.add(
          {FaultEvent::Stage::began, FaultKind::stalled, side_of(wheel), evidence.tick, seen.excess_a});
    }
    side.kind = FaultKind::stalled;
    events.add({FaultEvent::Stage::named, FaultKind::stalled, side_of(wheel), evidence.tick, seen.excess_a});
  }
}

FaultVerdict FaultDetector::take(const TickEvidence& evidence, FaultEvents& events) {
  FaultVerdict verdict;
  look_for_lift(evidence, events);
  look_for_overcurrent(evidence, events);
  if (evidence.counter_jumped) {
    for (const auto stage : {FaultEvent::Stage::began, FaultEvent::Stage::named, FaultEvent::Stage::ended}) {
      events.add({stage, FaultKind::spike, FaultyWheel::both, evidence.tick, 0.0});
    }
  }
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    look_for_stall_end(wheel, evidence, events);
    if (sides_[wheel].kind != FaultKind::drifting) look_for_misfit(wheel, evidence, events);
  }
  if (are_swapped(evidence)) {
    verdict.exchange = true;
    events.add({FaultEvent::Stage::named, FaultKind::swapped, FaultyWheel::both, evidence.tick,
                evidence.wheels[0].innovation_m});
    sides_[0].kind = sides_[1].kind = FaultKind::swapped;
  }
  look_for_drift(evidence, verdict, events);
  look_for_slip(evidence, events);
  verdict.model_is_off = both_misfit(evidence) || verdict.model_is_off;
  if (verdict.model_is_off) end_drifts(evidence, events);
  for (std::size_t wheel = 0; wheel < 2; ++wheel) {
    verdict.stalled[wheel] = sides_[wheel].kind == FaultKind::stalled;
    verdict.distrust[wheel] = sides_[wheel].kind == FaultKind::drifting;
  }
  return verdict;
}

}  // namespace wheelwright
