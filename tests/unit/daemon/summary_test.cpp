#include "daemon/summary.hpp"

#include "model/route/route.hpp"
#include "tests/support/catch.hpp"

namespace wheelwright::daemon {
namespace {

config::DaemonConfig closed_route() {
  config::DaemonConfig config;
  Route route;
  route.checkpoints = {{.x_m = 1.0}, {.x_m = 1.0, .y_m = 1.0}, {}};
  config.route = route;
  return config;
}

PoseRecord at_the_end() {
  PoseRecord record;
  record.visited = 3;
  record.odometry = {0.05, 0.0, 0.0};
  return record;
}

TEST_CASE("The end of a route by the filter comes with how far the robot may be from there",
          "[summary_test]") {
  LogReport log;
  log.last_driven_record = at_the_end();
  HybridOutput hybrid;
  hybrid.pose = {0.03, 0.04, 0.0};
  hybrid.covariance.diagonal() << 0.02 * 0.02, 0.02 * 0.02, 0.0;
  log.last_driven_record->hybrid = hybrid;

  // 95 % of a round normal distribution lie within sqrt(-2 ln 0.05) = 2.448 deviations of its middle.
  CHECK_THAT(route_in_words(closed_route(), log),
             ContainsSubstring("3 of 3 checkpoints visited") &&
                 ContainsSubstring("ended 0.050 m +- 0.049 m (95 %) from its "
                                   "start by the filter"));
}

TEST_CASE("The end of a route by odometry alone claims no accuracy") {
  LogReport log;
  log.last_driven_record = at_the_end();
  CHECK_THAT(route_in_words(closed_route(), log),
             ContainsSubstring("ended 0.050 m from its start by odometry"));
}

}  // namespace
}  // namespace wheelwright::daemon
