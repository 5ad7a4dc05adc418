// Who is let go when more connections come to the live view than there is room for.
//
// A connection is a guest until it has become a WebSocket, for which it has to show the token where there is
// one; then it is a client. Guests and clients have slots of their own: connections that ask for nothing
// keep no client out. Among guests the newest stays, and room is made at the address that holds most of it:
// whoever sends his request at once is answered, whatever else comes from his address or from another.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wheelwright::daemon::telemetry {

constexpr std::size_t max_clients = 256;
// The last of these slots are for those who may stop the robot, and not for those who may only watch.
constexpr std::size_t slots_kept_for_control = 16;
constexpr std::size_t max_guests = 64;
constexpr std::size_t max_guests_per_address = 16;  // a browser opens six at a time

// One connection of those that there are, in the order in which they came.
struct Slot {
  std::string_view source;  // see source_of
  bool is_client = false;
  bool is_answered = false;  // a guest whose answer is on its way
};

// What counts as one address: of IPv6 the first 64 bits, which is what one household or machine has to
// itself. `address` as inet_ntop writes it.
std::string source_of(const std::string& address);

// The guest who makes room for another one from `source`, as an index; nothing where there is room.
std::optional<std::size_t> guest_to_close(std::span<const Slot> slots, std::string_view source);

// The guest who is closed where the system has no more file descriptors; nothing where there is no guest.
std::optional<std::size_t> guest_to_close(std::span<const Slot> slots);

// Whether a guest may become a client.
bool has_room_for_client(std::span<const Slot> slots, bool may_control);

}  // namespace wheelwright::daemon::telemetry
