#include "daemon/recording/log_format.hpp"

#include "config/load/text_format.hpp"
#include "daemon/recording/covariance_columns.hpp"
#include "daemon/recording/fault_text.hpp"

namespace wheelwright::daemon {
namespace {

using config::fixed_number;
using config::plain_number;

}  // namespace

bool is_logged(const LogEntry& entry) {
  return entry.record.tick >= 0 && entry.frame.command.activity != Activity::idle;
}

std::string drive_log_head(const config::DaemonConfig& config, const WheelPair& metres_per_tick) {
  std::string text = "# wheelwright_drive_log: 1\n";
  text += "# robot: " + config.robot_name + "\n";
  text += "# wheel_base_m: " + plain_number(config.limits.wheel_base_m) + "\n";
  text += "# period_s: " + plain_number(config.limits.period_s) + "\n";
  text += "# metres_per_tick_left: " + plain_number(metres_per_tick.left) + "\n";
  text += "# metres_per_tick_right: " + plain_number(metres_per_tick.right) + "\n";
  text +=
      "t,cmd_left,cmd_right,ticks_left,ticks_right,battery_v,tick,activity,repetition,stop,model_version,";
  text += "light_left,light_front_left,light_center_left,light_center_right,light_front_right,light_right,";
  text +=
      "bump,wheel_drop,cliff,overcurrents,current_left_a,current_right_a,oi_mode,doubtful_sign,after_gap,"
      "travel_ticks_left,travel_ticks_right,late_us\n";
  return text;
}

std::string drive_log_line(const LogEntry& entry) {
  const SensorFrame& frame = entry.frame;
  const PoseRecord& record = entry.record;
  std::string line = fixed_number(record.t_s, 6) + "," + fixed_number(frame.command.speed_m_s.left, 6) + "," +
                     fixed_number(frame.command.speed_m_s.right, 6) + ",";
  if (frame.valid) {
    line += std::to_string(frame.counted_ticks.left) + "," + std::to_string(frame.counted_ticks.right) + "," +
            fixed_number(frame.battery_v, 3);
  } else {
    line += ",,";
  }
  line += "," + std::to_string(record.tick) + "," + std::string(name_of(frame.command.activity)) + "," +
          std::to_string(frame.command.repetition) + "," + std::string(name_of(frame.stop)) + "," +
          std::to_string(record.model_version);
  if (!frame.valid) return line + ",,,,,,,,,,,,,,,,,,";
  for (const auto signal : frame.light_bumper) line += "," + std::to_string(signal);
  const auto flag = [](bool value) { return value ? ",1" : ",0"; };
  line += flag(frame.bump_left || frame.bump_right);
  line += flag(frame.wheel_drop);
  line += flag(frame.cliff);
  line += "," + std::to_string(frame.overcurrents) + "," + fixed_number(frame.motor_current_a.left, 3) + "," +
          fixed_number(frame.motor_current_a.right, 3) + "," + std::to_string(frame.oi_mode);
  line += flag(frame.doubtful_sign);
  line += flag(frame.after_gap);
  line += "," + std::to_string(frame.ticks.left) + "," + std::to_string(frame.ticks.right) + "," +
          std::to_string(frame.late_us);
  return line;
}

std::string pose_log_head(const config::DaemonConfig& config) {
  std::string text = "# wheelwright_pose_log: 1\n";
  text += "# robot: " + config.robot_name + "\n";
  text += "# wheel_base_m: " + plain_number(config.limits.wheel_base_m) + "\n";
  text += "# period_s: " + plain_number(config.limits.period_s) + "\n";
  text += "# pose_source: " + std::string(name_of(config.pose_source)) + "\n";
  text += "# frame: x forward and y left at the start of the route; zero again where the route starts\n";
  text += "t,speed_left,speed_right,v,w,x,y,theta,odometry_x,odometry_y,odometry_theta,";
  text += "measured_speed_left,measured_speed_right,activity,checkpoints_visited,";
  text += "hybrid_x,hybrid_y,hybrid_theta,hybrid_cov_xx,hybrid_cov_xy,hybrid_cov_yy,hybrid_cov_xtheta,";
  text +=
      "hybrid_cov_ytheta,hybrid_cov_thetatheta,discarded,fault_left,fault_right,recalibration_due,events,";
  text += "model_cov_xx,model_cov_xy,model_cov_yy,model_cov_xtheta,model_cov_ytheta,model_cov_thetatheta\n";
  return text;
}

namespace {

// A covariance is small: twelve decimals.
std::string covariance_fields(const Eigen::Matrix3d& covariance) {
  std::string fields;
  for (const double value : covariance_columns(covariance)) {
    fields += (fields.empty() ? "" : ",") + fixed_number(value, 12);
  }
  return fields;
}

// By the hybrid filter; empty fields where it does not run.
std::string hybrid_fields(const std::optional<HybridOutput>& hybrid) {
  if (!hybrid) return ",,,,,,,,,,,,,";
  std::string fields;
  for (const double value : {hybrid->pose.x_m, hybrid->pose.y_m, hybrid->pose.theta_rad}) {
    fields += fixed_number(value, 6) + ",";
  }
  fields += covariance_fields(hybrid->covariance) + ",";
  if (hybrid->left.discarded) fields += hybrid->right.discarded ? "both" : "left";
  if (!hybrid->left.discarded && hybrid->right.discarded) fields += "right";
  fields += "," + std::string(name_of(hybrid->left_fault)) + "," + std::string(name_of(hybrid->right_fault));
  return fields + (hybrid->recalibration_due ? ",1," : ",0,") + field_of(hybrid->events);
}

}  // namespace

std::string pose_log_line(const LogEntry& entry, double wheel_base_m) {
  const PoseRecord& record = entry.record;
  std::string line = fixed_number(record.t_s, 6) + ",";
  if (record.has_prediction) {
    const Twist twist = twist_of_wheels(record.predicted_speed_m_s, wheel_base_m);
    for (const double value :
         {record.predicted_speed_m_s.left, record.predicted_speed_m_s.right, twist.v_m_s, twist.w_rad_s,
          record.predicted.x_m, record.predicted.y_m, record.predicted.theta_rad}) {
      line += fixed_number(value, 6) + ",";
    }
  } else {
    line += ",,,,,,,";
  }
  for (const double value : {record.odometry.x_m, record.odometry.y_m, record.odometry.theta_rad,
                             record.measured_speed_m_s.left, record.measured_speed_m_s.right}) {
    line += fixed_number(value, 6) + ",";
  }
  line += std::string(name_of(record.command.activity)) + "," + std::to_string(record.visited) + ",";
  line += hybrid_fields(record.hybrid);
  return line + "," + (record.has_prediction ? covariance_fields(record.predicted_covariance) : ",,,,,");
}

}  // namespace wheelwright::daemon
