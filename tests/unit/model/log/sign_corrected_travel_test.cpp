// What the counter learnt late of a wheel's direction, put where it belongs.
#include "model/log/sign_corrected_travel.hpp"

#include "drivers/open_interface/encoder_counter.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

struct Counts : CountedTravel {
  std::vector<std::int64_t> truly;
};

std::vector<std::int64_t> settled_alone(const CountedTravel& run) {
  return sign_corrected_travel(std::span(&run, 1)).front();
}

// Reversals of a wheel whose encoder counts in the direction of the command, as a Roomba's does.
Counts back_and_forth() {
  open_interface::EncoderCounter counter;
  Counts counts;
  double position = 0.0;
  double speed = 0.0;
  std::int64_t raw = 0;
  std::int64_t before = 0;
  for (int k = 0; k < 1200; ++k) {
    const double command = (k / 60) % 2 == 0 ? 10.0 : -10.0;
    const bool late = k % 60 < 2 && k >= 60;
    speed += 0.4 * ((late ? -command : command) - speed);
    position += speed;
    const auto now = static_cast<std::int64_t>(std::floor(position));
    raw += (command > 0.0 ? 1 : -1) * std::abs(now - before);
    before = now;
    counter.update(static_cast<std::uint16_t>(raw), command, 1000);
    counts.counted.push_back(counter.counted());
    counts.travel.push_back(counter.total());
    counts.truly.push_back(now);
  }
  for (std::size_t k = counts.truly.size(); k-- > 0;) counts.truly[k] -= counts.truly.front();
  return counts;
}

std::int64_t farthest_off(const std::vector<std::int64_t>& one, const std::vector<std::int64_t>& other) {
  std::int64_t farthest = 0;
  for (std::size_t k = 0; k < one.size(); ++k) farthest = std::max(farthest, std::abs(one[k] - other[k]));
  return farthest;
}

}  // namespace

TEST_CASE("A wheel's turn is put where the wheel was slowest") {
  const Counts counts = back_and_forth();
  const auto settled = settled_alone(counts);
  std::int64_t jumps = 0;
  for (std::size_t k = 1; k < settled.size(); ++k) {
    CHECK(std::abs(settled[k] - settled[k - 1]) <= 11);
    jumps += std::abs(counts.travel[k] - counts.travel[k - 1]) > 11 ? 1 : 0;
  }
  CHECK(jumps >= 15);  // without it there are as many as turns
  CHECK(farthest_off(counts.travel, counts.truly) > 6);
  CHECK(farthest_off(settled, counts.truly) <= 3);
}

TEST_CASE("Travel whose signs were known at once stays as it is") {
  const std::vector<std::int64_t> travel{0, 3, 8, 12, 12, 9, 2, -6, -14};
  CHECK(settled_alone({travel, travel}) == travel);
}

TEST_CASE("Counts that tell their direction are believed, whatever was made of their signs") {
  const std::vector<std::int64_t> counted{0, 8, 16, 21, 22, 19, 12, 4};
  const std::vector<std::int64_t> travel{0, 8, 16, 21, 20, 17, 24, 8};
  CHECK(settled_alone({counted, travel}) == counted);
}

TEST_CASE("A stop that looks as smooth either way is settled by the other runs of the robot") {
  // Backwards, and after the stop a count whose sign follows the command. It pauses as the sign changes.
  const CountedTravel stop{{0, -5, -10, -10, -8, -6, -5}, {0, -5, -10, -10, -12, -14, -15}};
  CHECK(settled_alone(stop) == stop.counted);
  const Counts others = back_and_forth();
  CHECK(sign_corrected_travel(std::vector<CountedTravel>{others, stop}).back() == stop.travel);
  const CountedTravel tells_its_direction{{0, 8, 16, 21, 22, 19, 12, 4}, {0, 8, 16, 21, 20, 17, 24, 8}};
  CHECK(sign_corrected_travel(std::vector<CountedTravel>{tells_its_direction, stop}).back() == stop.counted);
}

TEST_CASE("A log of the daemon gets its travel as ticks, another one stays as it is") {
  DriveLog log;
  log.metres_per_tick = WheelPair{4e-4, 4e-4};
  for (const std::int64_t count : {0, 6, 11, 8, 5, -1}) {
    DriveSample sample;
    sample.ticks = {count, count};
    log.samples.push_back(sample);
  }
  const DriveLog plain = log;
  take_sign_corrected_travel(std::span(&log, 1));
  CHECK(log.samples[4].ticks->left == plain.samples[4].ticks->left);
  // Slowest in the fourth reading; what came after went back.
  const std::vector<double> known{0, 6, 11, 14, 17, 2};
  log.extra_columns = {{"travel_ticks_left", known, {}}, {"travel_ticks_right", known, {}}};
  take_sign_corrected_travel(std::span(&log, 1));
  std::vector<std::int64_t> left;
  for (const auto& sample : log.samples) left.push_back(sample.ticks->left);
  CHECK(left == std::vector<std::int64_t>{0, 6, 11, 12, 9, 3});
}
