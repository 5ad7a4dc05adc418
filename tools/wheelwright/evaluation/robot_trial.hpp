// One simulated robot in a series of runs, each on the virtual clock: it is put down, calibrates itself or
// drives, and is taken away again.
//
// Each time it is put down, chance says where exactly, how its wheels stand, the phase of its clocks, its
// counters, and all noise. What it is made of stays.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "daemon/replay/virtual_run.hpp"
#include "drivers/roomba/link_config.hpp"
#include "drivers/simulation/noise.hpp"
#include "drivers/simulation/simulation_config.hpp"
#include "model/brain/mission.hpp"
#include "model/geometry/pose.hpp"
#include "model/log/drive_log.hpp"
#include "model/route/route.hpp"
#include "model/simulation/robot_model.hpp"

namespace wheelwright::tools {

// Or why there is none, in one line.
using MaybeModel = tl::expected<RobotModel, std::string>;

// Where the robot says that it ended, by what steered it, and how sure it is.
struct EndEstimate {
  Pose pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of x, y, theta
};

// How one drive ended.
struct DriveOutcome {
  std::optional<Pose> end;  // truly, as seen from where the route was begun; absent if it did not get there
  std::string failure{};    // then: why
  std::optional<EndEstimate> estimate{};  // absent for odometry, which states no uncertainty
  bool has_model = false;                 // calibration and gap workflow made the model that was to steer
  std::vector<std::string> effects{};     // in it
};

// Whether the robot ended within the 95 % ellipse around its estimate; absent where there is none.
std::optional<bool> inside_ellipse95(const DriveOutcome& outcome);

// An outside measurement of the pose, as by motion capture: white noise on each reading.
struct ReferenceNoise {
  double position_m = 0.001;
  double heading_rad = 0.002;
};

class RobotTrial {
 public:
  RobotTrial(const simulation::SimulationConfig& robot, const RobotLimits& limits,
             const roomba::LinkConfig& link, simulation::Noise chance);

  // Encoder scale, and the moving-average model of the response actions (calibrations A and B of the source
  // paper).
  MaybeModel calibrate_response(const ResponsePlan& plan);
  // By the response model and its encoder scale the robot knows where it is, and so stays on its spot
  // (calibration C of the source paper). The plan's seed is replaced by chance.
  MaybeModel calibrate_arma(const RobotModel& response, const RandomDrivePlan& plan);

  DriveOutcome drive(const Route& route, PoseSource source, const MaybeModel& model);

  // A drive with a reference pose on every row, on the same floor without walls: the random drive,
  // the route or the commands of `mission`, the first two planned by `model`. The log counts in the model's
  // encoder scale.
  tl::expected<DriveLog, std::string> record(const Mission& mission, const RobotModel& model,
                                             const ReferenceNoise& noise);

 private:
  simulation::SimulatedRobot put_down(const simulation::RoomConfig& room);
  simulation::RoomConfig without_walls() const;
  daemon::VirtualRunConfig run_of(const Mission& mission) const;

  simulation::SimulationConfig robot_;
  RobotLimits limits_;
  roomba::LinkConfig link_;
  simulation::Noise chance_;
};

}  // namespace wheelwright::tools
