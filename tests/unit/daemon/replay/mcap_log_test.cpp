// What the daemon writes as MCAP is what `wheelwright export` makes of its CSV logs.
#include "daemon/recording/mcap_log.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/logged_run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/export/recorded_run.hpp"

using namespace wheelwright;

namespace {

// CSV logs have six decimals.
constexpr double rounding = 1e-6;

void check_same(const std::optional<Pose>& one, const std::optional<Pose>& other) {
  REQUIRE(one.has_value() == other.has_value());
  if (!one) return;
  CHECK(std::abs(one->x_m - other->x_m) < rounding);
  CHECK(std::abs(one->y_m - other->y_m) < rounding);
  CHECK(std::abs(one->theta_rad - other->theta_rad) < rounding);
}

void check_same(const std::optional<WheelPair>& one, const std::optional<WheelPair>& other) {
  REQUIRE(one.has_value() == other.has_value());
  if (!one) return;
  CHECK(std::abs(one->left - other->left) < rounding);
  CHECK(std::abs(one->right - other->right) < rounding);
}

void check_same(const mcap::TickValues& one, const mcap::TickValues& other) {
  CHECK(std::abs(one.t_s - other.t_s) < rounding);
  check_same(one.command_m_s, other.command_m_s);
  check_same(one.predicted_m_s, other.predicted_m_s);
  check_same(one.measured_m_s, other.measured_m_s);
  check_same(one.model, other.model);
  check_same(one.odometry, other.odometry);
  check_same(one.hybrid, other.hybrid);
  REQUIRE(one.ticks.has_value() == other.ticks.has_value());
  if (one.ticks) CHECK(one.ticks->left == other.ticks->left);
  CHECK(one.covariance.has_value() == other.covariance.has_value());
  CHECK(one.state == other.state);
  CHECK(one.events == other.events);
}

}  // namespace

TEST_CASE("The daemon's MCAP log holds what export makes of its CSV logs") {
  const auto config = test::short_configuration();
  const auto run = test::run_of(config, 1);
  REQUIRE(run.finished);
  const auto folder = test::temporary_folder() / "wheelwright_mcap_log_test";
  test::write_logs(run, config, folder);
  std::vector<mcap::TickValues> direct;
  test::for_each_entry(run,
                       [&](const daemon::LogEntry& entry) { direct.push_back(daemon::tick_values(entry)); });

  std::size_t next = 0;
  tools::for_each_tick(tools::load_recorded_run(folder.string()), [&](const mcap::TickValues& exported) {
    REQUIRE(next < direct.size());
    check_same(direct[next++], exported);
  });
  CHECK(next == direct.size());
  CHECK(next > 1000);
}
