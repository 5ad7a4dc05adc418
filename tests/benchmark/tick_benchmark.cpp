// What predictor and follower need for one tick along a route: Brain::take and the commands that follow, as
// the predictor thread does it.
#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <thread>

#include "daemon/threads/real_time_setup.hpp"
#include "model/brain/brain.hpp"
#include "tests/benchmark/plant_log.hpp"

namespace wheelwright::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

Route figure_of_eight() {
  Route route;
  route.name = "benchmark";
  route.speed_m_s = 0.2;
  for (int lap = 0; lap < 20; ++lap) {
    for (const Checkpoint point : {Checkpoint{0.5, 0.0}, Checkpoint{0.5, 0.5}, Checkpoint{0.0, 0.0},
                                   Checkpoint{-0.5, 0.0}, Checkpoint{-0.5, -0.5}, Checkpoint{0.0, 0.0}}) {
      route.checkpoints.push_back(point);
    }
  }
  return route;
}

// The brain on its route, with a robot that does what it is told.
class Drive {
 public:
  explicit Drive(PoseSource source) : brain_(mission(source), {}, model()) {
    // To the first moving command and a bit further.
    for (int i = 0; i < 100; ++i) tick();
  }

  // Returns how long the brain took.
  Clock::duration tick() {
    SensorFrame frame;
    frame.tick = tick_++;
    frame.t_s = period_s * static_cast<double>(frame.tick);
    frame.armed = true;
    frame.valid = true;
    frame.battery_v = 15.0;
    if (!commands_.empty()) {
      frame.command = commands_.front();
      commands_.pop_front();
    }
    travelled_m_.left += period_s * frame.command.speed_m_s.left;
    travelled_m_.right += period_s * frame.command.speed_m_s.right;
    frame.ticks = {std::llround(travelled_m_.left / metres_per_tick),
                   std::llround(travelled_m_.right / metres_per_tick)};
    const auto begin = Clock::now();
    const PoseRecord record = brain_.take(frame);
    std::size_t count = 0;
    while (const auto command = brain_.next_command()) given_.at(count++ % given_.size()) = *command;
    const auto took = Clock::now() - begin;
    benchmark::DoNotOptimize(record);
    for (std::size_t i = 0; i < count; ++i) commands_.push_back(given_.at(i));
    return took;
  }

  bool on_route() const { return brain_.activity() == Activity::route; }

 private:
  static Mission mission(PoseSource source) {
    Mission mission;
    mission.route = figure_of_eight();
    mission.pose_source = source;
    return mission;
  }
  static std::unique_ptr<DrivingModel> model() {
    RobotModel robot;
    robot.linear_part = plant_model(30);
    robot.encoder_scale = EncoderScale{{metres_per_tick, metres_per_tick}, 1660.0, 0.001};
    return std::make_unique<DrivingModel>(robot);
  }

  Brain brain_;
  std::deque<Command> commands_;
  std::array<Command, 64> given_{};
  WheelPair travelled_m_;
  std::int64_t tick_ = 0;
};

void report(benchmark::State& state, std::vector<double> times_s) {
  std::sort(times_s.begin(), times_s.end());
  const auto at = [&](double share) {
    return times_s.at(static_cast<std::size_t>(share * static_cast<double>(times_s.size() - 1)));
  };
  state.counters["p50_s"] = at(0.5);
  state.counters["p99_s"] = at(0.99);
  state.counters["largest_s"] = times_s.back();
  state.counters["ticks"] = static_cast<double>(times_s.size());
}

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

void drive(benchmark::State& state, PoseSource source, int ticks, bool at_pace) {
  for ([[maybe_unused]] const auto& iteration : state) {
    Drive drive(source);
    std::vector<double> times_s;
    timespec pause{0, 18'000'000};
    for (int i = 0; i < ticks; ++i) {
      if (at_pace) ::clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
      times_s.push_back(seconds(drive.tick()));
    }
    if (!drive.on_route()) state.SkipWithError("the route ended early");
    report(state, std::move(times_s));
  }
}

// One after the other: the caches are warm.
void tick_back_to_back(benchmark::State& state) {
  drive(state, PoseSource::fir, 3000, false);
}
BENCHMARK(tick_back_to_back)->Unit(benchmark::kMillisecond);

void tick_back_to_back_by_odometry(benchmark::State& state) {
  drive(state, PoseSource::odometry, 3000, false);
}
BENCHMARK(tick_back_to_back_by_odometry)->Unit(benchmark::kMillisecond);

void tick_back_to_back_by_hybrid(benchmark::State& state) {
  drive(state, PoseSource::hybrid, 3000, false);
}
BENCHMARK(tick_back_to_back_by_hybrid)->Unit(benchmark::kMillisecond);

// After a sleep of 18 ms each, with real-time scheduling where it is to be had, as in the daemon: the caches
// are cold and the processor is slow to wake.
void tick_at_pace(benchmark::State& state) {
  std::thread loop([&] {
    daemon::RealTimeStatus status;
    daemon::set_up_loop_thread({}, status);
    drive(state, PoseSource::fir, 400, true);
  });
  loop.join();
}
BENCHMARK(tick_at_pace)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace wheelwright::benchmarks
