#include "drivers/open_interface/packets.hpp"

#include <map>
#include <set>

#include "tests/support/catch.hpp"
#include "tests/unit/drivers/roomba/wire.hpp"

using namespace wheelwright::open_interface;

namespace {

int bytes_of_group(std::uint8_t group) {
  int bytes = 0;
  for (const PacketInfo& packet : packets_of_group(group)) bytes += packet.bytes;
  return bytes;
}

}  // namespace

TEST_CASE("Groups have the lengths and the ends of the specification") {
  struct Group {
    std::uint8_t number;
    int bytes;
    int first;
    int last;
  };
  for (const Group& group :
       {Group{0, 26, 7, 26}, Group{1, 10, 7, 16}, Group{2, 6, 17, 20}, Group{3, 10, 21, 26},
        Group{4, 14, 27, 34}, Group{5, 12, 35, 42}, Group{6, 52, 7, 42}, Group{100, 80, 7, 58},
        Group{101, 28, 43, 58}, Group{106, 12, 46, 51}, Group{107, 9, 54, 58}}) {
    INFO("group " << static_cast<int>(group.number));
    CHECK(bytes_of_group(group.number) == group.bytes);
    CHECK(static_cast<int>(packets_of_group(group.number).front().id) == group.first);
    CHECK(static_cast<int>(packets_of_group(group.number).back().id) == group.last);
  }
  for (int number = 7; number < 256; ++number) {
    if (number == 100 || number == 101 || number == 106 || number == 107) continue;
    CHECK(packets_of_group(static_cast<std::uint8_t>(number)).empty());
  }
}

TEST_CASE("Exactly the packets that the specification calls signed are signed") {
  const std::set<int> signed_ids{19, 20, 23, 24, 39, 40, 41, 42, 43, 44, 54, 55, 56, 57};
  for (const PacketInfo& packet : packet_table()) {
    INFO(packet.name);
    CHECK(packet.is_signed == signed_ids.contains(static_cast<int>(packet.id)));
  }
}

TEST_CASE("The protocol has the packets 7 to 58 and no others") {
  CHECK(packet_table().size() == 52);
  for (int id = 0; id < 256; ++id) {
    const auto packet = find_packet(static_cast<std::uint8_t>(id));
    CHECK(packet.has_value() == (id >= 7 && id <= 58));
    if (packet) CHECK(static_cast<int>(packet->id) == id);
  }
}

TEST_CASE("Every value of every packet survives encoding and decoding") {
  for (const PacketInfo& packet : packet_table()) {
    INFO(packet.name);
    const int values = packet.bytes == 1 ? 256 : 65536;
    const int lowest = packet.is_signed ? -values / 2 : 0;
    int wrong = 0;
    for (int value = lowest; value < lowest + values; ++value) {
      std::array<std::uint8_t, 2> bytes{};
      encode_value(packet, value, std::span(bytes).first(packet.bytes));
      wrong += decode_value(packet, std::span(bytes).first(packet.bytes)) == value ? 0 : 1;
      Bytes expected;
      append_packet(expected, packet.id, value);
      wrong += expected == Bytes(bytes.begin(), bytes.begin() + packet.bytes) ? 0 : 1;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("Values travel with the high byte first") {
  const auto decoded = [](PacketId id, Bytes bytes) { return decode_value(packet_info(id), bytes); };
  CHECK(decoded(PacketId::cliff_front_left_signal, {2, 25}) == 537);  // R500 p18
  CHECK(decoded(PacketId::current, {0xFF, 0x38}) == -200);
  CHECK(decoded(PacketId::voltage, {0xFF, 0x38}) == 65336);
  CHECK(decoded(PacketId::temperature, {0xFB}) == -5);
  CHECK(decoded(PacketId::left_encoder_counts, {0x80, 0x00}) == -32768);
}

TEST_CASE("A range never shuts out what its packet's specification allows") {
  const std::map<int, std::pair<int, int>> allowed{
      {7, {0, 15}},          {8, {0, 1}},           {9, {0, 1}},           {14, {0, 29}},
      {21, {0, 5}},          {22, {0, 65535}},      {23, {-32768, 32767}}, {24, {-128, 127}},
      {25, {0, 65535}},      {28, {0, 4095}},       {34, {0, 3}},          {35, {0, 4}},
      {36, {0, 15}},         {38, {0, 108}},        {39, {-500, 500}},     {40, {-32768, 32767}},
      {42, {-500, 500}},     {43, {-32768, 32767}}, {45, {0, 127}},        {46, {0, 4095}},
      {55, {-32768, 32767}}, {58, {0, 3}}};
  for (const auto& [id, range] : allowed) {
    const auto packet = find_packet(static_cast<std::uint8_t>(id));
    INFO(packet->name);
    CHECK(packet->minimum <= range.first);
    CHECK(packet->maximum >= range.second);
  }
}
