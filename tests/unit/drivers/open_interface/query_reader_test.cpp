#include "drivers/open_interface/query_reader.hpp"

#include <cstdlib>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"

using namespace wheelwright::open_interface;

namespace {

std::optional<Reading> reading_in(QueryReader& reader, const Bytes& bytes) {
  std::optional<Reading> found;
  for (const std::uint8_t byte : bytes) {
    if (const auto reading = reader.take(byte)) {
      CHECK(!found);  // one at most to each query
      found = reading;
    }
  }
  return found;
}

struct Exchange {
  SensorValues values;
  Bytes reply;
};

Exchange ask(QueryReader& reader, Random& random) {
  Exchange exchange;
  exchange.values = driving_robot(random);
  exchange.reply = reply_to(reader.begin(), exchange.values);
  return exchange;
}

// The voltage is a mark, and its two copies may differ: read apart, they need not be of the same refresh.
bool says_but_for_a_little_voltage(const Reading& reading, SensorValues values) {
  const bool near = std::abs(reading.voltage_mv - values[PacketId::voltage]) <= 300;
  values[PacketId::voltage] = reading.voltage_mv;
  return near && says(reading, values);
}

constexpr std::string_view robot_text = "do-charging: battery-current-mean -15, counter 65529\r\n";

int place_in(Random& random, const Bytes& bytes) {
  return between(random, 0, static_cast<int>(bytes.size()) - 1);
}

// What a bad cable, a busy adapter or the robot itself does to a reply, where it does not leave just as many
// bytes: against those that are exchanged for others in place a reply without a checksum has no defence but
// ranges.
Bytes displaced(Random& random, Bytes bytes) {
  switch (between(random, 0, 7)) {
    case 0:
      bytes.erase(bytes.begin() + place_in(random, bytes));
      break;
    case 1:
      insert_at(bytes, place_in(random, bytes), noise(random, 1));
      break;
    case 2:
      insert_at(bytes, place_in(random, bytes), noise(random, between(random, 2, 20)));
      break;
    case 3:
      insert_at(bytes, between(random, 0, static_cast<int>(bytes.size())), text(robot_text));
      break;
    case 4:
      bytes.resize(static_cast<std::size_t>(place_in(random, bytes)));
      break;
    case 5:
      bytes.erase(bytes.begin(), bytes.begin() + place_in(random, bytes) + 1);
      break;
    case 6: {
      const int from = place_in(random, bytes);
      bytes.erase(bytes.begin() + from,
                  bytes.begin() + between(random, from, static_cast<int>(bytes.size())));
      break;
    }
    default:
      bytes = noise(random, between(random, 0, 100));
  }
  return bytes;
}

}  // namespace

TEST_CASE("A reply is read whole, with every value at its place") {
  Random random(11);
  QueryReader reader;
  for (int i = 0; i < 2000; ++i) {
    const Exchange exchange = ask(reader, random);
    const auto reading = reading_in(reader, exchange.reply);
    REQUIRE(reading);
    CHECK(says(*reading, exchange.values));
  }
  CHECK(reader.counts().asked == 2000);
  CHECK(reader.counts().sound == 2000);
  CHECK(reader.counts().stray_bytes == 0);
}

TEST_CASE("Rubbish in front of a reply and behind it does not touch it") {
  Random random(12);
  QueryReader reader;
  for (int i = 0; i < 20000; ++i) {
    const Exchange exchange = ask(reader, random);
    Bytes bytes = i % 2 == 0 ? text(robot_text) : noise(random, between(random, 1, 100));
    append(bytes, exchange.reply);
    append(bytes, text(robot_text));
    const auto reading = reading_in(reader, bytes);
    REQUIRE(reading);
    REQUIRE(says(*reading, exchange.values));
  }
}

TEST_CASE("A reply that comes one, two or three ticks late is not taken for the new one") {
  Random random(13);
  for (int late = 1; late <= 3; ++late) {
    QueryReader reader;
    std::vector<Exchange> sent;
    int taken = 0;
    for (int i = 0; i < 2000; ++i) {
      sent.push_back(ask(reader, random));
      if (i < late) continue;
      taken += reading_in(reader, sent.at(static_cast<std::size_t>(i - late)).reply) ? 1 : 0;
    }
    INFO(late);
    CHECK(taken == 0);
  }
}

TEST_CASE("After late replies in a row the new one is found behind them") {
  Random random(14);
  for (int late = 1; late <= 3; ++late) {
    QueryReader reader;
    for (int i = 0; i < 2000; ++i) {
      Bytes held_up;
      for (int k = 0; k < late; ++k) append(held_up, ask(reader, random).reply);
      const Exchange exchange = ask(reader, random);
      append(held_up, exchange.reply);
      const auto reading = reading_in(reader, held_up);
      REQUIRE(reading);
      REQUIRE(says(*reading, exchange.values));
    }
  }
}

TEST_CASE("Two replies in a row are one reading, and the next tick is sound") {
  Random random(15);
  QueryReader reader;
  for (int i = 0; i < 1000; ++i) {
    const Exchange exchange = ask(reader, random);
    Bytes twice = exchange.reply;
    append(twice, exchange.reply);
    REQUIRE(reading_in(reader, twice));
  }
  CHECK(reader.counts().sound == 1000);
  CHECK(reader.counts().stray_bytes == 1000 * reader.reply_bytes());
}

TEST_CASE("Half a reply, its other half a tick late, costs one sample") {
  Random random(16);
  QueryReader reader;
  for (int i = 0; i < 5000; ++i) {
    const Exchange halved = ask(reader, random);
    const int cut = place_in(random, halved.reply);
    CHECK(!reading_in(reader, Bytes(halved.reply.begin(), halved.reply.begin() + cut)));
    const Exchange whole = ask(reader, random);
    Bytes bytes(halved.reply.begin() + cut, halved.reply.end());
    append(bytes, whole.reply);
    const auto reading = reading_in(reader, bytes);
    REQUIRE(reading);
    REQUIRE(says(*reading, whole.values));
  }
}

TEST_CASE("Displaced bytes give no wrong reading, and the next reply comes through unharmed") {
  Random random(17);
  QueryReader reader;
  int wrong = 0;
  int spoilt = 0;
  constexpr int replies = 300'000;
  for (int i = 0; i < replies; ++i) {
    const Exchange damaged = ask(reader, random);
    const Bytes bytes = displaced(random, damaged.reply);
    const auto reading = reading_in(reader, bytes);
    wrong += reading && !says_but_for_a_little_voltage(*reading, damaged.values) ? 1 : 0;
    const Exchange next = ask(reader, random);
    const auto sound = reading_in(reader, next.reply);
    spoilt += sound && says(*sound, next.values) ? 0 : 1;
  }
  CHECK(spoilt == 0);
  CHECK(wrong <= replies / 100'000);
}

TEST_CASE("A flipped bit in a mark costs the sample, and behind it the next reply comes through unharmed") {
  Random random(18);
  QueryReader reader;
  int spoilt = 0;
  for (int i = 0; i < 50'000; ++i) {
    Exchange damaged = ask(reader, random);
    damaged.reply.at(static_cast<std::size_t>(place_in(random, damaged.reply))) ^=
        static_cast<std::uint8_t>(1U << between(random, 0, 7));
    reading_in(reader, damaged.reply);
    const Exchange next = ask(reader, random);
    const auto sound = reading_in(reader, next.reply);
    spoilt += sound && says(*sound, next.values) ? 0 : 1;
  }
  CHECK(spoilt == 0);
}

TEST_CASE("Values that no robot has are refused") {
  using enum PacketId;
  Random random(19);
  const auto refuses = [&](PacketId id, int value) {
    QueryReader reader;
    SensorValues values = driving_robot(random);
    values[id] = value;
    return !reading_in(reader, reply_to(reader.begin(), values));
  };
  CHECK(refuses(oi_mode, 5));
  CHECK(refuses(voltage, 5999));
  CHECK(refuses(voltage, 24001));
  CHECK(refuses(bumps_and_wheel_drops, 16));
  CHECK(refuses(cliff_left, 2));
  CHECK(refuses(charging_state, 6));
  CHECK(refuses(light_bump_right_signal, 4096));
}

TEST_CASE("What came and what did not is counted") {
  Random random(20);
  QueryReader reader;
  ask(reader, random);
  const Exchange cut = ask(reader, random);
  reading_in(reader, Bytes(cut.reply.begin(), cut.reply.end() - 1));
  ask(reader, random);
  reading_in(reader, Bytes(50, 0xFF));
  reading_in(reader, ask(reader, random).reply);
  reader.begin();
  CHECK(reader.counts().asked == 5);
  CHECK(reader.counts().missing == 1);
  CHECK(reader.counts().incomplete == 1);
  CHECK(reader.counts().garbled == 1);
  CHECK(reader.counts().sound == 1);
  CHECK(reader.counts().stray_bytes == reader.reply_bytes() - 1 + 50);
}

TEST_CASE("Text is collected whole although it comes while a reply is awaited, and across ticks") {
  Random random(21);
  QueryReader reader;
  ask(reader, random);
  reading_in(reader, text("bl-start"));
  ask(reader, random);
  reading_in(reader, text(" STR730\r\n"));
  ask(reader, random);
  CHECK(reader.stray_text().finished() == "bl-start STR730");
}
