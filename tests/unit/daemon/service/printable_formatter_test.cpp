#include "daemon/service/printable_formatter.hpp"

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sstream>

#include "tests/support/catch.hpp"

TEST_CASE("A message of the daemon that quotes foreign text is one line of printable characters") {
  std::ostringstream out;
  spdlog::logger logger("test", std::make_shared<spdlog::sinks::ostream_sink_st>(out));
  logger.set_formatter(wheelwright::daemon::make_printable_formatter("%l %v"));
  logger.error("robot.yaml: '{}' is unknown", "\x1b[2J\nüber\xff");
  CHECK(out.str() == "error robot.yaml: '\\x1b[2J\\x0aüber\\xff' is unknown\n");
}
