// Who may watch, and who may stop the robot.
//
// With a token, whoever shows it may do both, and nobody else may do anything. Without one the daemon listens
// on this machine alone, and then a web page from elsewhere must not reach the robot through the browser of
// the one who sits here: neither by opening a WebSocket to 127.0.0.1 (the browser says the page's Origin) nor
// by having its own name resolve to 127.0.0.1 (the Host is then that name).
#pragma once

#include <string>
#include <string_view>

namespace wheelwright::daemon::telemetry {

// What a request says about where it comes from, as in its headers; empty where it says nothing.
struct Caller {
  std::string_view host;           // Host
  std::string_view origin;         // Origin
  std::string_view authorization;  // Authorization
  std::string_view target;         // path and query of the request
};

enum class Access {
  control,   // watch, and stop the robot
  watch,     // the web apps of Foxglove and Lichtblick, where there is no token
  no_token,  // refused: the token is missing or wrong
  foreign,   // refused: from a web page elsewhere
};

// `token` is the configured one, or empty. The caller shows it as `?token=...` or as `Authorization: Bearer
// ...`.
Access access_of(const Caller& caller, std::string_view token);

}  // namespace wheelwright::daemon::telemetry
