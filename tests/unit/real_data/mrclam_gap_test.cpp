// The gap workflow on a run of a real Create of MRCLAM, where it is; tools/mrclam-gap does all five whole.
#include <algorithm>
#include <iterator>
#include <string>

#include "config/load/mrclam_files.hpp"
#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/mrclam_logs.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

DriveLog part_of(const DriveLog& log, const std::string& name, double from_s, double to_s) {
  DriveLog part = log;
  part.name = name;
  part.samples.clear();
  std::ranges::copy_if(log.samples, std::back_inserter(part.samples),
                       [&](const DriveSample& sample) { return sample.t_s >= from_s && sample.t_s < to_s; });
  return part;
}

}  // namespace

TEST_CASE("A real Create is found to lose speed in turns, and predicted a third better on a run not used") {
  const auto folder = test::mrclam_folder();
  if (!folder) return;
  const DriveLog log =
      config::load_mrclam_run(*folder / "Robot4_Odometry.dat", *folder / "Robot4_Groundtruth.dat").log;
  const auto analysis =
      analyse_gap({{part_of(log, "first", 0.0, 120.0)}}, {{part_of(log, "then", 120.0, 220.0)}}, {},
                  serial_for, [](const std::string&, double) {});
  REQUIRE(analysis);
  CHECK(analysis->verdict == Verdict::named);
  REQUIRE_FALSE(analysis->found.empty());
  CHECK(analysis->found.front().setting.name == "turn_speed_loss");
  REQUIRE(analysis->test.after.position_rms_m);
  CHECK(analysis->test.after.position_rms_m->value < 0.65 * analysis->test.before.position_rms_m->value);
}
