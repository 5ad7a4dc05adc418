#include "daemon/recording/lateness_file.hpp"

#include "config/load/drive_log_file.hpp"
#include "tests/support/catch.hpp"
#include "tools/wheelwright/report/lateness_section.hpp"

using namespace wheelwright;
using namespace std::chrono_literals;

namespace {

// A hundred wake-ups 20 us late, one 3 ms and one 40 ms.
daemon::LatenessRecord record() {
  roomba::LatenessHistogram lateness;
  for (int i = 0; i < 100; ++i) lateness.add(20us);
  lateness.add(3ms);
  lateness.add(40ms);
  roomba::LoopCounts counts;
  counts.overruns = 1;
  counts.skipped_periods = 2;
  counts.commands_late = 3;
  return daemon::lateness_record(lateness, counts, 0.018, "SCHED_FIFO 80, memory locked");
}

std::string refusal(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  try {
    daemon::parse_lateness(text, "lateness.txt");
  } catch (const config::LogError& error) {
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace

TEST_CASE("A lateness file is read as it was written") {
  const auto written = record();
  const auto read = daemon::parse_lateness(daemon::lateness_text(written), "lateness.txt");
  CHECK(read.system == "SCHED_FIFO 80, memory locked");
  CHECK(read.period_s == 0.018);
  CHECK(read.wake_ups == 102);
  CHECK(read.overruns == 1);
  CHECK(read.skipped_periods == 2);
  CHECK(read.commands_late == 3);
  CHECK(read.largest_us == 40000.0);
  REQUIRE(read.bins.size() == 3);
  CHECK(read.bins[0].wake_ups == 100);
  CHECK(daemon::lateness_text(read) == daemon::lateness_text(written));
}

TEST_CASE("Quantiles of a lateness file are those of the loop's own histogram") {
  const auto lateness = record();
  CHECK_THAT(lateness.quantile_us(0.5), WithinAbs(20.0, 1.0));
  CHECK_THAT(lateness.quantile_us(0.99), WithinAbs(3000.0, 150.0));
  CHECK(lateness.quantile_us(1.0) == 40000.0);
}

TEST_CASE("A lateness file that is damaged is refused with its line and what would be right") {
  const std::string text = daemon::lateness_text(record());
  CHECK_THAT(refusal(text, "lateness: 1", "lateness: 2"), ContainsSubstring("'# wheelwright_lateness: 1'"));
  CHECK_THAT(refusal(text, "overruns: 1", "overruns: -1"),
             ContainsSubstring("lateness.txt: '# overruns' is '-1', but must be a number"));
  CHECK_THAT(refusal(text, " 100\n", " many\n"), ContainsSubstring("lateness.txt:10: is '"));
  CHECK_THAT(refusal(text, "40000.000 1\n", "nan 1\n"),
             ContainsSubstring("'nan 1', but must be a rising edge"));
  CHECK_THAT(refusal(text, "40000.000 1\n", "1 1\n"), ContainsSubstring("'1 1', but must be a rising edge"));
}

TEST_CASE("The boxes of the picture hold every wake-up, and each its own lateness") {
  roomba::LatenessHistogram lateness;
  for (int ns = 1000; ns <= 1'000'000; ns += 50) lateness.add(ns * 1ns);
  const auto boxes = tools::lateness_boxes(daemon::lateness_record(lateness, {}, 0.018, ""));
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    sum += boxes[i].wake_ups;
    CHECK_THAT(boxes[i].upper_edge_us / boxes[i].lower_edge_us, WithinAbs(1.1892, 1e-3));
    if (i > 0) CHECK(boxes[i].lower_edge_us >= boxes[i - 1].upper_edge_us - 1e-6);
  }
  CHECK(sum == 19981);
  CHECK(boxes.back().lower_edge_us < 1000.0);
  CHECK(boxes.back().upper_edge_us >= 1000.0);
  CHECK(boxes.size() == 41);  // ten doublings, the first and the last in part
}
