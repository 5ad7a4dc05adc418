#include "tools/wheelwright/evaluation/learning_drives.hpp"

#include <cmath>
#include <numbers>

namespace wheelwright::tools {
namespace {

constexpr double drive_s = 62.0;
constexpr std::size_t max_repeats = 2;  // of a drive that the robot stopped, each by other commands
constexpr double square_m = 2.0;
constexpr double shortest_leg_m = 0.4;
constexpr double slowest_m_s = 0.1;
constexpr double fastest_m_s = 0.25;
constexpr double default_turn_s = 2.5;  // a turn in place between two legs, with stopping and starting

Mission random_mission(simulation::Noise& chance) {
  Mission mission;
  mission.random_drive = RandomDrivePlan{};
  mission.random_drive->duration_s = drive_s;
  mission.random_drive->radius_m = 1.0;
  mission.random_drive->tour_share = 0.0;  // tours have drives of their own
  mission.random_drive->seed = chance.bits();
  return mission;
}

Mission route_mission(const Route& route) {
  Mission mission;
  mission.route = route;
  mission.pose_source = PoseSource::arma;
  return mission;
}

Mission tour_mission(double speed_m_s, simulation::Noise& chance) {
  return route_mission(random_tour(speed_m_s, drive_s, chance));
}

double random_speed_m_s(simulation::Noise& chance) {
  return slowest_m_s + (fastest_m_s - slowest_m_s) * chance.uniform();
}

// A drive that the robot stops is begun again, with other commands.
template <typename MakeMission>
tl::expected<DriveLog, std::string> recorded(RobotTrial& trial, const RobotModel& model,
                                             MakeMission make_mission) {
  auto log = trial.record(make_mission(), model, {});
  for (std::size_t again = 0; !log && again < max_repeats; ++again)
    log = trial.record(make_mission(), model, {});
  return log;
}

}  // namespace

Route random_tour(double speed_m_s, double duration_s, simulation::Noise& chance) {
  Route route;
  route.name = "tour";
  route.speed_m_s = speed_m_s;
  Checkpoint at;
  for (double used_s = 0.0; used_s < duration_s;) {
    const Checkpoint next{square_m * chance.uniform(), square_m * (chance.uniform() - 0.5)};
    const double leg_m = std::hypot(next.x_m - at.x_m, next.y_m - at.y_m);
    if (leg_m < shortest_leg_m) continue;
    route.checkpoints.push_back(next);
    used_s += leg_m / route.speed_m_s + default_turn_s;
    at = next;
  }
  return route;
}

tl::expected<std::vector<DriveLog>, std::string> learning_drives(std::size_t count, RobotTrial& trial,
                                                                 const RobotModel& model,
                                                                 simulation::Noise& chance) {
  std::vector<DriveLog> logs;
  for (std::size_t i = 0; i < count; ++i) {
    const bool tour = i % 2 == 1;
    auto log = recorded(trial, model, [&] {
      return tour ? tour_mission(random_speed_m_s(chance), chance) : random_mission(chance);
    });
    if (!log) return tl::make_unexpected(log.error());
    log->name = (tour ? "tour_" : "random_") + std::to_string(i + 1);
    logs.push_back(std::move(*log));
  }
  return logs;
}

ProofDrives proof_drives(const Route& route, std::size_t tours, RobotTrial& trial, const RobotModel& model,
                         simulation::Noise& chance) {
  ProofDrives drives;
  const auto drive = [&](const Mission& mission) {
    auto log = trial.record(mission, model, {});
    if (log) {
      drives.logs.push_back(std::move(*log));
    } else {
      ++drives.stopped;
      drives.failure = log.error();
    }
    return log.has_value();
  };
  drive(route_mission(route));
  const std::size_t attempts = tours * (1 + max_repeats);
  std::size_t ended = 0;
  for (std::size_t i = 0; i < attempts && ended < tours; ++i) {
    if (drive(tour_mission(route.speed_m_s, chance))) ++ended;
  }
  return drives;
}

}  // namespace wheelwright::tools
