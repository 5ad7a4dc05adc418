#include "daemon/telemetry/access.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "config/load/ascii_text.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

// Takes as long for a token that is nearly right as for any other.
bool is_same_secret(std::string_view shown, std::string_view secret) {
  unsigned difference = shown.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < secret.size(); ++i) {
    const char other = i < shown.size() ? shown[i] : '\0';
    difference |= static_cast<unsigned char>(secret[i] ^ other);
  }
  return difference == 0;
}

std::string_view token_in_target(std::string_view target) {
  const auto mark = target.find('?');
  if (mark == std::string_view::npos) return {};
  std::string_view query = target.substr(mark + 1);
  query = query.substr(0, query.find('#'));
  constexpr std::string_view key = "token=";
  while (!query.empty()) {
    const auto end = std::min(query.find('&'), query.size());
    const auto part = query.substr(0, end);
    if (part.starts_with(key)) return part.substr(key.size());
    query.remove_prefix(std::min(end + 1, query.size()));
  }
  return {};
}

std::string_view token_in_header(std::string_view authorization) {
  constexpr std::string_view scheme = "Bearer ";
  return authorization.starts_with(scheme) ? authorization.substr(scheme.size()) : std::string_view{};
}

std::string_view without_port(std::string_view host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

// Names that no foreign name server can make its own.
bool is_this_machine(std::string_view host) {
  const std::string_view name = without_port(host);
  const bool is_ipv4_loopback =
      name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string_view::npos;
  return name == "localhost" || name == "[::1]" || is_ipv4_loopback;
}

Access access_by_origin(std::string_view host, std::string_view origin) {
  if (origin.empty()) return Access::control;  // no browser
  const auto mark = origin.find("://");
  if (mark == std::string_view::npos) return Access::foreign;  // "null": a page that hides where it is from
  const auto scheme = origin.substr(0, mark);
  const auto site = origin.substr(mark + 3);
  // Desktop programs; a page on the web has one of the two others.
  if (scheme != "http" && scheme != "https") return Access::control;
  if (site == host || is_this_machine(site)) return Access::control;
  constexpr std::array<std::string_view, 3> viewers{"https://app.foxglove.dev", "https://studio.foxglove.dev",
                                                    "https://lichtblick-suite.github.io"};
  const bool is_viewer = std::find(viewers.begin(), viewers.end(), origin) != viewers.end();
  return is_viewer ? Access::watch : Access::foreign;
}

}  // namespace

Access access_of(const Caller& caller, std::string_view token) {
  if (!token.empty()) {
    const bool shown = is_same_secret(token_in_target(caller.target), token) ||
                       is_same_secret(token_in_header(caller.authorization), token);
    return shown ? Access::control : Access::no_token;
  }
  const std::string host = config::lower_case(caller.host);
  if (!is_this_machine(host)) return Access::foreign;
  return access_by_origin(host, config::lower_case(caller.origin));
}

}  // namespace wheelwright::daemon::telemetry
