#include "model/gap/data_checks/data_gate.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "model/gap/data_checks/encoder_dropout.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gap_plant/gap_case.hpp"
#include "tests/support/reference_by_counts.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

DriveLog clean_log() {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 20.0;
  auto log = test::make_gap_case(spec).runs.front();
  log.first_line = 9;
  return log;
}

// A row at which both wheels have been told to go forward for more than a second.
std::size_t moving_row(const DriveLog& log) {
  std::size_t forward = 0;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    const auto& u = log.samples[i].command_m_s;
    forward = std::min(u.left, u.right) > 0.1 ? forward + 1 : 0;
    if (forward > 65) return i;
  }
  throw std::logic_error("the run holds no long forward drive");
}

// Rows from which the left wheel was told to stop or turn back, after it had turned for a while.
std::vector<std::size_t> stopping_rows(const DriveLog& log) {
  std::vector<std::size_t> rows;
  std::size_t turning = 0;
  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    const double command_m_s = log.samples[i].command_m_s.left;
    if (command_m_s <= 0.0 && turning > 40) rows.push_back(i);
    turning = command_m_s > 0.15 ? turning + 1 : 0;
  }
  return rows;
}

// The left wheel goes on turning, but its counts stand still.
void lose_counts(DriveLog& log, std::size_t from, std::size_t rows) {
  const auto lost = log.samples[from + rows].ticks->left - log.samples[from].ticks->left;
  for (std::size_t i = from; i < log.samples.size(); ++i) {
    auto& ticks = log.samples[i].ticks->left;
    ticks = i < from + rows ? log.samples[from].ticks->left : ticks - lost;
  }
}

}  // namespace

TEST_CASE("The data gate finds no fault in a log without one") {
  const auto gated = gate(clean_log());
  CHECK(gated.faults.empty());
  CHECK(gated.dropouts.empty());
  CHECK(gated.log.samples.size() == clean_log().samples.size());
}

TEST_CASE("A jump of the counts is named with its line, and both sides of it are taken apart") {
  auto log = clean_log();
  const std::size_t row = moving_row(log);
  log.samples[row].ticks->left += 1000000;
  const auto gated = gate(log);
  REQUIRE(gated.faults.size() == 2);  // there and back
  CHECK(gated.faults.front().row == log.first_line + row);
  CHECK_THAT(gated.faults.front().what, ContainsSubstring("ticks_left jumps by 10000"));
  CHECK_FALSE(gated.faults.front().explains);
  CHECK(gated.faults.front().distorts);
  CHECK(gated.flags.restart.at(row) == 1);
  CHECK(gated.flags.restart.at(row + 1) == 1);
}

TEST_CASE("Counters that were reset in a hole are distinguished from those that went on") {
  auto log = clean_log();
  const auto row = static_cast<std::ptrdiff_t>(moving_row(log));
  log.samples.erase(log.samples.begin() + row, log.samples.begin() + row + 60);
  const auto hole = gate(log);
  REQUIRE(hole.faults.size() == 1);
  CHECK_FALSE(hole.faults.front().distorts);
  auto was_restarted = log;
  for (auto at = was_restarted.samples.begin() + row; at != was_restarted.samples.end(); ++at) {
    at->ticks->left -= 5000;
    at->ticks->right -= 5000;
  }
  const auto gated = gate(was_restarted);
  REQUIRE(gated.faults.size() == 1);
  CHECK_THAT(gated.faults.front().what, ContainsSubstring("and the counters were reset in it"));
  CHECK(gated.faults.front().distorts);
}

TEST_CASE(
    "Where a command changed while a row is missing, the second behind is left out, and nothing elsewhere") {
  auto log = clean_log();
  std::size_t change = 100;
  while (log.samples[change].command_m_s.left == log.samples[change - 1].command_m_s.left) ++change;
  auto steady = log;
  steady.samples.erase(steady.samples.begin() + static_cast<std::ptrdiff_t>(change) - 3);
  CHECK(gate(steady).faults.empty());
  log.samples.erase(log.samples.begin() + static_cast<std::ptrdiff_t>(change));
  const auto gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK(gated.faults.front().row == log.first_line + change);
  CHECK_THAT(gated.faults.front().text(),
             ContainsSubstring("a command changed while rows are missing; the first second"));
  CHECK_FALSE(gated.faults.front().distorts);
  CHECK(gated.flags.counts.at(change) == 1);
  CHECK(gated.flags.counts.at(change - 1) == 0);
}

TEST_CASE("A command far beyond all others is named with its line, and its row left out") {
  auto log = clean_log();
  const std::size_t row = moving_row(log);
  log.samples[row].command_m_s = {8.224, 8.224};
  const auto gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK(gated.faults.front().row == log.first_line + row);
  CHECK(gated.faults.front().distorts);
  CHECK(gated.log.samples.size() + 1 == log.samples.size());
}

TEST_CASE("Sides that are swapped and signs that are wrong explain a gap on their own") {
  auto swapped = clean_log();
  for (auto& sample : swapped.samples) std::swap(sample.ticks->left, sample.ticks->right);
  auto turned = clean_log();
  for (auto& sample : turned.samples) sample.ticks->right = -sample.ticks->right;
  for (const auto& log : {swapped, turned}) {
    const auto gated = gate(log);
    CHECK(std::ranges::any_of(gated.faults, &DataFault::explains));
  }
}

TEST_CASE("A wheel that moves otherwise than it is told is no unit that is wrong") {
  auto in_another_unit = clean_log();
  in_another_unit.metres_per_tick->right *= 0.1;
  // Told to and fro five times a second, a wheel whose speed can hardly change follows the mean.
  auto hardly_changing = clean_log();
  double way_m = 0.0;
  for (std::size_t i = 0; i < hardly_changing.samples.size(); ++i) {
    DriveSample& sample = hardly_changing.samples[i];
    sample.command_m_s.right = 0.04 + (i / 50 % 2 == 0 ? 0.4 : -0.4);
    way_m += 0.04 * hardly_changing.period_s;
    sample.ticks->right = std::llround(way_m / hardly_changing.metres_per_tick->right);
  }
  const auto contradicts = [](const DriveLog& log) {
    return std::ranges::any_of(gate(log).faults, &DataFault::explains);
  };
  CHECK(contradicts(in_another_unit));
  CHECK_FALSE(contradicts(hardly_changing));
}

TEST_CASE("A reference in another unit explains a gap on its own, and the unit is said") {
  for (const auto& [per_metre, unit] :
       {std::pair{1000.0, "mm"}, {100.0, "cm"}, {1.0 / 0.0254, "inches"}, {1.0 / 0.3048, "feet"}}) {
    INFO(unit);
    auto log = clean_log();
    for (auto& sample : log.samples) {
      if (!sample.reference_x_m) continue;
      *sample.reference_x_m *= per_metre;
      *sample.reference_y_m *= per_metre;
    }
    const auto gated = gate(log);
    const auto said = std::ranges::find_if(gated.faults, &DataFault::explains);
    REQUIRE(said != gated.faults.end());
    CHECK_THAT(said->what, ContainsSubstring(std::string("is it in ") + unit + "?"));
  }
}

TEST_CASE("Counts that stand still while their wheel turns are a dropout of the encoder") {
  auto log = clean_log();
  const std::size_t from = moving_row(log) - 25;
  const auto frozen = log.samples[from].ticks->left;
  for (std::size_t i = from; i < from + 20; ++i) log.samples[i].ticks->left = frozen;
  const auto gated = gate(log);
  REQUIRE_FALSE(gated.dropouts.empty());
  CHECK_THAT(gated.dropouts.front().start_s, WithinAbs(log.samples[from].t_s, 0.1));
  CHECK_THAT(gated.dropouts.front().duration_s, WithinAbs(20 * log.period_s, 0.1));
}

TEST_CASE("A wheel that stood is no dropout where a reference saw the robot move as the counts say") {
  auto log = clean_log();
  const std::size_t from = moving_row(log) - 25;
  const auto turned = test::by_counts(log);
  lose_counts(log, from, 20);
  const auto stood = gate(test::by_counts(log));
  CHECK(stood.dropouts.empty());
  REQUIRE(stood.faults.size() == 1);
  CHECK(stood.faults.front().happened);
  CHECK(stood.faults.front().row == log.first_line + from + 1);
  CHECK_THAT(stood.faults.front().what, ContainsSubstring("the left wheel was held for 0.3"));

  for (std::size_t i = 0; i < log.samples.size(); ++i) {
    log.samples[i].reference_x_m = turned.samples[i].reference_x_m;
    log.samples[i].reference_y_m = turned.samples[i].reference_y_m;
    log.samples[i].reference_theta_rad = turned.samples[i].reference_theta_rad;
  }
  const auto uncounted = gate(log);
  CHECK(uncounted.dropouts.size() == 1);
  CHECK_FALSE(uncounted.faults.front().happened);
}

TEST_CASE("Stops that are too short for one reference to tell are told by all of them together") {
  auto log = clean_log();
  const std::size_t last = moving_row(log);
  const auto seen_turning = test::by_counts(log);
  for (const std::size_t back : {45u, 32u, 19u}) lose_counts(log, last - back, 8);
  const auto seen_standing = test::by_counts(log);
  const auto by_a_poor_tracker = [&](const DriveLog& reference) {
    DriveLog seen = log;
    std::mt19937 random(1);
    std::normal_distribution<double> errs_m(0.0, 0.003);
    for (std::size_t i = 0; i < seen.samples.size(); ++i) {
      seen.samples[i].reference_x_m = *reference.samples[i].reference_x_m + errs_m(random);
      seen.samples[i].reference_y_m = *reference.samples[i].reference_y_m + errs_m(random);
      seen.samples[i].reference_theta_rad = reference.samples[i].reference_theta_rad;
    }
    return gate(seen);
  };
  const auto stood = by_a_poor_tracker(seen_standing);
  CHECK(stood.dropouts.empty());
  CHECK(std::ranges::count_if(stood.faults, &DataFault::happened) == 3);
  CHECK(by_a_poor_tracker(seen_turning).dropouts.size() >= 3);
}

TEST_CASE("Stops that a late reference shows late are stops") {
  auto log = clean_log();
  const std::size_t last = moving_row(log);
  for (const std::size_t back : {44u, 24u}) lose_counts(log, last - back, 12);
  log = test::by_counts(log);
  const auto with_late_reference = [](DriveLog seen, std::size_t rows) {
    for (std::size_t i = seen.samples.size(); i-- > 0;) {
      const DriveSample& before = seen.samples[i - std::min(i, rows)];
      seen.samples[i].reference_x_m = before.reference_x_m;
      seen.samples[i].reference_y_m = before.reference_y_m;
      seen.samples[i].reference_theta_rad = before.reference_theta_rad;
    }
    return gate(seen);
  };
  for (const std::size_t rows : {0u, 3u, 8u}) {
    INFO(rows << " rows late");
    const auto stood = with_late_reference(log, rows);
    CHECK(stood.dropouts.empty());
    CHECK(std::ranges::count_if(stood.faults, &DataFault::happened) == 2);
  }
}

TEST_CASE("Whether a wheel was held, the references of all runs tell together") {
  auto held = clean_log();
  const std::size_t last = moving_row(held);
  for (const std::size_t back : {45u, 32u, 19u}) lose_counts(held, last - back, 8);
  held = test::by_counts(held);
  DriveLog unseen = held;
  for (DriveSample& sample : unseen.samples)
    sample.reference_x_m = sample.reference_y_m = sample.reference_theta_rad = std::nullopt;
  CHECK(gate(unseen).dropouts.size() >= 3);

  const auto together = gate_together(std::vector{unseen, held});
  CHECK(together[0].dropouts.empty());
  CHECK(together[1].dropouts.empty());
  CHECK(std::ranges::count_if(together[0].faults, &DataFault::happened) == 3);
}

TEST_CASE("Counts that were lost while driving are looked for at stops, too") {
  test::GapCaseSpec spec;
  spec.runs = 1;
  spec.seconds = 60.0;
  const auto log = test::make_gap_case(spec).runs.front();
  const auto stops = stopping_rows(log);
  REQUIRE(stops.size() >= 2);
  const std::size_t stop = stops.back();
  CHECK(gate(log).dropouts.empty());

  auto stopping = log;
  lose_counts(stopping, stop - 10, 60);
  CHECK(gate(stopping).dropouts.empty());  // something may have held the wheel

  auto losing = stopping;
  lose_counts(losing, moving_row(log) - 40, 10);
  lose_counts(losing, moving_row(log) - 20, 10);
  const auto gated = gate(losing);
  REQUIRE(gated.dropouts.size() == 3);
  CHECK_THAT(gated.dropouts.back().start_s, WithinAbs(log.samples[stop - 10].t_s, 0.05));
  CHECK(gated.flags.counts[stop] == 1);
}

TEST_CASE("Counts that one run surely lost are looked for at stops of the others") {
  test::GapCaseSpec spec;
  spec.runs = 2;
  spec.seconds = 60.0;
  auto runs = test::make_gap_case(spec).runs;
  const auto stops = stopping_rows(runs[1]);
  REQUIRE_FALSE(stops.empty());
  lose_counts(runs[1], stops.back() - 10, 60);
  CHECK(gate_together(runs)[1].dropouts.empty());

  lose_counts(runs[0], moving_row(runs[0]) - 40, 10);
  CHECK(gate_together(runs)[1].dropouts.empty());  // something may have held a wheel in both
  lose_counts(runs[0], moving_row(runs[0]) - 20, 10);
  const auto gated = gate_together(runs);
  CHECK(gated[0].dropouts.size() == 2);
  const double lost_s = runs[1].samples[stops.back() - 10].t_s;
  CHECK(std::ranges::any_of(gated[1].dropouts, [lost_s](const Dropout& dropout) {
    return std::abs(dropout.start_s - lost_s) < 0.05 && dropout.duration_s > 1.0;
  }));
}

TEST_CASE("What a reference saw while counts were lost is not held against them") {
  auto log = test::by_counts(clean_log());
  const std::size_t from = moving_row(log) - 25;
  lose_counts(log, from, 20);
  const auto gated = gate(log);
  REQUIRE(gated.dropouts.size() == 1);
  const GapRun run = make_gap_run(gated.log, gated.flags, log.period_s);
  REQUIRE(run.references.size() == log.samples.size());
  CHECK_FALSE(run.references[from].counts_lost);
  for (std::size_t i = from + 1; i <= from + 21; ++i) CHECK(run.references[i].counts_lost);
  CHECK_FALSE(run.references[from + 22].counts_lost);
  for (const auto& sample : with_lost_counts(gated.log).samples) CHECK_FALSE(sample.counter_reset);
}

TEST_CASE("No travel is measured across lost counts") {
  auto log = clean_log();
  const std::size_t from = moving_row(log) - 25;
  for (std::size_t i = from; i < from + 20; ++i) log.samples[i].ticks->left = log.samples[from].ticks->left;
  const auto gated = gate(log);
  CHECK_FALSE(gated.log.samples[from].counter_reset);
  for (std::size_t i = from + 1; i <= from + 20; ++i) CHECK(gated.log.samples[i].counter_reset);
  CHECK_FALSE(gated.log.samples[from + 21].counter_reset);

  auto silent = clean_log();
  silent.samples[from].ticks.reset();
  CHECK(gate(silent).log.samples[from + 1].counter_reset);
  CHECK_FALSE(gate(silent).log.samples[from + 2].counter_reset);
}

TEST_CASE("An answer that comes late is an effect, not a fault of the data") {
  test::GapCaseSpec spec;
  spec.name = "transport_delay";
  spec.severity = test::Severity::large;  // 0.6 s: longer than the windows that commands are compared in
  spec.runs = 4;
  spec.seconds = 60.0;
  for (const auto& log : test::make_gap_case(spec).runs) CHECK(gate(log).faults.empty());
}

TEST_CASE("Where rows are missing the next second is left out, and nothing is made of the rest") {
  auto log = clean_log();
  const auto from = log.samples.begin() + 400;
  log.samples.erase(from, from + 150);
  const auto gated = gate(log);
  REQUIRE(gated.faults.size() == 1);
  CHECK(gated.faults.front().row == log.first_line + 400);
  CHECK_FALSE(gated.faults.front().distorts);
  CHECK_FALSE(gated.faults.front().explains);
  const GapRun run = make_gap_run(gated.log, gated.flags, log.period_s);
  const Series& left = run[Channel::left];
  const double behind_s = log.samples[400].t_s;
  for (std::size_t i = 0; i < left.at.size(); ++i) {
    const double t_s = log.samples.front().t_s + log.period_s * static_cast<double>(left.at[i].period);
    const bool in_the_next_second = t_s > behind_s - 0.5 * log.period_s && t_s < behind_s + 0.95;
    CHECK_FALSE(in_the_next_second);
  }
  CHECK(std::ranges::count(left.restarts, char{1}) == 1);
}
