#include "model/gap/candidates/command_spectrum.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "model/gap/candidates/steady_response.hpp"
#include "model/gap/runs/fastest_command.hpp"

namespace wheelwright::gap {
namespace {

using Complex = std::complex<double>;

constexpr double smallest_step_m_s = 0.004;
constexpr double largest_shift_of_phase =
    0.1;  // of a step, at the fastest command, between two that are tried
constexpr double min_nats = 10.0;
constexpr std::size_t max_peaks = 6;

// One channel of a run and what each wheel's travel adds to it.
struct Outlet {
  Channel channel;
  WheelPair of_travel;
};

std::vector<Outlet> outlets_of(const GapRun& run) {
  if (run.has_counts) return {{Channel::left, {1.0, 0.0}}, {Channel::right, {0.0, 1.0}}};
  const double turned = 1.0 / run.wheel_base_m;
  return {{Channel::forward, {0.5, 0.5}}, {Channel::turn, {-turned, turned}}};
}

// What the linear part, behind a delay, makes of changed commands: travel of the wheel at the end of
// each period.
std::vector<Complex> travel_m(const WheelResponse& wheel, const std::vector<double>& own,
                              const std::vector<Complex>& changes, double period_s) {
  std::vector<Complex> speed(changes.size());
  std::vector<Complex> travel(changes.size() + 1);
  for (std::size_t k = 0; k < changes.size(); ++k) {
    Complex sum;
    for (std::size_t j = 0; j < std::min(own.size(), k + 1); ++j) sum += own[j] * changes[k - j];
    for (std::size_t i = 1; i <= std::min(wheel.from_own_past.size(), k); ++i)
      sum += wheel.from_own_past[i - 1] * speed[k - i];
    speed[k] = sum;
    travel[k + 1] = travel[k] + period_s * sum;
  }
  return travel;
}

Complex at(const std::vector<Complex>& travel, const GridTime& when) {
  const std::size_t next = std::min(when.period + 1, travel.size() - 1);
  return travel[when.period] + when.share * (travel[next] - travel[when.period]);
}

// A change of a command: its real and imaginary parts are two changes that are tried at once.
using Change = std::function<Complex(double command_m_s)>;

// What two changes of the commands make of the innovations.
struct Patterns {
  Eigen::VectorXd real;
  Eigen::VectorXd imaginary;
};

class LinearPartResponse {
 public:
  LinearPartResponse(const FitProblem& problem, const TrialModel& model)
      : problem_(problem), linear_part_(model.with_delay_in_linear_part().linear()) {}

  Patterns to(const Change& change) const {
    const auto size = static_cast<Eigen::Index>(problem_.readings());
    Patterns patterns{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
    for (std::size_t r = 0; r < problem_.runs().size(); ++r) add_run(r, change, patterns);
    return patterns;
  }

 private:
  void add_run(std::size_t r, const Change& change, Patterns& patterns) const {
    const GapRun& run = problem_.runs()[r];
    if (run.sparse && !run.has_counts) return;
    std::vector<Complex> of_left;
    std::vector<Complex> of_right;
    for (const WheelPair& u : run.commands_m_s) {
      of_left.push_back(change(u.left));
      of_right.push_back(change(u.right));
    }
    const auto left = travel_m(linear_part_.left, linear_part_.left.from_left, of_left, run.period_s);
    const auto right = travel_m(linear_part_.right, linear_part_.right.from_right, of_right, run.period_s);
    for (const Outlet& outlet : outlets_of(run)) {
      std::vector<double> real;
      std::vector<double> imaginary;
      for (const GridTime& when : run[outlet.channel].at) {
        const Complex travelled =
            outlet.of_travel.left * at(left, when) + outlet.of_travel.right * at(right, when);
        real.push_back(-travelled.real());
        imaginary.push_back(-travelled.imag());
      }
      put(r, outlet.channel, real, patterns.real);
      put(r, outlet.channel, imaginary, patterns.imaginary);
    }
  }
  void put(std::size_t run, Channel channel, const std::vector<double>& errors,
           Eigen::VectorXd& pattern) const {
    const auto white = problem_.innovations(run, channel, errors);
    if (!white) return;
    for (std::size_t i = 0; i < white->values.size(); ++i)
      pattern(static_cast<Eigen::Index>(white->first_residual + i)) = white->values[i];
  }

  const FitProblem& problem_;
  LinearModel linear_part_;
};

double sign_of(double command_m_s) {
  return command_m_s == 0.0 ? 0.0 : std::copysign(1.0, command_m_s);
}

struct Harmonic {
  CommandSteps steps;
  double nats = 0.0;
};

// What the model leaves, beyond what a gain or a loss by sign explains: that would be seen in each step.
class Leftover {
 public:
  Leftover(const FitProblem& problem, const Fit& fit, double fastest_m_s)
      : response_(problem, fit.model),
        passed_on_(fit.model, fastest_m_s),
        left_(Eigen::Map<const Eigen::VectorXd>(fit.residuals.data(),
                                                static_cast<Eigen::Index>(fit.residuals.size()))) {
    Patterns smooth = response_.to([this](double u) { return passed_on_.slope(u) * Complex(u, sign_of(u)); });
    gain_ = smooth.real.stableNormalized();
    loss_ = smooth.imaginary - gain_ * gain_.dot(smooth.imaginary);
    loss_.stableNormalize();
    left_ = beyond(left_);
  }

  // Rounding up at `level_edges` changes commands by step / pi * sin(2 pi (u / step - level_edges)) and
  // higher harmonics.
  Harmonic harmonic(double step_m_s) const {
    const double radians_per_m_s = 2.0 * std::numbers::pi / step_m_s;
    const Patterns patterns = response_.to([&](double u) {
      const double phase = std::abs(u) * radians_per_m_s;
      return passed_on_.slope(u) * sign_of(u) * Complex(std::cos(phase), std::sin(phase));
    });
    Eigen::Matrix2d products;
    products(0, 0) = patterns.real.squaredNorm();
    products(1, 1) = patterns.imaginary.squaredNorm();
    products(0, 1) = products(1, 0) = patterns.real.dot(patterns.imaginary);
    if (!(products.determinant() > 1e-9 * products(0, 0) * products(1, 1))) return {{step_m_s, 0.5}, 0.0};
    const Eigen::Vector2d with_left(patterns.real.dot(left_), patterns.imaginary.dot(left_));
    const Eigen::Vector2d amounts = -products.inverse() * with_left;
    const double phase = std::atan2(-amounts(0), amounts(1)) / (2.0 * std::numbers::pi);
    return {{step_m_s, phase < 0.0 ? phase + 1.0 : phase}, -0.5 * amounts.dot(with_left)};
  }

  // What the steps explain with all harmonics, at about their own size: a linear part that was fitted beside
  // them answers not quite as it should.
  double nats(const CommandSteps& steps, const EffectInfo& info) const {
    const std::array parameters{steps.step_m_s, steps.level_edges};
    const auto effect = info.make({parameters, 0});
    const Eigen::VectorXd change =
        beyond(response_
                   .to([&](double u) {
                     WheelPair acted{u, u};
                     effect->command(acted, {});
                     return Complex(passed_on_.at(acted.left) - passed_on_.at(u), 0.0);
                   })
                   .real);
    const double power = change.squaredNorm();
    const double amount = std::clamp(-change.dot(left_) / power, 0.4, 1.5);
    return -amount * (change.dot(left_) + 0.5 * amount * power);
  }

 private:
  Eigen::VectorXd beyond(const Eigen::VectorXd& pattern) const {
    return pattern - gain_ * gain_.dot(pattern) - loss_ * loss_.dot(pattern);
  }

  LinearPartResponse response_;
  SteadyResponse passed_on_;
  Eigen::VectorXd gain_;
  Eigen::VectorXd loss_;
  Eigen::VectorXd left_;
};

std::vector<double> steps_to_try(double fastest) {
  std::vector<double> steps;
  if (fastest <= 0.0) return steps;
  const double apart = largest_shift_of_phase / fastest;
  for (double per_m_s = 1.0 / smallest_step_m_s; per_m_s > 1.0 / largest_command_step_m_s(fastest);
       per_m_s -= apart)
    steps.push_back(1.0 / per_m_s);
  return steps;
}

// The highest peaks, no two of them neighbours.
std::vector<CommandSteps> peaks_of(const std::vector<Harmonic>& spectrum) {
  std::vector<Harmonic> peaks;
  for (std::size_t i = 1; i + 1 < spectrum.size(); ++i) {
    const double nats = spectrum[i].nats;
    if (nats >= spectrum[i - 1].nats && nats > spectrum[i + 1].nats) peaks.push_back(spectrum[i]);
  }
  std::ranges::sort(peaks, std::greater<>{}, &Harmonic::nats);
  std::vector<CommandSteps> steps;
  for (std::size_t i = 0; i < std::min(max_peaks, peaks.size()); ++i) steps.push_back(peaks[i].steps);
  return steps;
}

// The peaks themselves, and as far around as the next that was tried.
std::vector<CommandSteps> steps_around(const std::vector<CommandSteps>& peaks, double apart_per_m_s) {
  std::vector<CommandSteps> steps;
  for (const auto& [step_m_s, level_edges] : peaks) {
    for (const double shift : {-0.8, -0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6, 0.8}) {
      for (const double rises_later : {-0.1, -0.05, 0.0, 0.05, 0.1}) {
        steps.push_back({1.0 / (1.0 / step_m_s + shift * apart_per_m_s),
                         std::clamp(level_edges + rises_later, 0.0, 1.0)});
      }
    }
  }
  return steps;
}

// Rounding up just above each step and just below it differ by a loss by sign alone: a linear part fitted
// beside each tells which it is.
CommandSteps at_the_right_end(const FitProblem& train, const TrialModel& without, const EffectInfo& info,
                              const CommandSteps& found) {
  constexpr double end = 0.15;
  constexpr int max_steps = 4;
  if (found.level_edges > end && found.level_edges < 1.0 - end) return found;
  const CommandSteps other{found.step_m_s, found.level_edges > 0.5 ? 0.0 : 1.0};
  const auto sum_squares = [&](const CommandSteps& steps) {
    TrialModel model = without;
    model.effects.push_back({&info, 0, {steps.step_m_s, steps.level_edges}});
    return train.fit(model, max_steps).sum_squares;
  };
  return sum_squares(other) < sum_squares(found) ? other : found;
}

}  // namespace

std::optional<CommandSteps> find_steps_by_spectrum(const FitProblem& train, const Fit& fit,
                                                   const EffectInfo& info, const ParallelFor& parallel_for) {
  const double fastest_m_s = fastest_command_m_s(train.runs());
  const std::vector<double> tried = steps_to_try(fastest_m_s);
  if (tried.size() < 3) return std::nullopt;
  const Leftover leftover(train, fit, fastest_m_s);
  std::vector<Harmonic> spectrum(tried.size());
  parallel_for(tried.size(), [&](std::size_t i) { spectrum[i] = leftover.harmonic(tried[i]); });
  const auto steps = steps_around(peaks_of(spectrum), 1.0 / tried[1] - 1.0 / tried[0]);
  std::vector<double> nats(steps.size());
  parallel_for(steps.size(), [&](std::size_t i) { nats[i] = leftover.nats(steps[i], info); });
  const auto best = std::ranges::max_element(nats);
  if (best == nats.end() || *best < min_nats) return std::nullopt;
  return at_the_right_end(train, fit.model, info, steps[static_cast<std::size_t>(best - nats.begin())]);
}

}  // namespace wheelwright::gap
