#include "model/gap/candidates/wheel_eccentricity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

// Circumferences, in wheel bases: 0.7 on a TurtleBot 3 Waffle, 1 on a Roomba, 1.8 on a Husky.
constexpr double smallest_wheel = 0.5;
constexpr double largest_wheel = 2.2;

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

struct WheelShare {
  Channel channel;
  WheelPair share;
};

// Where a ripple shows: in the counts, or in what the body does.
std::vector<WheelShare> watched(const GapRun& run, EffectStage stage) {
  if (stage == EffectStage::wheel && run.has_counts) {
    return {{Channel::left, {1.0, 0.0}}, {Channel::right, {0.0, 1.0}}};
  }
  const double turn = 1.0 / run.wheel_base_m;
  return {{Channel::forward, {0.5, 0.5}}, {Channel::turn, {-turn, turn}}};
}

// A speed of 1 + s sin(angle) + c cos(angle) adds s (-cos) + c sin to the travel, over the angle per metre.
Eigen::Matrix<double, Eigen::Dynamic, 4> patterns(const std::vector<WheelPair>& rolled_m,
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
TurnRates turn_rates(double longest_m, double wheel_base_m) {
  return {1.0 / (largest_wheel * wheel_base_m), 1.0 / (smallest_wheel * wheel_base_m), 0.5 / longest_m};
}

// Between those that were tried.
TurnRates context(double rate, double apart) {
  return {rate - apart, rate + apart, 0.1 * apart};
}

}  // namespace

RippleEquations& RippleEquations::operator+=(const RippleEquations& other) {
  products += other.products;
  right_side += other.right_side;
  return *this;
}

RippleAmounts RippleEquations::solution() const {
  const double little = 1e-9 * products.diagonal().maxCoeff() + 1e-30;
  return solve_symmetric(products + little * Eigen::Matrix4d::Identity(), right_side);
}

RippleSearch::RippleSearch(const FitProblem& problem, const std::vector<WheelPair>& initial_travel_m,
                           const TrialModel& model, EffectStage stage)
    : problem_(problem) {
  for (std::size_t r = 0; r < problem.runs().size(); ++r) {
    const GapRun& run = problem.runs()[r];
    RunTravel travel;
    for (const auto& [channel, share] : watched(run, stage)) {
      if (run[channel].empty()) continue;
      travel.push_back({channel, share, rolled_at(run, initial_travel_m[r], model, channel)});
    }
    runs_.push_back(std::move(travel));
  }
}

RippleEquations RippleSearch::equations(std::size_t run, const std::vector<double>& residuals,
                                        double circumference_m) const {
  const double per_metre = 2.0 * std::numbers::pi / circumference_m;
  RippleEquations sum;
  for (const auto& [channel, share, rolled_m] : runs_[run]) {
    auto columns = patterns(rolled_m, share, per_metre);
    const Eigen::Index count = columns.rows();
    std::size_t first_residual = 0;
    for (Eigen::Index amount = 0; amount < 4; ++amount) {
      if ((amount < 2 ? share.left : share.right) == 0.0) continue;
      const std::span<const double> pattern(columns.col(amount).data(), static_cast<std::size_t>(count));
      const auto white = problem_.innovations(run, channel, pattern);
      if (!white) return {};
      first_residual = white->first_residual;
      columns.col(amount) = Eigen::Map<const Eigen::VectorXd>(white->values.data(), count);
    }
    const Eigen::Map<const Eigen::VectorXd> left_over(residuals.data() + first_residual, count);
    sum.products += columns.transpose() * columns;
    sum.right_side += columns.transpose() * left_over;
  }
  return sum;
}

Ripple RippleSearch::at(const std::vector<double>& residuals, double circumference_m) const {
  Ripple ripple;
  ripple.circumference_m = circumference_m;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const RippleEquations of_run = equations(r, residuals, circumference_m);
    ripple.nats += of_run.nats();
    ripple.of_run.push_back(of_run.solution());
    ripple.together += of_run;
  }
  return ripple;
}

Ripple RippleSearch::strongest(const std::vector<double>& residuals, RippleAngle angle,
                               const ParallelFor& parallel_for) const {
  const auto nats = [angle](const Ripple& ripple) {
    return angle == RippleAngle::of_each_run ? ripple.nats : ripple.together.nats();
  };
  const auto best_of = [&](const TurnRates& rates) {
    const std::vector<double> tried = rates.all();
    std::vector<Ripple> ripples(tried.size());
    parallel_for(tried.size(), [&](std::size_t i) { ripples[i] = at(residuals, 1.0 / tried[i]); });
    return *std::ranges::max_element(ripples, {}, nats);
  };
  const TurnRates all = turn_rates(longest_way_m(), problem_.runs().front().wheel_base_m);
  return best_of(context(1.0 / best_of(all).circumference_m, all.apart));
}

double RippleSearch::longest_way_m() const {
  double longest_m = 1.0;
  for (const auto& travel : runs_) {
    for (const auto& watched : travel) {
      const auto [least, most] = std::ranges::minmax(watched.rolled_m, {}, &WheelPair::left);
      longest_m = std::max(longest_m, most.left - least.left);
    }
  }
  return longest_m;
}

}  // namespace wheelwright::gap
