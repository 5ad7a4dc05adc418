#include "daemon/telemetry/admission.hpp"

#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright::daemon::telemetry;

namespace {

std::vector<Slot> guests(std::size_t count, std::string_view source) {
  return {count, Slot{source, false, false}};
}

}  // namespace

TEST_CASE("An address is one source, and so is a network of IPv6 that one household has to itself") {
  CHECK(source_of("192.168.1.7") == "192.168.1.7");
  CHECK(source_of("::ffff:192.168.1.7") == "192.168.1.7");
  CHECK(source_of("2001:db8:1:2:3:4:5:6") == "2001:db8:1:2::/64");
  CHECK(source_of("2001:db8:1:2::1") == source_of("2001:db8:1:2:ffff::9"));
  CHECK(source_of("2001:db8:1:3::1") != source_of("2001:db8:1:2::1"));
  CHECK(source_of("fe80::1%eth0") == "fe80::/64");
}

TEST_CASE("While there is room, no guest is closed") {
  CHECK_FALSE(guest_to_close({}, "a"));
  CHECK_FALSE(guest_to_close(guests(max_guests_per_address - 1, "a"), "a"));
  CHECK_FALSE(guest_to_close(guests(max_guests_per_address, "a"), "b"));
}

TEST_CASE("An address that has its share makes room itself, by its oldest guest that is not being answered") {
  auto slots = guests(3, "b");
  const auto own = guests(max_guests_per_address, "a");
  slots.insert(slots.end(), own.begin(), own.end());
  CHECK(guest_to_close(slots, "a") == 3U);
  slots[3].is_answered = true;
  CHECK(guest_to_close(slots, "a") == 4U);
  slots[4].is_client = true;  // and no guest any more
  CHECK_FALSE(guest_to_close(slots, "a"));
  for (Slot& slot : slots) slot.is_answered = !slot.is_client;
  slots.push_back({"a", false, true});
  CHECK(guest_to_close(slots, "a") == 3U);
}

TEST_CASE("Where all slots of guests are taken, the address that holds most of them makes room") {
  std::vector<Slot> slots{{"operator", false, false}, {"operator", true, false}};
  for (const std::string_view source : {"a", "b", "c", "d"}) {
    const auto more = guests(max_guests_per_address - 1, source);
    slots.insert(slots.end(), more.begin(), more.end());
  }
  while (slots.size() < max_guests + 1) slots.push_back({"e", false, false});
  CHECK(guest_to_close(slots, "newcomer") == 2U);
}

TEST_CASE("Clients are no guests, however many there are") {
  const std::vector<Slot> slots(max_clients, Slot{"a", true, false});
  CHECK_FALSE(guest_to_close(slots, "a"));
  CHECK_FALSE(guest_to_close(slots));
  CHECK(guest_to_close(guests(2, "a")) == 0U);
}

TEST_CASE(
    "Guests take no slot of a client, and those who watch leave slots to those who may stop the robot") {
  auto slots = guests(max_guests, "a");
  CHECK(has_room_for_client(slots, false));
  slots.resize(max_guests + max_clients - slots_kept_for_control, Slot{"b", true, false});
  CHECK_FALSE(has_room_for_client(slots, false));
  CHECK(has_room_for_client(slots, true));
  slots.resize(max_guests + max_clients, Slot{"b", true, false});
  CHECK_FALSE(has_room_for_client(slots, true));
}
