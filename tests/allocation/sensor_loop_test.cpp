#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "daemon/threads/predictor_thread.hpp"
#include "daemon/threads/ring_client.hpp"
#include "drivers/simulation/pseudo_terminal.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "tests/allocation/heap_calls.hpp"
#include "tests/allocation/route_plan.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace std::chrono_literals;
using std::chrono::steady_clock;

namespace {

// A simulated robot on the wall clock at the other end of a pseudo-terminal.
class RobotThread {
 public:
  RobotThread() : thread_([this] { serve(); }) {}
  ~RobotThread() {
    ending_ = true;
    thread_.join();
  }
  const std::string& path() const { return terminal_.path(); }

 private:
  void serve() {
    const auto start = steady_clock::now();
    std::array<std::uint8_t, 4096> bytes{};
    while (!ending_) {
      const auto now = steady_clock::now() - start;
      if (now > robot_.now()) robot_.advance(now - robot_.now());
      while (const std::size_t count = terminal_.read(bytes)) robot_.receive(std::span(bytes).first(count));
      while (const std::size_t count = robot_.transmit(bytes)) terminal_.write(std::span(bytes).first(count));
      std::this_thread::sleep_for(1ms);
    }
  }

  simulation::SimulatedRobot robot_{simulation::SimulationConfig{}};
  simulation::PseudoTerminal terminal_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

bool within(std::chrono::seconds patience, const std::atomic<bool>& happens) {
  const auto deadline = steady_clock::now() + patience;
  while (!happens && steady_clock::now() < deadline) std::this_thread::sleep_for(10ms);
  return happens;
}

struct CallsWhileDriving {
  bool finished = false;
  std::uint64_t loop = 0;
  std::uint64_t predictor = 0;
  std::uint64_t readings = 0;
};

CallsWhileDriving drive_a_route(roomba::Transport transport) {
  RobotThread robot;
  const auto port = serial::open_port(robot.path(), 115200);
  REQUIRE(port);
  const auto wiring = std::make_unique<daemon::Wiring>();
  daemon::RingClient client(*wiring);
  roomba::LinkConfig link;
  link.transport = transport;
  if (transport == roomba::Transport::stream) link.period_s = 0.015625;  // the robot's own
  link.late_commands_held = 50;  // the machine may be busy; that is not what is tested
  link.blind_limit_s = 0.9;
  roomba::SensorLoop sensor_loop({link, robot.path(), 115200}, *port, client);
  Brain brain(test::triangle_mission(PoseSource::fir), RobotLimits{},
              std::make_unique<DrivingModel>(test::lagging_model()));
  test::HeapCalls loop_calls{0};
  test::HeapCalls predictor_calls{0};
  std::thread loop([&] {
    const test::CountedScope scope(loop_calls);
    sensor_loop.run();
  });
  std::thread predictor([&] {
    const test::CountedScope scope(predictor_calls);
    run_predictor(brain, *wiring, sensor_loop);
  });

  CallsWhileDriving result;
  CHECK(within(10s, wiring->robot_answers));
  std::this_thread::sleep_for(1s);
  const std::uint64_t loop_before = loop_calls;
  const std::uint64_t predictor_before = predictor_calls;
  sensor_loop.request_arm();
  result.finished = within(60s, wiring->finished);
  result.loop = loop_calls - loop_before;
  result.predictor = predictor_calls - predictor_before;

  sensor_loop.request_end();
  loop.join();
  wiring->ending = true;
  wiring->frame_arrived.release();
  predictor.join();
  result.readings = transport == roomba::Transport::query ? sensor_loop.link().reply_counts().sound
                                                          : sensor_loop.link().stream_counts().frames;
  return result;
}

}  // namespace

TEST_CASE("Sensor loop and predictor drive a whole route on a real terminal without the heap") {
  for (const auto transport : {roomba::Transport::query, roomba::Transport::stream}) {
    INFO("transport " << static_cast<int>(transport));
    const CallsWhileDriving calls = drive_a_route(transport);
    CHECK(calls.finished);
    CHECK(calls.readings > 100);
    CHECK(calls.loop == 0);
    CHECK(calls.predictor == 0);
  }
}
