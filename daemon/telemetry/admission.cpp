#include "daemon/telemetry/admission.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

namespace wheelwright::daemon::telemetry {
namespace {

std::map<std::string_view, std::size_t> guests_by_source(std::span<const Place> places) {
  std::map<std::string_view, std::size_t> counts;
  for (const Place& place : places) {
    if (!place.is_client) ++counts[place.source];
  }
  return counts;
}

std::string_view fullest(const std::map<std::string_view, std::size_t>& counts) {
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most->first;
}

// The one who came first; one who is being answered only where there is no other.
std::optional<std::size_t> oldest_guest_from(std::span<const Place> places, std::string_view source) {
  std::optional<std::size_t> answered;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    if (place.is_client || place.source != source) continue;
    if (!place.is_answered) return i;
    if (!answered) answered = i;
  }
  return answered;
}

std::size_t clients_among(std::span<const Place> places) {
  return static_cast<std::size_t>(
      std::count_if(places.begin(), places.end(), [](const Place& place) { return place.is_client; }));
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

std::optional<std::size_t> guest_to_close(std::span<const Place> places, std::string_view source) {
  const auto counts = guests_by_source(places);
  const auto own = counts.find(source);
  if (own != counts.end() && own->second >= max_guests_per_address) return oldest_guest_from(places, source);
  if (places.size() - clients_among(places) < max_guests) return std::nullopt;
  return oldest_guest_from(places, fullest(counts));
}

std::optional<std::size_t> guest_to_close(std::span<const Place> places) {
  const auto counts = guests_by_source(places);
  if (counts.empty()) return std::nullopt;
  return oldest_guest_from(places, fullest(counts));
}

bool has_room_for_client(std::span<const Place> places, bool may_control) {
  const std::size_t room = may_control ? max_clients : max_clients - places_kept_for_control;
  return clients_among(places) < room;
}

}  // namespace wheelwright::daemon::telemetry
