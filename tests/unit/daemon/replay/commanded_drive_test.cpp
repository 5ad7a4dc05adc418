// What a gap analysis asks for next is a drive that the robot comes to the end of.
#include "daemon/replay/virtual_run.hpp"
#include "model/gap/next_experiment/manoeuvres.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/simulated_run.hpp"

using namespace wheelwright;

namespace {

CommandedDrive drive_of(const gap::Manoeuvre& manoeuvre, double period_s) {
  DriveLog log;
  log.name = manoeuvre.name;
  log.period_s = period_s;
  for (const WheelPair& command : manoeuvre.commands_m_s) {
    DriveSample sample;
    sample.t_s = period_s * static_cast<double>(log.samples.size());
    sample.command_m_s = command;
    log.samples.push_back(sample);
  }
  return commanded_drive_of(log);
}

}  // namespace

TEST_CASE("Every manoeuvre that a gap analysis may ask for is driven to its end within its floor") {
  const gap::ManoeuvreLimits limits;
  for (const char* name : {"default", "create2", "old_motors"}) {
    for (const auto& manoeuvre : gap::safe_manoeuvres(limits, 0.235, 0.018)) {
      INFO(name << ": " << manoeuvre.name);
      daemon::VirtualRunConfig config;
      config.mission.commanded_drive = drive_of(manoeuvre, 0.018);
      simulation::SimulatedRobot robot(test::robot_in_room(name, "empty", 3));
      const auto run = daemon::run_virtually(config, robot);
      INFO(name_of(run.stop));
      CHECK(run.finished);
      const Pose start = run.true_poses.front();
      for (const Pose& pose : run.true_poses) {
        if (std::hypot(pose.x_m - start.x_m, pose.y_m - start.y_m) < 1.2 * limits.radius_m) continue;
        FAIL_CHECK("left its floor");
        break;
      }
    }
  }
}
