#include "drivers/simulation/faulty_cable.hpp"

#include <array>
#include <vector>

#include "drivers/simulation/misread_byte.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::simulation;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::nanoseconds step = 1ms;

// Sends a packet of ten bytes to the host every 20 ms until a fault of one kind is over, and on for a while.
struct Drive {
  explicit Drive(CableFaultKind kind, std::uint64_t seed)
      : cable({.seed = seed, .kinds = {kind}, .first_after_s = 0.1, .shortest_pause_s = 60.0}) {
    for (auto now = 0ns; now < 5s && !(record && now > record->fault.until + 300ms); now += step) {
      if (now % 20ms == 0ns) send(now);
      if (!cable.connected(now)) seen_unplugged = true;
      std::array<std::uint8_t, 64> bytes{};
      while (const std::size_t count = cable.take(Direction::to_host, bytes, now)) {
        received.insert(received.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
      }
      if (const auto finished = cable.next_finished()) record = finished;
    }
  }

  void send(std::chrono::nanoseconds now) {
    std::array<std::uint8_t, 10> packet{};
    for (std::uint8_t& byte : packet) byte = next++;
    sent.insert(sent.end(), packet.begin(), packet.end());
    cable.put(Direction::to_host, packet, now);
  }

  FaultyCable cable;
  std::uint8_t next = 0;
  std::vector<std::uint8_t> sent;
  std::vector<std::uint8_t> received;
  std::optional<CableFaultRecord> record;
  bool seen_unplugged = false;
};

}  // namespace

TEST_CASE("What a fault has hit is what is missing, changed or doubled at the other end") {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    for (const auto kind : {CableFaultKind::delay, CableFaultKind::jitter, CableFaultKind::freeze}) {
      const Drive drive(kind, seed);
      REQUIRE(drive.record);
      CHECK(drive.received == drive.sent);
    }
    for (const auto kind : {CableFaultKind::drop, CableFaultKind::half_packet, CableFaultKind::disconnect}) {
      const Drive drive(kind, seed);
      CHECK(static_cast<std::int64_t>(drive.sent.size() - drive.received.size()) == drive.record->bytes_hit);
    }
    const Drive doubled(CableFaultKind::duplicate, seed);
    CHECK(static_cast<std::int64_t>(doubled.received.size() - doubled.sent.size()) ==
          doubled.record->bytes_hit);
    const Drive flipped(CableFaultKind::flip, seed);
    REQUIRE(flipped.received.size() == flipped.sent.size());
    std::int64_t changed = 0;
    for (std::size_t i = 0; i < flipped.sent.size(); ++i) changed += flipped.received[i] != flipped.sent[i];
    CHECK(changed == flipped.record->bytes_hit);
    CHECK(Drive(CableFaultKind::disconnect, seed).seen_unplugged);
  }
}

TEST_CASE("The same seed brings the same faults, another seed others") {
  CableFaultSequence first({.seed = 5});
  CableFaultSequence again({.seed = 5});
  CableFaultSequence other({.seed = 6});
  bool all_alike = true;
  auto ended = 0ns;
  for (int i = 0; i < 100; ++i) {
    const CableFault fault = first.next();
    const CableFault same = again.next();
    CHECK(fault.kind == same.kind);
    CHECK(fault.from == same.from);
    CHECK(fault.until == same.until);
    CHECK(fault.from >= ended + 2s);
    CHECK((fault.to_host || fault.to_robot));
    ended = fault.until;
    all_alike = all_alike && other.next().from == fault.from;
  }
  CHECK_FALSE(all_alike);
}

TEST_CASE("Every kind of fault is known by its name") {
  for (int kind = 0; kind < cable_fault_kinds; ++kind) {
    const auto fault = static_cast<CableFaultKind>(kind);
    CHECK(cable_fault_kind(name_of(fault)) == fault);
  }
  CHECK_FALSE(cable_fault_kind("gremlins"));
}

TEST_CASE("A receiver at the sender's speed reads what was sent, one at another speed seldom does") {
  std::array<std::uint8_t, max_misread> read{};
  int alike = 0;
  for (int byte = 0; byte < 256; ++byte) {
    const auto sent = static_cast<std::uint8_t>(byte);
    REQUIRE(misread(sent, 1.0, read) == 1);
    CHECK(read[0] == sent);
    for (const double ratio : {0.5, 2.0, 1.0 / 6.0}) {
      const std::size_t count = misread(sent, ratio, read);
      alike += count == 1 && read[0] == sent ? 1 : 0;
    }
  }
  CHECK(alike < 20);
  // At half the speed each bit is read twice, from the start bit on: 0x80 lasts until after the stop bit.
  REQUIRE(misread(0x00, 0.5, read) == 0);
}
