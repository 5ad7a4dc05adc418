#include "daemon/telemetry/access.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright::daemon::telemetry;

namespace {

constexpr std::string_view token = "a-long-and_secret-Token1";

Access without_token(std::string_view host, std::string_view origin = "") {
  return access_of({host, origin, "", "/"}, "");
}

Access with_token(std::string_view target, std::string_view authorization = "") {
  return access_of({"robot.local:8765", "http://somewhere.example", authorization, target}, token);
}

}  // namespace

TEST_CASE("Without a token this machine's own names are answered, whatever the port") {
  for (const auto* host :
       {"127.0.0.1:8765", "localhost:8765", "LOCALHOST", "[::1]:8765", "127.1.2.3", "localhost:9"}) {
    CAPTURE(host);
    CHECK(without_token(host) == Access::control);
  }
}

TEST_CASE("A name that somebody else lets resolve to this machine is refused") {
  for (const auto* host : {"evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example",
                           "evil.example", "192.168.1.5:8765", "127.evil", "", ":8765", "[::2]:8765"}) {
    CAPTURE(host);
    CHECK(without_token(host) == Access::foreign);
  }
}

TEST_CASE(
    "The robot's own page and pages of this machine may stop the robot, pages from elsewhere get nothing") {
  const auto* host = "localhost:8765";
  for (const auto* origin :
       {"", "http://localhost:8765", "http://127.0.0.1:8080", "https://localhost", "http://[::1]:3000"}) {
    CAPTURE(origin);
    CHECK(without_token(host, origin) == Access::control);
  }
  for (const auto* origin :
       {"https://evil.example", "http://localhost.evil.example", "null", "http://evil.example:8765",
        "https://app.foxglove.dev.evil.example", "localhost", "http://192.168.1.5:8765"}) {
    CAPTURE(origin);
    CHECK(without_token(host, origin) == Access::foreign);
  }
}

TEST_CASE("Desktop viewers may stop the robot, the known viewers on the web may watch it") {
  CHECK(without_token("localhost:8765", "file://") == Access::control);
  CHECK(without_token("localhost:8765", "https://app.foxglove.dev") == Access::watch);
  CHECK(without_token("localhost:8765", "http://app.foxglove.dev") == Access::foreign);
}

TEST_CASE(
    "With a token, whoever shows it may do everything, from wherever, and nobody else may do anything") {
  CHECK(with_token("/?token=a-long-and_secret-Token1") == Access::control);
  CHECK(with_token("/?a=b&token=a-long-and_secret-Token1&c=d") == Access::control);
  CHECK(with_token("/", "Bearer a-long-and_secret-Token1") == Access::control);
  for (const auto* target : {"/", "/?token=", "/?token=a-long-and_secret-Token",
                             "/?token=a-long-and_secret-Token12", "/?token=A-long-and_secret-Token1",
                             "/?xtoken=a-long-and_secret-Token1", "/a-long-and_secret-Token1"}) {
    CAPTURE(target);
    CHECK(with_token(target) == Access::no_token);
  }
  CHECK(with_token("/", "Basic a-long-and_secret-Token1") == Access::no_token);
  CHECK(access_of({"localhost", "", "", "/"}, token) == Access::no_token);
}
