// What the live view costs the threads that drive: the sensor loop hands over each wake-up, the predictor
// each tick. A thread beside them empties the rings, as the live view's does.
#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "daemon/threads/ring_client.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

// Empties the rings every 40 ms or faster, as the live view does, until it goes.
class Consumer {
 public:
  explicit Consumer(daemon::TelemetryFeed& feed)
      : thread_([this, &feed] {
          while (!ending_.load(std::memory_order_relaxed)) {
            daemon::LogEntry entry;
            daemon::WakeUp wake_up;
            while (feed.entries.pop(entry)) benchmark::DoNotOptimize(entry);
            while (feed.wake_ups.pop(wake_up)) benchmark::DoNotOptimize(wake_up);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
        }) {}
  Consumer(const Consumer&) = delete;
  Consumer& operator=(const Consumer&) = delete;
  ~Consumer() {
    ending_.store(true);
    thread_.join();
  }

 private:
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

// Times what `hand_over` takes at the pace of the loop: after 18 ms of sleep the caches are cold.
template <typename HandOver>
void at_pace(benchmark::State& state, HandOver hand_over) {
  constexpr std::size_t ticks = 200;
  const timespec pause{0, 18'000'000};
  for ([[maybe_unused]] const auto& iteration : state) {
    std::vector<double> times_s;
    for (std::size_t i = 0; i < ticks; ++i) {
      ::clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
      const auto begin = Clock::now();
      hand_over();
      times_s.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    std::sort(times_s.begin(), times_s.end());
    state.counters["p50_s"] = times_s[ticks / 2];
    state.counters["p99_s"] = times_s[ticks - ticks / 100 - 1];
    state.counters["largest_s"] = times_s.back();
  }
}

// What reading the clock twice takes, which is in the other figures, too.
void telemetry_of_nobody(benchmark::State& state) {
  at_pace(state, [] {});
}
BENCHMARK(telemetry_of_nobody)->Unit(benchmark::kMillisecond)->Iterations(1);

void telemetry_of_the_loop(benchmark::State& state) {
  const auto wiring = std::make_unique<daemon::Wiring>();
  wiring->has_telemetry = true;
  daemon::RingClient client(*wiring);
  const Consumer consumer(wiring->telemetry);
  at_pace(state, [&] { client.on_wake_up(Clock::time_point{}, std::chrono::nanoseconds(20)); });
}
BENCHMARK(telemetry_of_the_loop)->Unit(benchmark::kMillisecond)->Iterations(1);

void telemetry_of_the_predictor(benchmark::State& state) {
  const auto wiring = std::make_unique<daemon::Wiring>();
  const Consumer consumer(wiring->telemetry);
  daemon::LogEntry entry;
  entry.record.hybrid.emplace();
  at_pace(state, [&] { wiring->telemetry.push(wiring->telemetry.entries, entry); });
}
BENCHMARK(telemetry_of_the_predictor)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace wheelwright::benchmarks
