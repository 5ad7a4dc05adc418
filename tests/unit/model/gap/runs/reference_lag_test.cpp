// References that tell of another moment than the counts do.
#include "model/gap/analysis.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

void let_references_lag(DriveLog& log, std::size_t rows) {
  for (std::size_t k = log.samples.size() - 1; k >= rows; --k) {
    log.samples[k].reference_x_m = log.samples[k - rows].reference_x_m;
    log.samples[k].reference_y_m = log.samples[k - rows].reference_y_m;
    log.samples[k].reference_theta_rad = log.samples[k - rows].reference_theta_rad;
  }
}

void keep_one_reference_in(DriveLog& log, std::size_t rows) {
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    if (k % rows == 0) continue;
    log.samples[k].reference_x_m.reset();
    log.samples[k].reference_y_m.reset();
    log.samples[k].reference_theta_rad.reset();
  }
}

GapAnalysis analysed_with_late_references(const std::string& hidden, std::size_t rows = 1,
                                          std::size_t one_in = 1) {
  test::GapCaseSpec spec;
  spec.name = hidden;
  spec.channels = test::Channels::ticks_ref;
  spec.runs = 3;
  spec.seconds = 30.0;
  auto logs = test::make_gap_case(spec).runs;
  for (auto& log : logs) {
    let_references_lag(log, rows);
    keep_one_reference_in(log, one_in);
  }
  auto analysis = analyse_gap(std::span(logs).first(2), std::span(logs).last(1), {}, serial_for,
                              [](const std::string&, double) {});
  REQUIRE(analysis);
  return std::move(*analysis);
}

}  // namespace

TEST_CASE("References that come a period late are no play between encoder and floor") {
  const auto analysis = analysed_with_late_references("clean");
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK_THAT(analysis.search.final.model.reference_lag_s(), WithinAbs(0.018, 0.002));
}

TEST_CASE("What late references tell is compared with where the robot was then") {
  const auto analysis = analysed_with_late_references("clean", 3);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK_THAT(analysis.search.final.model.reference_lag_s(), WithinAbs(0.054, 0.002));
  for (const GapFigures* figures : {&analysis.train, &analysis.test}) {
    CHECK(figures->after.heading_rms_rad->value < 1.5 * figures->floor.heading_rms_rad->value);
    CHECK(figures->after.position_rms_m->value < 1.5 * figures->floor.position_rms_m->value);
  }
}

TEST_CASE("References that come a period late do not hide what the floor does") {
  const auto analysis = analysed_with_late_references("distance_scale");
  REQUIRE(analysis.verdict == Verdict::named);
  CHECK(analysis.found.front().setting.name == "distance_scale");
}

TEST_CASE("Late references more than a second apart are no play between encoder and floor either") {
  const auto analysis = analysed_with_late_references("clean", 2, 60);
  CHECK(analysis.verdict == Verdict::nothing_missing);
  CHECK_THAT(analysis.search.final.model.reference_lag_s(), WithinAbs(0.036, 0.005));
}
