// Which parts of a long log are analysed.
#include "model/gap/data_checks/informative_segments.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr double period_s = 0.05;

// Half a minute of driving straight, then two seconds of rest, again and again; turns in one part alone.
DriveLog long_drive(std::size_t rows, std::size_t turns_from, std::size_t turns_until) {
  DriveLog log;
  log.name = "long.csv";
  log.wheel_base_m = 0.3;
  log.period_s = period_s;
  log.metres_per_tick = WheelPair{1e-3, 1e-3};
  log.first_line = 8;
  double travel_m = 0.0;
  for (std::size_t row = 0; row < rows; ++row) {
    DriveSample sample;
    sample.t_s = period_s * static_cast<double>(row);
    const bool rests = row % 640 < 40;
    const bool turns = row >= turns_from && row < turns_until;
    if (!rests) sample.command_m_s = turns ? WheelPair{0.05, 0.25} : WheelPair{0.2, 0.2};
    travel_m += period_s * sample.command_m_s.left;
    sample.ticks = WheelTicks{std::lround(1e3 * travel_m), std::lround(1e3 * travel_m)};
    log.samples.push_back(sample);
  }
  return log;
}

}  // namespace

TEST_CASE("Logs that an analysis can take stay as they are") {
  const auto segments = informative_segments({long_drive(5000, 0, 0)}, {.max_rows = 6000});
  REQUIRE(segments.runs.size() == 1);
  CHECK(segments.runs.front().samples.size() == 5000);
  CHECK(segments.all_used());
}

TEST_CASE("Of a long log the parts are used that show something of their own, each from rest") {
  const auto log = long_drive(200'000, 120'000, 122'000);
  const auto segments = informative_segments({log}, {.max_rows = 12'000, .length_s = 60.0});
  std::size_t rows = 0;
  bool turns = false;
  for (const DriveLog& run : segments.runs) {
    rows += run.samples.size();
    CHECK(run.has_ticks());
    CHECK(run.samples.front().command_m_s.left == 0.0);
    CHECK(run.samples.front().t_s == log.samples[run.first_line - log.first_line].t_s);
    turns |= std::ranges::any_of(run.samples, [](const DriveSample& sample) {
      return sample.command_m_s.left != sample.command_m_s.right;
    });
  }
  CHECK(turns);
  CHECK(rows <= 12'000);
  CHECK(rows > 9'000);
  CHECK(segments.given_s > 15.0 * segments.used_s);
}

TEST_CASE("Where a robot never stands a part begins with commands alone, until its past is forgotten") {
  auto log = long_drive(50'000, 0, 0);
  for (auto& sample : log.samples) sample.command_m_s = {0.1, 0.2};
  const auto segments = informative_segments({log}, {.max_rows = 5'000, .length_s = 60.0});
  REQUIRE(segments.runs.size() > 1);
  const DriveLog& run = segments.runs.back();
  REQUIRE(run.samples.front().t_s > 0.0);
  CHECK(run.samples.front().ticks);
  CHECK_FALSE(run.samples[1].ticks);
  CHECK_FALSE(run.samples[39].ticks);
  CHECK(run.samples[41].ticks);
}
