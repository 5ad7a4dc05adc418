#include "model/gap/random_moments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>

namespace wheelwright::gap {
namespace {

constexpr double window_s = 0.3;

// What one channel of one run shows in a short time.
struct Window {
  std::size_t run = 0;
  Channel channel = Channel::left;
  std::size_t index = 0;  // of its time
  double innovations = 0.0;
  double readings = 0.0;
  double error_before = 0.0;  // of the free run, m or rad
  double last_error = 0.0;

  double power() const { return innovations * innovations / readings; }
  double jump() const { return std::abs(last_error - error_before); }
};

bool of_wheels(Channel channel) {
  return channel == Channel::left || channel == Channel::right;
}

std::vector<Window> windows_of(const GapProblem& problem, const TrialModel& model,
                               std::span<const double> residuals, bool wheels) {
  std::vector<RunErrors> errors;
  for (const GapRun& run : problem.runs()) errors.push_back(free_run_errors(model, run));
  std::map<std::tuple<std::size_t, Channel, std::size_t>, Window> all;
  const auto& places = problem.places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& place = places[i];
    if (!place.channel || of_wheels(*place.channel) != wheels || residuals[i] == 0.0) continue;
    const double time_s = problem.runs()[place.run].period_s * static_cast<double>(place.period);
    const auto index = static_cast<std::size_t>(time_s / window_s);
    const auto& error = errors[place.run].series[static_cast<std::size_t>(*place.channel)];
    Window& window = all[{place.run, *place.channel, index}];
    if (window.readings == 0.0) {
      const double before = error[place.reading == 0 ? 0 : place.reading - 1];
      window = {place.run, *place.channel, index, 0.0, 0.0, before, before};
    }
    window.innovations += residuals[i];
    window.readings += 1.0;
    window.last_error = error[place.reading];
  }
  std::vector<Window> windows;
  windows.reserve(all.size());
  for (const auto& [key, window] : all) windows.push_back(window);
  std::ranges::sort(windows, std::greater<>{}, &Window::power);
  return windows;
}

// A slip of the clock moves a wheel by a millimetre or two; that is no such moment.
bool is_large(const Window& window) {
  constexpr double least_jump_m = 0.004;
  constexpr double least_jump_rad = 0.016;
  return window.jump() > (window.channel == Channel::turn ? least_jump_rad : least_jump_m);
}

double power_of(std::span<const Window> windows) {
  double sum = 0.0;
  for (const Window& window : windows) sum += window.power();
  return sum;
}

// `windows`: the strongest first.
std::optional<RandomMoments> moments_among(const GapProblem& problem, std::span<const Window> windows) {
  constexpr std::size_t least_windows = 200;
  constexpr std::ptrdiff_t one_in = 50;
  constexpr double most_of_it = 0.5;
  constexpr std::size_t more_than_chance = 3;
  constexpr double same_moment_s = 1.0;
  if (windows.size() < least_windows) return std::nullopt;
  std::vector<Window> strongest(windows.begin(), windows.begin() + std::ssize(windows) / one_in);
  std::erase_if(strongest, [](const Window& window) { return !is_large(window); });
  RandomMoments found;
  found.share = power_of(strongest) / power_of(windows);
  found.share_of_time = static_cast<double>(strongest.size()) / static_cast<double>(windows.size());
  for (const Window& window : strongest) {
    const GapRun& run = problem.runs()[window.run];
    const double time_s = run.start_s + window_s * static_cast<double>(window.index);
    const auto same = [&](const RandomMoments::Moment& other) {
      return other.run == run.name && std::abs(other.time_s - time_s) < same_moment_s;
    };
    if (std::ranges::none_of(found.moments, same)) found.moments.push_back({run.name, time_s});
  }
  if (found.share < most_of_it || found.moments.size() < more_than_chance) return std::nullopt;
  return found;
}

}  // namespace

std::optional<RandomMoments> random_moments(const GapProblem& problem, const TrialModel& model,
                                            std::span<const double> residuals) {
  const auto in_wheels = moments_among(problem, windows_of(problem, model, residuals, true));
  const auto in_motion = moments_among(problem, windows_of(problem, model, residuals, false));
  return !in_wheels || (in_motion && in_motion->share > in_wheels->share) ? in_motion : in_wheels;
}

}  // namespace wheelwright::gap
