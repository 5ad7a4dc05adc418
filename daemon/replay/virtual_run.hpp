// The whole robot on a virtual clock: brain, calibrator and link as in the daemon, against the simulated
// robot, in one thread. What the daemon does in a minute this does in milliseconds, and the same seed gives
// the same bytes.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/open_interface/query_reader.hpp"
#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/simulated_robot.hpp"
#include "model/brain/brain.hpp"
#include "model/brain/calibrator.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::daemon {

struct VirtualRunConfig {
  Mission mission;
  RobotLimits limits;
  roomba::LinkConfig link;
  std::optional<RobotModel> model;
  double longest_s = 600.0;  // of virtual time
  // How late the host wakes up for a tick, less than a period; never where it is empty.
  std::function<std::chrono::nanoseconds(std::int64_t tick)> host_lateness;
};

struct VirtualRunResult {
  bool finished = false;  // the mission came to its end
  StopReason stop = StopReason::none;
  std::optional<Refusal> refusal;
  std::optional<EncoderScaleFit> encoder_scale;
  std::optional<FirFit> response;
  std::optional<ArmaFit> arma;
  std::vector<std::string> remarks;  // on the calibrations
  std::optional<RobotModel> model;   // that the calibration made
  std::vector<RobotModel> adapted;   // models made while driving, in order
  bool encoders_swapped = false;
  std::vector<SensorFrame> frames;
  std::vector<PoseRecord> records;  // one per frame
  std::vector<Pose> true_poses;     // one per record, in the room's frame
  std::optional<Pose> true_pose_at_route_start;
  open_interface::ReplyCounts replies;
  double duration_s = 0.0;
};

// Called each tick with the robot, before time moves on: a place to inject faults.
using TickHook = std::function<void(simulation::SimulatedRobot&, std::int64_t tick)>;

VirtualRunResult run_virtually(const VirtualRunConfig& config, simulation::SimulatedRobot& robot,
                               const TickHook& hook = {});

// How far the robot truly was from the start of the route when the run ended, in metres; the route must be
// closed.
std::optional<double> true_closure_m(const VirtualRunResult& result);

}  // namespace wheelwright::daemon
