#include "model/gap/wheel_angles.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wheelwright::gap {
namespace {

// Circumferences, in wheel bases: 0.7 on a TurtleBot 3 Waffle, 1 on a Roomba, 1.8 on a Husky.
constexpr double smallest_wheel = 0.5;
constexpr double largest_wheel = 2.2;
constexpr double least_nats_a_run = 6.0;
constexpr double one_angle_explains = 0.7;   // of what an angle for each run explains: then one is enough
constexpr double furthest_counted_m = 30.0;  // between the runs' first counts: beyond, the angle is lost

// Sine and cosine of the left wheel, then of the right one.
using Amounts = Eigen::Vector4d;

// Normal equations of a run's residuals on the four templates.
struct Normal {
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  Amounts right_side = Amounts::Zero();

  Amounts solution() const {
    const double little = 1e-9 * products.diagonal().maxCoeff() + 1e-30;
    return (products + little * Eigen::Matrix4d::Identity()).ldlt().solve(right_side);
  }
  double nats() const { return 0.5 * right_side.dot(solution()); }
};

// How far the wheels had rolled before each run.
struct RolledBefore {
  std::vector<WheelPair> train_m;
  std::vector<WheelPair> heldout_m;
};

RolledBefore nothing_rolled(const GapProblem& train, const GapProblem& heldout) {
  return {std::vector<WheelPair>(train.runs().size()), std::vector<WheelPair>(heldout.runs().size())};
}

// By what the runs' first counts stand at, from the least on; nothing where they are no help.
RolledBefore counted_before(const GapProblem& train, const GapProblem& heldout) {
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

// How far the wheels have rolled at each reading of a channel.
std::vector<WheelPair> rolled_at(const GapRun& run, const WheelPair& before_m, const TrialModel& model,
                                 Channel channel) {
  std::vector<WheelPair> grid{before_m};
  if (run.has_counts) {
    for (const auto& step : run.odometry) {
      const double half = 0.5 * step.turn_rad * run.wheel_base_m;
      grid.push_back({grid.back().left + step.forward_m - half, grid.back().right + step.forward_m + half});
    }
  } else {
    for (const auto& state : model_states(model, run)) grid.push_back(state.distance_m);
  }
  std::vector<WheelPair> rolled;
  for (const auto& at : run[channel].at) {
    const WheelPair& a = grid[std::min(at.period, grid.size() - 1)];
    const WheelPair& b = grid[std::min(at.period + 1, grid.size() - 1)];
    rolled.push_back({a.left + at.share * (b.left - a.left), a.right + at.share * (b.right - a.right)});
  }
  return rolled;
}

struct Watched {
  Channel channel;
  WheelPair share;  // of each wheel's travel in this channel
};

// Where a ripple shows: in the counts, or in what the body does.
std::vector<Watched> watched(const GapRun& run, EffectStage stage) {
  if (stage == EffectStage::wheel && run.has_counts) {
    return {{Channel::left, {1.0, 0.0}}, {Channel::right, {0.0, 1.0}}};
  }
  const double turn = 1.0 / run.wheel_base_m;
  return {{Channel::forward, {0.5, 0.5}}, {Channel::turn, {-turn, turn}}};
}

struct RunTravel {
  std::size_t run;
  std::vector<Watched> channels;
  std::vector<std::vector<WheelPair>> rolled_m;  // of each channel
};

std::vector<RunTravel> travels(const GapProblem& problem, const std::vector<WheelPair>& before_m,
                               const TrialModel& model, EffectStage stage) {
  std::vector<RunTravel> all;
  for (std::size_t r = 0; r < problem.runs().size(); ++r) {
    const GapRun& run = problem.runs()[r];
    RunTravel travel{r, {}, {}};
    for (const auto& channel : watched(run, stage)) {
      if (run[channel.channel].empty()) continue;
      travel.channels.push_back(channel);
      travel.rolled_m.push_back(rolled_at(run, before_m[r], model, channel.channel));
    }
    all.push_back(std::move(travel));
  }
  return all;
}

// A speed of 1 + s sin(angle) + c cos(angle) adds s (-cos) + c sin to the travel, over the angle per metre.
Eigen::Matrix<double, Eigen::Dynamic, 4> templates(const std::vector<WheelPair>& rolled_m,
                                                   const WheelPair& share, double per_metre) {
  Eigen::Matrix<double, Eigen::Dynamic, 4> columns(static_cast<Eigen::Index>(rolled_m.size()), 4);
  columns.setZero();
  for (std::size_t i = 0; i < rolled_m.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (share.left != 0.0) {
      columns(row, 0) = -share.left / per_metre * std::cos(per_metre * rolled_m[i].left);
      columns(row, 1) = share.left / per_metre * std::sin(per_metre * rolled_m[i].left);
    }
    if (share.right != 0.0) {
      columns(row, 2) = -share.right / per_metre * std::cos(per_metre * rolled_m[i].right);
      columns(row, 3) = share.right / per_metre * std::sin(per_metre * rolled_m[i].right);
    }
  }
  return columns;
}

Normal normal_equations(const GapProblem& problem, const RunTravel& travel,
                        const std::vector<double>& residuals, double circumference_m) {
  const double per_metre = 2.0 * std::numbers::pi / circumference_m;
  Normal normal;
  for (std::size_t c = 0; c < travel.channels.size(); ++c) {
    const auto& [channel, share] = travel.channels[c];
    auto columns = templates(travel.rolled_m[c], share, per_metre);
    const Eigen::Index count = columns.rows();
    std::size_t first_residual = 0;
    for (Eigen::Index amount = 0; amount < 4; ++amount) {
      if ((amount < 2 ? share.left : share.right) == 0.0) continue;
      const std::span<const double> pattern(columns.col(amount).data(), static_cast<std::size_t>(count));
      const auto white = problem.innovations(travel.run, channel, pattern);
      if (!white) return {};
      first_residual = white->first_residual;
      columns.col(amount) = Eigen::Map<const Eigen::VectorXd>(white->values.data(), count);
    }
    const Eigen::Map<const Eigen::VectorXd> left_over(residuals.data() + first_residual, count);
    normal.products += columns.transpose() * columns;
    normal.right_side += columns.transpose() * left_over;
  }
  return normal;
}

// Turns of a wheel in a metre.
struct TurnRates {
  double least;
  double most;
  double apart;

  std::vector<double> all() const {
    std::vector<double> rates;
    for (double rate = least; rate <= most; rate += apart) rates.push_back(rate);
    return rates;
  }
};

// So fine that the angle is right from one end of the longest way to the other.
TurnRates turn_rates(const std::vector<RunTravel>& travels, double wheel_base_m) {
  double longest_m = 1.0;
  for (const auto& travel : travels) {
    for (const auto& rolled : travel.rolled_m) {
      const auto [least, most] = std::ranges::minmax(rolled, {}, &WheelPair::left);
      longest_m = std::max(longest_m, most.left - least.left);
    }
  }
  return {1.0 / (largest_wheel * wheel_base_m), 1.0 / (smallest_wheel * wheel_base_m), 0.5 / longest_m};
}

// Between those that were tried.
TurnRates around(double rate, double apart) {
  return {rate - apart, rate + apart, 0.1 * apart};
}

struct Ripple {
  double circumference_m = 0.0;
  double nats = 0.0;  // with an angle for each run
  std::vector<Amounts> of_run;
  Normal together;  // with one angle for all
};

Ripple ripple_of(const GapProblem& problem, const std::vector<RunTravel>& travels,
                 const std::vector<double>& residuals, double circumference_m) {
  Ripple ripple;
  ripple.circumference_m = circumference_m;
  for (const auto& travel : travels) {
    const Normal normal = normal_equations(problem, travel, residuals, circumference_m);
    ripple.nats += normal.nats();
    ripple.of_run.push_back(normal.solution());
    ripple.together.products += normal.products;
    ripple.together.right_side += normal.right_side;
  }
  return ripple;
}

double of_each_run(const Ripple& ripple) {
  return ripple.nats;
}

double of_all_runs(const Ripple& ripple) {
  return ripple.together.nats();
}

Ripple strongest_ripple(const GapProblem& problem, const std::vector<RunTravel>& travels,
                        const std::vector<double>& residuals, double (*nats)(const Ripple&),
                        const ForEach& for_each) {
  const auto best_of = [&](const TurnRates& rates) {
    const std::vector<double> tried = rates.all();
    std::vector<Ripple> ripples(tried.size());
    for_each(tried.size(),
             [&](std::size_t i) { ripples[i] = ripple_of(problem, travels, residuals, 1.0 / tried[i]); });
    return *std::ranges::max_element(ripples, {}, nats);
  };
  const TurnRates all = turn_rates(travels, problem.runs().front().wheel_base_m);
  return best_of(around(1.0 / best_of(all).circumference_m, all.apart));
}

// The way after which a pure sine has the angle of these amounts.
std::vector<WheelPair> ways_before(const Ripple& ripple) {
  const double per_metre = 2.0 * std::numbers::pi / ripple.circumference_m;
  std::vector<WheelPair> ways;
  for (const Amounts& a : ripple.of_run) {
    ways.push_back({std::atan2(a(1), a(0)) / per_metre, std::atan2(a(3), a(2)) / per_metre});
  }
  return ways;
}

double mean_size(const Ripple& ripple, Eigen::Index sine) {
  double sum = 0.0;
  for (const Amounts& a : ripple.of_run) sum += std::hypot(a(sine), a(sine + 1));
  return sum / static_cast<double>(ripple.of_run.size());
}

// Looks for a wheel's ripple in some runs and takes it to others.
class AngleSearch {
 public:
  AngleSearch(const GapProblem& train, const GapProblem& heldout, const GapFit& fit, const EffectInfo& info,
              const ForEach& for_each)
      : train_(train), heldout_(heldout), fit_(fit), info_(info), for_each_(for_each) {}

  std::optional<WheelAngles> run() {
    const RolledBefore nothing = nothing_rolled(train_, heldout_);
    Ripple best;
    for (std::size_t variant = 0; variant < info_.variants.size(); ++variant) {
      const Ripple ripple = strongest(variant, nothing, of_each_run);
      if (ripple.nats <= best.nats) continue;
      best = ripple;
      variant_ = variant;
    }
    if (best.nats < least_nats_a_run * static_cast<double>(train_.runs().size())) return std::nullopt;
    for (const RolledBefore& before : {nothing, counted_before(train_, heldout_)}) {
      if (auto found = with_one_angle(before, best)) return found;
    }
    WheelAngles found{{&info_, variant_, {}}, ways_before(best), {}, true};
    found.heldout_rolled_m = ways_before(beyond(best.circumference_m, nothing));
    found.start.parameters = {mean_size(best, 0), 0.0, mean_size(best, 2), 0.0, best.circumference_m};
    return found;
  }

 private:
  Ripple strongest(std::size_t variant, const RolledBefore& before, double (*nats)(const Ripple&)) const {
    const auto travel = travels(train_, before.train_m, fit_.model, info_.variants[variant].stage);
    return strongest_ripple(train_, travel, fit_.residuals, nats, for_each_);
  }

  Ripple beyond(double circumference_m, const RolledBefore& before) const {
    const auto travel = travels(heldout_, before.heldout_m, fit_.model, info_.variants[variant_].stage);
    return ripple_of(heldout_, travel, heldout_.residuals(fit_.model), circumference_m);
  }

  std::optional<WheelAngles> with_one_angle(const RolledBefore& before, const Ripple& of_each) const {
    const Ripple ripple = strongest(variant_, before, of_all_runs);
    const Ripple further = beyond(ripple.circumference_m, before);
    Normal together = ripple.together;
    together.products += further.together.products;
    together.right_side += further.together.right_side;
    if (together.nats() < one_angle_explains * (of_each.nats + further.nats)) return std::nullopt;
    const Amounts a = ripple.together.solution();
    return WheelAngles{{&info_, variant_, {a(0), a(1), a(2), a(3), ripple.circumference_m}},
                       before.train_m,
                       before.heldout_m,
                       false};
  }

  const GapProblem& train_;
  const GapProblem& heldout_;
  const GapFit& fit_;
  const EffectInfo& info_;
  const ForEach& for_each_;
  std::size_t variant_ = 0;
};

}  // namespace

std::optional<WheelAngles> find_wheel_angles(const GapProblem& train, const GapProblem& heldout,
                                             const GapFit& fit, const EffectInfo& info,
                                             const ForEach& for_each) {
  return AngleSearch(train, heldout, fit, info, for_each).run();
}

}  // namespace wheelwright::gap
