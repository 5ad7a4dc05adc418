#include "tools/wheelwright/export/tum.hpp"

#include <cmath>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {
namespace {

using config::fixed_number;

WhichPose best_pose(const RecordedRun& run) {
  if (run.drive && run.drive->has("ref_x")) return WhichPose::reference;
  if (!run.poses) return WhichPose::reference;
  switch (mcap::steering_pose(run.poses->metadata("pose_source"))) {
    case mcap::SteeringPose::odometry:
      return WhichPose::odometry;
    case mcap::SteeringPose::hybrid:
      return WhichPose::hybrid;
    case mcap::SteeringPose::model:
      break;
  }
  return WhichPose::model;
}

const std::optional<Pose>& pose_of(const mcap::TickValues& tick, WhichPose which) {
  switch (which) {
    case WhichPose::odometry:
      return tick.odometry;
    case WhichPose::hybrid:
      return tick.hybrid;
    case WhichPose::reference:
      return tick.reference;
    default:
      return tick.model;
  }
}

std::string line(double t_s, const Pose& pose) {
  const double half = 0.5 * wrap_angle(pose.theta_rad);
  return fixed_number(t_s, 6) + " " + fixed_number(pose.x_m, 6) + " " + fixed_number(pose.y_m, 6) +
         " 0 0 0 " + fixed_number(std::sin(half), 9) + " " + fixed_number(std::cos(half), 9) + "\n";
}

}  // namespace

std::string to_tum(const RecordedRun& run, const TumChoice& choice) {
  const WhichPose which = choice.pose == WhichPose::best ? best_pose(run) : choice.pose;
  std::string text;
  bool any_activity = false;
  for_each_tick(run, [&](const mcap::TickValues& tick) {
    const bool wanted = choice.during.empty() || (tick.state && tick.state->activity == choice.during);
    any_activity = any_activity || wanted;
    if (const auto& pose = pose_of(tick, which); pose && wanted) text += line(tick.t_s, *pose);
  });
  const std::string& name = (run.poses ? run.poses : run.drive)->name();
  if (!any_activity) throw DataRefusal(name + ": holds nothing of activity '" + choice.during + "'");
  if (text.empty()) {
    const char* missing = which == WhichPose::reference  ? "reference pose (ref_x, ref_y, ref_theta)"
                          : which == WhichPose::odometry ? "odometry pose (odometry_x, ...)"
                          : which == WhichPose::hybrid   ? "hybrid pose (hybrid_x, ...)"
                                                         : "pose of a model (x, y, theta)";
    throw DataRefusal(name + ": holds no " + missing + "; see --pose");
  }
  return text;
}

}  // namespace wheelwright::tools
