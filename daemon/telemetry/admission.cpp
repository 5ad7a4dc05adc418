#include "daemon/telemetry/admission.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace wheelwright::daemon::telemetry {
namespace {

std::map<std::string_view, std::size_t> guests_by_source(std::span<const Slot> slots) {
  std::map<std::string_view, std::size_t> counts;
  for (const Slot& slot : slots) {
    if (!slot.is_client) ++counts[slot.source];
  }
  return counts;
}

std::string_view fullest(const std::map<std::string_view, std::size_t>& counts) {
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most->first;
}

// The one who came first; one who is being answered only where there is no other.
std::optional<std::size_t> oldest_guest_from(std::span<const Slot> slots, std::string_view source) {
  std::optional<std::size_t> answered;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Slot& slot = slots[i];
    if (slot.is_client || slot.source != source) continue;
    if (!slot.is_answered) return i;
    if (!answered) answered = i;
  }
  return answered;
}

std::size_t clients_among(std::span<const Slot> slots) {
  return static_cast<std::size_t>(
      std::count_if(slots.begin(), slots.end(), [](const Slot& slot) { return slot.is_client; }));
}

}  // namespace

std::string source_of(const std::string& address) {
  in6_addr bytes{};
  const std::string without_zone = address.substr(0, address.find('%'));
  if (::inet_pton(AF_INET6, without_zone.c_str(), &bytes) != 1) return address;
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (IN6_IS_ADDR_V4MAPPED(&bytes)) {
    ::inet_ntop(AF_INET, bytes.s6_addr + 12, text.data(), text.size());
    return text.data();
  }
  std::fill(bytes.s6_addr + 8, bytes.s6_addr + 16, std::uint8_t{0});
  ::inet_ntop(AF_INET6, &bytes, text.data(), text.size());
  return std::string(text.data()) + "/64";
}

std::optional<std::size_t> guest_to_close(std::span<const Slot> slots, std::string_view source) {
  const auto counts = guests_by_source(slots);
  const auto own = counts.find(source);
  if (own != counts.end() && own->second >= max_guests_per_address) return oldest_guest_from(slots, source);
  if (slots.size() - clients_among(slots) < max_guests) return std::nullopt;
  return oldest_guest_from(slots, fullest(counts));
}

std::optional<std::size_t> guest_to_close(std::span<const Slot> slots) {
  const auto counts = guests_by_source(slots);
  if (counts.empty()) return std::nullopt;
  return oldest_guest_from(slots, fullest(counts));
}

bool has_room_for_client(std::span<const Slot> slots, bool may_control) {
  const std::size_t room = may_control ? max_clients : max_clients - slots_kept_for_control;
  return clients_among(slots) < room;
}

}  // namespace wheelwright::daemon::telemetry
