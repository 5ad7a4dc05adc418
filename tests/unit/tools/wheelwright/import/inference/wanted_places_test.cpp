// Places that are wanted beside places that were measured.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/seen_pose.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

// Up to so many metres, the same at each call with the same time.
double noise(const ForeignRow& row, double phase) {
  return 1e-3 * std::sin(9871.0 * row.t_s + phase);
}

std::string measured(const ForeignRow& row) {
  return field(row.x + noise(row, 0.0)) + field(row.y + noise(row, 1.0)) + "," + number(row.theta);
}

std::string smooth(const ForeignRow& row) {
  return field(row.x) + field(row.y) + field(row.theta);
}

std::string reference_x(const ImportOutcome& outcome) {
  const auto& reference = outcome.understood.mapping.reference;
  return reference ? reference->x->channel : "none";
}

}  // namespace

TEST_CASE("A path that goes before the places is wanted, whatever it is called") {
  const auto drive = foreign_drive();
  for (const char* names : {"x_ref,y_ref,theta_ref", "x_des,y_des,theta_des", "goal_x,goal_y,goal_theta",
                            "target_x,target_y,target_yaw", "x_d,y_d,theta_d", "path_x,path_y,path_yaw"}) {
    INFO(names);
    const auto outcome = import_seen(drive, std::string(names) + ",x,y,theta", [&](const ForeignRow& row) {
      const auto k = static_cast<std::size_t>(std::lround(row.t_s / drive.period_s));
      return smooth(drive.rows[std::min(k + 6, drive.rows.size() - 1)]) + measured(row);
    });
    CHECK(reference_x(outcome) == "x");
    CHECK(outcome.understood.mapping.reference->theta->channel == "theta");
    CHECK(outcome.understood.mapping.command->first.channel == "cmd_left");
  }
}

TEST_CASE("A reference with the noise of a tracker beside smooth odometry was measured") {
  const auto drive = foreign_drive();
  for (const char* names : {"x,y,theta,x_ref,y_ref,theta_ref", "x_odom,y_odom,th_odom,x_ref,y_ref,th_ref"}) {
    INFO(names);
    const auto outcome =
        import_seen(drive, names, [](const ForeignRow& row) { return smooth(row) + measured(row); });
    CHECK(reference_x(outcome) == "x_ref");
  }
}

TEST_CASE("A reference without other places is one, and a goal is none") {
  const auto drive = foreign_drive();
  CHECK(reference_x(import_seen(drive, "x_ref,y_ref,theta_ref", measured)) == "x_ref");
  const auto goal = import_seen(drive, "goal_x,goal_y,goal_theta", smooth);
  CHECK(reference_x(goal) == "none");
  CHECK(goal.found("goal_x is of a place to go to"));
  const auto held = import_seen(drive, "x_ref,y_ref", [](const ForeignRow& row) {
    return field(std::floor(row.t_s / 5.0)) + field(std::floor(row.t_s / 10.0));
  });
  CHECK(reference_x(held) == "none");
}

TEST_CASE("A heading to go to is no turning speed beside a forward one") {
  const auto drive = foreign_drive();
  const auto outcome =
      import_text(foreign_text(drive, "t,target_x,target_y,target_yaw,v_cmd,w_cmd,enc_left,enc_right",
                               [](const ForeignRow& row) {
                                 return number(row.t_s) + smooth(row) + field(row.linear()) + "," +
                                        number(row.angular(ForeignDrive::base_m)) + "," + counts(row);
                               }),
                  seen_settings);
  CHECK(outcome.understood.mapping.command->second->channel == "w_cmd");
}
