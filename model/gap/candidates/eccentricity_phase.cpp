#include "model/gap/candidates/eccentricity_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/gap/candidates/wheel_eccentricity.hpp"

namespace wheelwright::gap {
namespace {

constexpr double min_nats_a_run = 6.0;
constexpr double one_angle_explains = 0.7;   // of what an angle for each run explains: then one is enough
constexpr double furthest_counted_m = 30.0;  // between the runs' first counts: beyond, the angle is lost

// How far the wheels had rolled before each run.
struct RolledBefore {
  std::vector<WheelPair> train_m;
  std::vector<WheelPair> heldout_m;
};

RolledBefore nothing_rolled(const FitProblem& train, const FitProblem& heldout) {
  return {std::vector<WheelPair>(train.runs().size()), std::vector<WheelPair>(heldout.runs().size())};
}

// By what the runs' first counts stand at, from the least on; nothing where they are no help.
RolledBefore counted_before(const FitProblem& train, const FitProblem& heldout) {
  RolledBefore counted = nothing_rolled(train, heldout);
  WheelPair least{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  WheelPair most{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  const auto each = [&](const auto& visit) {
    for (std::size_t r = 0; r < train.runs().size(); ++r) visit(train.runs()[r], counted.train_m[r]);
    for (std::size_t r = 0; r < heldout.runs().size(); ++r) visit(heldout.runs()[r], counted.heldout_m[r]);
  };
  bool known = true;
  each([&](const GapRun& run, WheelPair& before) {
    known = known && run.has_counts;
    if (!run.has_counts) return;
    before = {run[Channel::left].value.front(), run[Channel::right].value.front()};
    least = {std::min(least.left, before.left), std::min(least.right, before.right)};
    most = {std::max(most.left, before.left), std::max(most.right, before.right)};
  });
  if (!known || std::max(most.left - least.left, most.right - least.right) > furthest_counted_m)
    return nothing_rolled(train, heldout);
  each([&](const GapRun&, WheelPair& before) {
    before = {before.left - least.left, before.right - least.right};
  });
  return counted;
}

// The way after which a pure sine has the angle of these amounts.
std::vector<WheelPair> ways_before(const Ripple& ripple) {
  const double per_metre = 2.0 * std::numbers::pi / ripple.circumference_m;
  std::vector<WheelPair> ways;
  for (const RippleAmounts& a : ripple.of_run) {
    ways.push_back({std::atan2(a(1), a(0)) / per_metre, std::atan2(a(3), a(2)) / per_metre});
  }
  return ways;
}

double mean_size(const Ripple& ripple, Eigen::Index sine) {
  double sum = 0.0;
  for (const RippleAmounts& a : ripple.of_run) sum += std::hypot(a(sine), a(sine + 1));
  return sum / static_cast<double>(ripple.of_run.size());
}

// Looks for a wheel's ripple in some runs and takes it to others.
class AngleSearch {
 public:
  AngleSearch(const FitProblem& train, const FitProblem& heldout, const Fit& fit, const EffectInfo& info,
              const ParallelFor& parallel_for)
      : train_(train), heldout_(heldout), fit_(fit), info_(info), parallel_for_(parallel_for) {}

  std::optional<WheelAngles> run() {
    const RolledBefore nothing = nothing_rolled(train_, heldout_);
    Ripple best;
    for (std::size_t variant = 0; variant < info_.variants.size(); ++variant) {
      const Ripple ripple = strongest(variant, nothing, RippleAngle::of_each_run);
      if (ripple.nats <= best.nats) continue;
      best = ripple;
      variant_ = variant;
    }
    if (best.nats < min_nats_a_run * static_cast<double>(train_.runs().size())) return std::nullopt;
    for (const RolledBefore& before : {nothing, counted_before(train_, heldout_)}) {
      if (auto found = with_one_angle(before, best)) return found;
    }
    WheelAngles found{{&info_, variant_, {}}, ways_before(best), {}, true};
    found.heldout_rolled_m = ways_before(beyond(best.circumference_m, nothing));
    found.start.parameters = {mean_size(best, 0), 0.0, mean_size(best, 2), 0.0, best.circumference_m};
    found.start = found.start.within_bounds();
    return found;
  }

 private:
  Ripple strongest(std::size_t variant, const RolledBefore& before, RippleAngle angle) const {
    const RippleSearch search(train_, before.train_m, fit_.model, info_.variants[variant].stage);
    return search.strongest(fit_.residuals, angle, parallel_for_);
  }

  Ripple beyond(double circumference_m, const RolledBefore& before) const {
    const RippleSearch search(heldout_, before.heldout_m, fit_.model, info_.variants[variant_].stage);
    return search.at(heldout_.residuals(fit_.model), circumference_m);
  }

  std::optional<WheelAngles> with_one_angle(const RolledBefore& before, const Ripple& of_each) const {
    const Ripple ripple = strongest(variant_, before, RippleAngle::of_all_runs);
    const Ripple further = beyond(ripple.circumference_m, before);
    RippleEquations together = ripple.together;
    together += further.together;
    if (together.nats() < one_angle_explains * (of_each.nats + further.nats)) return std::nullopt;
    const RippleAmounts a = ripple.together.solution();
    const TrialEffect start{&info_, variant_, {a(0), a(1), a(2), a(3), ripple.circumference_m}};
    return WheelAngles{start.within_bounds(), before.train_m, before.heldout_m, false};
  }

  const FitProblem& train_;
  const FitProblem& heldout_;
  const Fit& fit_;
  const EffectInfo& info_;
  const ParallelFor& parallel_for_;
  std::size_t variant_ = 0;
};

}  // namespace

std::optional<WheelAngles> find_eccentricity_phases(const FitProblem& train, const FitProblem& heldout,
                                                    const Fit& fit, const EffectInfo& info,
                                                    const ParallelFor& parallel_for) {
  return AngleSearch(train, heldout, fit, info, parallel_for).run();
}

}  // namespace wheelwright::gap
