// live_view_crowd: many clients of a daemon's live view at once, for tools/bench.
//   live_view_crowd --port N [--readers 100] [--sleepers 100] [--seconds 10]
// Ends with the number of messages that the readers got per second.
#include <CLI/CLI.hpp>

#include <chrono>
#include <exception>
#include <iostream>
#include <thread>

#include "tests/support/live_view_client.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Many clients of a live view at once.", "live_view_crowd"};
  std::uint16_t port = 8765;
  std::size_t readers = 100;
  std::size_t sleepers = 100;
  double seconds = 10.0;
  app.add_option("--port", port, "of the live view, on this machine");
  app.add_option("--readers", readers, "clients that read all that comes");
  app.add_option("--sleepers", sleepers, "clients that never read");
  app.add_option("--seconds", seconds, "how long");
  CLI11_PARSE(app, argc, argv);
  try {
    const wheelwright::test::Crowd crowd(port, readers, sleepers);
    const auto before = crowd.received();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    std::cout << static_cast<double>(crowd.received() - before) / seconds << '\n';
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "live_view_crowd: " << error.what() << '\n';
    return 2;
  }
}
