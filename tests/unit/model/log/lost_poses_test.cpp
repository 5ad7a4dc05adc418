#include "model/log/lost_poses.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// A robot on a circle, in 20 ms.
struct Track {
  std::vector<double> x, y, heading;
};

Track circle(int rows = 500) {
  Track track;
  for (int row = 0; row < rows; ++row) {
    const double angle = 0.01 * row;
    track.x.push_back(1.0 + 0.5 * std::sin(angle));
    track.y.push_back(2.0 - 0.5 * std::cos(angle));
    track.heading.push_back(angle);
  }
  return track;
}

void check_stretch(const std::vector<RowStretch>& found, std::size_t begin, std::size_t end) {
  REQUIRE(found.size() == 1);
  CHECK(found.front().begin == begin);
  CHECK(found.front().end == end);
}

}  // namespace

TEST_CASE("A robot on its way has no pose that was not measured") {
  const Track track = circle();
  CHECK(lost_stretches(track.x, track.y).empty());
  CHECK(outlier_stretches(track.x).empty());
  CHECK(outlier_stretches(track.heading).empty());
  CHECK(held_stretches(track.x, track.y, track.heading).empty());
}

TEST_CASE("A number in place of x and y is a lost pose, also at either end") {
  for (const std::size_t begin : {std::size_t{0}, std::size_t{200}, std::size_t{480}}) {
    INFO(begin);
    Track track = circle();
    for (std::size_t row = begin; row < begin + 20; ++row) track.x[row] = track.y[row] = -1.0;
    check_stretch(lost_stretches(track.x, track.y), begin, begin + 20);
  }
}

TEST_CASE("A robot that stands at the origin is not lost, nor one that is set back there") {
  std::vector<double> x;
  std::vector<double> y;
  for (int lap = 0; lap < 3; ++lap) {
    x.insert(x.end(), 50, 0.0);
    y.insert(y.end(), 50, 0.0);
    for (int row = 0; row < 200; ++row) {
      x.push_back(0.01 * row);
      y.push_back(0.005 * row);
    }
  }
  CHECK(lost_stretches(x, y).empty());
}

TEST_CASE("Rows without a pose between those of a lost one belong to it") {
  std::vector<double> x;
  std::vector<double> y;
  for (int row = 0; row < 300; ++row) {
    const bool placed = row % 5 == 0;
    const bool lost = row / 50 == 2;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    x.push_back(!placed ? none : lost ? -1.0 : 1.0 + 0.01 * row);
    y.push_back(!placed ? none : lost ? -1.0 : 2.0 + 0.005 * row);
  }
  check_stretch(lost_stretches(x, y), 100, 150);
}

TEST_CASE("One value to three that lie apart are outliers, four are not") {
  for (const std::size_t length : {std::size_t{1}, std::size_t{3}, std::size_t{4}}) {
    INFO(length);
    Track track = circle();
    for (std::size_t row = 200; row < 200 + length; ++row) track.x[row] += 0.1;
    const auto found = outlier_stretches(track.x);
    if (length == 4) {
      CHECK(found.empty());
    } else {
      check_stretch(found, 200, 200 + length);
    }
  }
}

TEST_CASE("A robot that rests for most of a log and turns back at once is no outlier") {
  std::vector<double> x(2000, 0.0);
  for (std::size_t row = 0; row < x.size(); ++row) x[row] = row % 2 == 0 ? 0.0 : 0.0002;  // noise
  for (int row = 0; row < 20; ++row) x.push_back(0.006 * row);
  for (int row = 20; row > 0; --row) x.push_back(0.006 * row);
  CHECK(outlier_stretches(x).empty());
}

TEST_CASE("The last pose again and then a jump was held, a pose of a robot at rest was not") {
  Track track = circle();
  for (std::size_t row = 201; row < 240; ++row) {
    track.x[row] = track.x[200];
    track.y[row] = track.y[200];
    track.heading[row] = track.heading[200];
  }
  check_stretch(held_stretches(track.x, track.y, track.heading), 201, 240);

  Track resting = circle(200);
  for (int row = 0; row < 100; ++row) {
    resting.x.push_back(resting.x[199]);
    resting.y.push_back(resting.y[199]);
    resting.heading.push_back(resting.heading[199]);
  }
  for (int row = 0; row < 100; ++row) {
    resting.x.push_back(resting.x[299] + 0.005 * row);
    resting.y.push_back(resting.y[299]);
    resting.heading.push_back(resting.heading[299]);
  }
  CHECK(held_stretches(resting.x, resting.y, resting.heading).empty());
}
