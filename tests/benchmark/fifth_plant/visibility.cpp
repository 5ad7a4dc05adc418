#include "tests/benchmark/fifth_plant/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/benchmark/plants/comparison.hpp"
#include "tests/benchmark/plants/least_squares.hpp"

namespace plants::fifth {

namespace {

constexpr std::array windows_s{0.3, 1.5};
constexpr double memory_s = 3.0;
constexpr std::size_t lags = 15;

// What a window shows of a run.
using Channel = std::function<double(const Run& run, std::size_t from, std::size_t to)>;

Channel counted(std::size_t wheel) {
  return [wheel](const Run& run, std::size_t from, std::size_t to) {
    return run.log.metres_per_tick *
           static_cast<double>(run.log.rows[to].ticks[wheel] - run.log.rows[from].ticks[wheel]);
  };
}

// As seen from the pose at the beginning of the window.
Channel moved(bool sideways) {
  return [sideways](const Run& run, std::size_t from, std::size_t to) {
    const TrueRow& start = run.truth[from];
    const double x_m = run.truth[to].reference_point.x_m - start.reference_point.x_m;
    const double y_m = run.truth[to].reference_point.y_m - start.reference_point.y_m;
    const double cosine = std::cos(start.heading_rad);
    const double sine = std::sin(start.heading_rad);
    return sideways ? cosine * y_m - sine * x_m : cosine * x_m + sine * y_m;
  };
}

double turned(const Run& run, std::size_t from, std::size_t to) {
  return run.truth[to].heading_rad - run.truth[from].heading_rad;
}

struct Difference {
  double mean_square;
  double bent_mean_square;
};

Difference difference(const std::vector<Run>& ones, const std::vector<Run>& others, const Channel& channel,
                      double window_s) {
  LeastSquares fit(lags * wheel_count);
  for (std::size_t index = 0; index < ones.size(); ++index) {
    const double period_s = ones[index].log.period_s;
    const auto window_rows = static_cast<std::size_t>(std::lround(window_s / period_s));
    const auto memory_rows = static_cast<std::size_t>(std::lround(memory_s / period_s));
    for (std::size_t row = memory_rows; row < ones[index].truth.size(); row += 4)
      fit.add(past_commands(ones[index], row, memory_rows, lags),
              channel(ones[index], row - window_rows, row) - channel(others[index], row - window_rows, row));
  }
  return {fit.mean_square(), fit.remaining_mean_square()};
}

}  // namespace

Visibility visibility(Experiment hidden, Experiment innocent) {
  constexpr int enough = 2;
  hidden.runs = innocent.runs = enough;
  Experiment disturbed = innocent;
  disturbed.noise_seed = ~innocent.noise_seed;
  const std::vector<Run> driven = drive(hidden);
  const std::vector<Run> alike = drive_again(innocent, driven);
  const std::vector<Run> unlike = drive_again(disturbed, driven);
  Visibility most;
  const auto look = [&](const char* name, const Channel& channel, double sensor_variance) {
    for (const double window_s : windows_s) {
      const Difference hides = difference(driven, alike, channel, window_s);
      const double other_noise = difference(unlike, alike, channel, window_s).mean_square;
      const double noise = std::sqrt(0.5 * other_noise + sensor_variance);
      most.raw = std::max(most.raw, std::sqrt(hides.mean_square) / noise);
      const double bent = std::sqrt(hides.bent_mean_square) / noise;
      if (bent < most.bent) continue;
      most.bent = bent;
      most.channel = name;
    }
  };
  const SensorSet& sensors = hidden.sensors;
  const double tick_m = hidden.robot.encoder.metres_per_tick;
  if (sensors.ticks) {
    look("left", counted(left_side), tick_m * tick_m / 6.0);
    look("right", counted(right_side), tick_m * tick_m / 6.0);
  }
  if (!sensors.poses) return most;
  const double seen_variance = 2.0 * sensors.position_noise_m * sensors.position_noise_m;
  look("forward", moved(false), seen_variance);
  look("sideways", moved(true), seen_variance);
  look("heading", turned, 2.0 * sensors.heading_noise_rad * sensors.heading_noise_rad);
  return most;
}

}  // namespace plants::fifth
