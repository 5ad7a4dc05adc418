#include "daemon/telemetry/admission.hpp"

#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright::daemon::telemetry;

namespace {

std::vector<Place> guests(std::size_t count, std::string_view source) {
  return {count, Place{source, false, false}};
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
  auto places = guests(3, "b");
  const auto own = guests(max_guests_per_address, "a");
  places.insert(places.end(), own.begin(), own.end());
  CHECK(guest_to_close(places, "a") == 3U);
  places[3].is_answered = true;
  CHECK(guest_to_close(places, "a") == 4U);
  places[4].is_client = true;  // and no guest any more
  CHECK_FALSE(guest_to_close(places, "a"));
  for (Place& place : places) place.is_answered = !place.is_client;
  places.push_back({"a", false, true});
  CHECK(guest_to_close(places, "a") == 3U);
}

TEST_CASE("Where all places of guests are taken, the address that holds most of them makes room") {
  std::vector<Place> places{{"operator", false, false}, {"operator", true, false}};
  for (const std::string_view source : {"a", "b", "c", "d"}) {
    const auto more = guests(max_guests_per_address - 1, source);
    places.insert(places.end(), more.begin(), more.end());
  }
  while (places.size() < max_guests + 1) places.push_back({"e", false, false});
  CHECK(guest_to_close(places, "newcomer") == 2U);
}

TEST_CASE("Clients are no guests, however many there are") {
  const std::vector<Place> places(max_clients, Place{"a", true, false});
  CHECK_FALSE(guest_to_close(places, "a"));
  CHECK_FALSE(guest_to_close(places));
  CHECK(guest_to_close(guests(2, "a")) == 0U);
}

TEST_CASE(
    "Guests take no place of a client, and those who watch leave places to those who may stop the robot") {
  auto places = guests(max_guests, "a");
  CHECK(has_room_for_client(places, false));
  places.resize(max_guests + max_clients - places_kept_for_control, Place{"b", true, false});
  CHECK_FALSE(has_room_for_client(places, false));
  CHECK(has_room_for_client(places, true));
  places.resize(max_guests + max_clients, Place{"b", true, false});
  CHECK_FALSE(has_room_for_client(places, true));
}
