#include <array>
#include <memory>

#include "drivers/roomba/roomba_link.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "model/brain/brain.hpp"
#include "tests/allocation/heap_calls.hpp"
#include "tests/allocation/route_plan.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace std::chrono_literals;

namespace {

// Brain and link on the simulated robot; only what belongs to the robot's computer is counted.
class CountedDrive {
 public:
  CountedDrive(const Mission& mission, roomba::LinkConfig config)
      : link_(config), brain_(mission, RobotLimits{}, std::make_unique<DrivingModel>(test::lagging_robot())) {
    link_.port_opened();
  }

  // One encoder jumps on the way, so that the filter has a fault to find.
  bool drive_to_the_end() {
    for (std::int64_t tick = 0; tick < 3000 && !brain_.ended(); ++tick) {
      if (tick == 300) {
        robot_.inject(
            {.kind = simulation::Fault::Kind::add_counts, .side = simulation::Side::left, .counts = 200});
      }
      one_tick(tick);
    }
    return brain_.activity() == Activity::finished;
  }

  // A model to go on by from `tick` on.
  void prepare_exchange(std::int64_t tick) {
    better_ = std::make_unique<DrivingModel>(test::lagging_robot());
    exchange_tick_ = tick;
  }

  void stop_at(std::int64_t tick) { stop_tick_ = tick; }

  Activity activity() const { return brain_.activity(); }
  std::uint16_t model_version() const { return brain_.last_record().model_version; }
  bool has_retired() const { return retired_ != nullptr; }

  test::HeapCalls calls{0};
  bool fault_found = false;

 private:
  void one_tick(std::int64_t tick) {
    {
      const test::CountedScope scope(calls);
      if (tick == 30) link_.arm();
      if (tick == stop_tick_) link_.stop(StopReason::requested);
      send(link_.begin_tick(tick, 0.0, command_for(tick)));
    }
    bool answered = false;
    for (int look = 0; look < 18; ++look) {
      pass(1ms);
      std::array<std::uint8_t, 512> bytes{};
      const std::size_t count = robot_.transmit(bytes);
      const test::CountedScope scope(calls);
      for (std::size_t i = 0; i < count; ++i) {
        const auto reading = link_.receive(bytes.at(i));
        if (!reading || answered) continue;
        answered = true;
        finish(&*reading);
      }
    }
    const test::CountedScope scope(calls);
    if (!answered) finish(nullptr);
  }

  void finish(const open_interface::Reading* reading) {
    const SensorFrame frame = link_.complete_tick(reading);
    if (better_ && frame.tick + 20 == exchange_tick_)
      brain_.exchange_model(std::move(better_), exchange_tick_, 2);
    const PoseRecord record = brain_.take(frame);
    if (auto retired = brain_.take_retired_model()) retired_ = std::move(retired);
    fault_found = fault_found || (record.hybrid && !record.hybrid->events.empty());
    send(link_.urgent_bytes());
    while (const auto command = brain_.next_command()) {
      commands_.at(static_cast<std::size_t>(command->tick) % commands_.size()) = *command;
    }
  }

  std::optional<Command> command_for(std::int64_t tick) const {
    const Command& command = commands_.at(static_cast<std::size_t>(tick) % commands_.size());
    return command.tick == tick && link_.armed() ? std::optional(command) : std::nullopt;
  }

  void send(std::span<const std::uint8_t> bytes) { robot_.receive(bytes); }
  void pass(std::chrono::nanoseconds time) { robot_.advance(time); }

  simulation::SimulatedRobot robot_{simulation::SimulationConfig{}};
  roomba::RoombaLink link_;
  Brain brain_;
  std::unique_ptr<DrivingModel> better_;
  std::unique_ptr<DrivingModel> retired_;
  std::int64_t exchange_tick_ = 0;
  std::int64_t stop_tick_ = -1;
  std::array<Command, 64> commands_{};
};

roomba::LinkConfig with(roomba::Transport transport) {
  roomba::LinkConfig config;
  config.transport = transport;
  return config;
}

}  // namespace

TEST_CASE("Brain and link drive a whole route without the heap") {
  for (const auto source : {PoseSource::fir, PoseSource::arma, PoseSource::hybrid, PoseSource::odometry}) {
    for (const auto transport : {roomba::Transport::query, roomba::Transport::stream}) {
      INFO("pose source " << static_cast<int>(source) << ", transport " << static_cast<int>(transport));
      const auto drive = std::make_unique<CountedDrive>(test::triangle_mission(source), with(transport));
      CHECK(drive->drive_to_the_end());
      CHECK(drive->calls == 0);
      CHECK(drive->fault_found);
    }
  }
}

TEST_CASE("A model is exchanged on the way without the heap, and the old one is left to be freed") {
  for (const auto source : {PoseSource::fir, PoseSource::hybrid}) {
    INFO("pose source " << static_cast<int>(source));
    const auto drive =
        std::make_unique<CountedDrive>(test::triangle_mission(source), with(roomba::Transport::query));
    drive->prepare_exchange(250);
    CHECK(drive->drive_to_the_end());
    CHECK(drive->model_version() == 2);
    CHECK(drive->has_retired());
    CHECK(drive->calls == 0);
  }
}

TEST_CASE("A stop on the way takes back what was predicted ahead without the heap") {
  for (const auto source : {PoseSource::fir, PoseSource::hybrid}) {
    INFO("pose source " << static_cast<int>(source));
    const auto drive =
        std::make_unique<CountedDrive>(test::triangle_mission(source), with(roomba::Transport::query));
    drive->stop_at(250);
    CHECK_FALSE(drive->drive_to_the_end());
    CHECK(drive->activity() == Activity::stopped);
    CHECK(drive->calls == 0);
  }
}

TEST_CASE("Brain and link drive at random without the heap") {
  Mission mission;
  mission.random_drive = RandomDrivePlan{};
  mission.random_drive->duration_s = 20.0;
  const auto drive = std::make_unique<CountedDrive>(mission, with(roomba::Transport::query));
  drive->drive_to_the_end();  // as far as it goes without a calibrator
  CHECK(drive->activity() == Activity::await_arma);
  CHECK(drive->calls == 0);
}

TEST_CASE("Brain and link drive given commands without the heap") {
  Mission mission;
  mission.commanded_drive =
      CommandedDrive{"both ways round", {{0.0, {0.1, -0.05}}, {2.0, {-0.05, 0.1}}}, 4.0};
  const auto drive = std::make_unique<CountedDrive>(mission, with(roomba::Transport::query));
  CHECK(drive->drive_to_the_end());
  CHECK(drive->calls == 0);
}
