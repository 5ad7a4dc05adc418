#include "drivers/open_interface/stream_reader.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"

using namespace wheelwright::open_interface;

namespace {

std::vector<Reading> readings_in(StreamReader& reader, const Bytes& bytes) {
  std::vector<Reading> readings;
  for (const std::uint8_t byte : bytes) {
    if (const auto reading = reader.take(byte)) readings.push_back(*reading);
  }
  return readings;
}

Bytes frame_of(const StreamReader& reader, const SensorValues& values,
               ChecksumRule rule = ChecksumRule::header_included) {
  return stream_frame(reader.packets(), values, rule);
}

// What may lie between frames: bytes at random, headers, beginnings of frames, text.
Bytes rubbish(Random& random, const Bytes& frame) {
  switch (between(random, 0, 5)) {
    case 0:
      return noise(random, between(random, 0, 200));
    case 1:
      return Bytes(static_cast<std::size_t>(between(random, 1, 100)), 19);
    case 2:
      // Where only the end is missing, the next frame's start may complete it: one sum in 256 says so.
      return Bytes(frame.begin(), frame.begin() + between(random, 1, static_cast<int>(frame.size()) - 5));
    case 3:
      return Bytes(frame.begin() + between(random, 1, static_cast<int>(frame.size()) - 1), frame.end());
    case 4:
      return text("battery-current-zero 259\r\n");
    default:
      return {19, frame[1], 22, any_byte(random), 19, frame[1]};
  }
}

void damage(Random& random, Bytes& frame) {
  const int at = between(random, 0, static_cast<int>(frame.size()) - 1);
  switch (between(random, 0, 2)) {
    case 0:
      frame.erase(frame.begin() + at);
      break;
    case 1:
      insert_at(frame, at, noise(random, between(random, 1, 5)));
      break;
    default:
      frame.at(static_cast<std::size_t>(at)) ^= static_cast<std::uint8_t>(1U << between(random, 0, 7));
  }
}

}  // namespace

TEST_CASE("A frame is read whole, with every value at its place") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    StreamReader reader;
    const SensorValues values = driving_robot(random);
    const auto readings = readings_in(reader, frame_of(reader, values));
    REQUIRE(readings.size() == 1);
    CHECK(says(readings[0], values));
    CHECK(reader.counts().stray_bytes == 0);
  }
}

TEST_CASE("The checksum rule is found out by itself, and no frame is lost over it") {
  for (const auto rule : {ChecksumRule::header_included, ChecksumRule::header_excluded}) {
    StreamReader reader;
    Random random(2);
    CHECK(reader.rule() == ChecksumRule::unknown);
    for (int i = 0; i < 50; ++i) {
      CHECK(readings_in(reader, frame_of(reader, driving_robot(random), rule)).size() == 1);
    }
    CHECK(reader.rule() == rule);
    CHECK(reader.counts().corrupt == 0);
  }
}

TEST_CASE("Once the rule is known a frame of the other rule is damaged") {
  StreamReader reader;
  Random random(3);
  for (int i = 0; i < 50; ++i) readings_in(reader, frame_of(reader, driving_robot(random)));
  const Bytes other = frame_of(reader, driving_robot(random), ChecksumRule::header_excluded);
  CHECK(readings_in(reader, other).empty());
  CHECK(reader.counts().corrupt == 1);
}

TEST_CASE("Damaged frames at the start do not settle the wrong rule") {
  Random random(4);
  for (int run = 0; run < 50; ++run) {
    StreamReader reader;
    for (int i = 0; i < 400 && reader.rule() == ChecksumRule::unknown; ++i) {
      Bytes frame = frame_of(reader, driving_robot(random));
      if (between(random, 0, 1) == 0) damage(random, frame);
      readings_in(reader, frame);
    }
    CHECK(reader.rule() == ChecksumRule::header_included);
  }
}

TEST_CASE("Rubbish between frames never costs a frame and never makes one") {
  Random random(5);
  for (const auto rule : {ChecksumRule::header_included, ChecksumRule::header_excluded}) {
    StreamReader reader;
    for (int i = 0; i < 5000; ++i) {
      const SensorValues values = driving_robot(random);
      const Bytes frame = frame_of(reader, values, rule);
      Bytes bytes = rubbish(random, frame_of(reader, driving_robot(random), rule));
      append(bytes, frame);
      const auto readings = readings_in(reader, bytes);
      REQUIRE(readings.size() == 1);
      REQUIRE(says(readings[0], values));
    }
    CHECK(reader.counts().frames == 5000);
  }
}

TEST_CASE("A damaged frame does not take the next one with it") {
  Random random(6);
  StreamReader reader;
  for (int i = 0; i < 50; ++i) readings_in(reader, frame_of(reader, driving_robot(random)));
  for (int i = 0; i < 10000; ++i) {
    Bytes bytes = frame_of(reader, driving_robot(random));
    damage(random, bytes);
    const SensorValues values = driving_robot(random);
    append(bytes, frame_of(reader, values));
    const auto readings = readings_in(reader, bytes);
    REQUIRE(!readings.empty());
    REQUIRE(says(readings.back(), values));
  }
}

TEST_CASE("No single damaged byte passes for a sound frame") {
  Random random(7);
  StreamReader reader;
  for (int i = 0; i < 50; ++i) readings_in(reader, frame_of(reader, driving_robot(random)));
  for (int i = 0; i < 20000; ++i) {
    Bytes frame = frame_of(reader, driving_robot(random));
    frame.at(static_cast<std::size_t>(between(random, 0, static_cast<int>(frame.size()) - 1))) ^=
        static_cast<std::uint8_t>(between(random, 1, 255));
    REQUIRE(readings_in(reader, frame).empty());
    readings_in(reader, Bytes(200, 0));
  }
}

TEST_CASE("A frame with a value that no robot has is damaged although its checksum holds") {
  StreamReader reader;
  Random random(8);
  SensorValues values = driving_robot(random);
  values[PacketId::light_bump_left_signal] = 4096;
  CHECK(readings_in(reader, frame_of(reader, values)).empty());
  CHECK(reader.counts().corrupt == 1);
}

TEST_CASE("Text between frames is collected") {
  StreamReader reader;
  Random random(9);
  readings_in(reader, frame_of(reader, driving_robot(random)));
  readings_in(reader, text("do-charging-complete\r\n"));
  readings_in(reader, frame_of(reader, driving_robot(random)));
  CHECK(reader.stray_text().finished() == "do-charging-complete");
}

TEST_CASE("Each damaged frame between two sound ones is known, whatever was damaged of it") {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    StreamReader reader;
    const SensorValues values = driving_robot(random);
    readings_in(reader, frame_of(reader, values));
    const int lost = between(random, 0, 5);
    bool all_show = true;  // one sum in 256 does not
    for (int k = 0; k < lost; ++k) {
      Bytes frame = frame_of(reader, values);
      damage(random, frame);
      all_show = readings_in(reader, frame).empty() && all_show;
    }
    if (!all_show) continue;
    INFO(lost);
    REQUIRE(readings_in(reader, frame_of(reader, values)).size() == 1);
    CHECK(reader.damaged_before() == lost);
    REQUIRE(readings_in(reader, frame_of(reader, values)).size() == 1);
    CHECK(reader.damaged_before() == 0);
  }
}

TEST_CASE("What a robot sends before its first frame is no damage") {
  Random random(8);
  StreamReader reader;
  readings_in(reader, text("bl-start\r\n2007-05-14-1715-L \r\nRDK by iRobot!\r\n"));
  REQUIRE(readings_in(reader, frame_of(reader, driving_robot(random))).size() == 1);
  CHECK(reader.damaged_before() == 0);
}
