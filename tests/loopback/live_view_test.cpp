// The live view of the real daemon: it shows the run, and its button stops the robot.
#include <algorithm>
#include <csignal>
#include <thread>

#include "tests/loopback/bench/bench.hpp"
#include "tests/loopback/bench/line_tap.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/live_view_client.hpp"

using namespace wheelwright::bench;
using namespace wheelwright::test;

namespace {

// A port that is free now.
std::uint16_t free_port() {
  boost::asio::io_context context;
  return boost::asio::ip::tcp::acceptor(context, {boost::asio::ip::make_address("127.0.0.1"), 0})
      .local_endpoint()
      .port();
}

std::string live_view_at(std::uint16_t port) {
  return "port: " + std::to_string(port);
}

std::uint32_t channel_of(LiveViewClient& client, const std::string& topic) {
  const auto advertised = client.next_text("advertise");
  for (const auto& channel : advertised.at("channels")) {
    if (channel.at("topic") == topic) return channel.at("id");
  }
  throw std::runtime_error("there is no " + topic);
}

}  // namespace

TEST_CASE("A client of the live view sees the robot drive its route, and how the run came out") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const std::uint16_t port = free_port();
  const auto daemon = bench.start_daemon(bench.configure({.live_view = live_view_at(port)}));
  REQUIRE(daemon->says("live view: http://127.0.0.1:", 5s));
  LiveViewClient poses(port);
  poses.subscribe(1, channel_of(poses, "/pose"));
  LiveViewClient states(port);
  states.subscribe(1, channel_of(states, "/state"));
  double farthest_m = 0.0;
  int count = 0;
  while (const auto message = poses.next()) {
    if (!message->binary) continue;
    ++count;
    farthest_m = std::max(farthest_m, message->payload().at("pose").at("position").at("x").get<double>());
  }
  CHECK(daemon->wait(10s) == 0);
  CHECK_THAT(farthest_m, WithinAbs(0.25, 0.02));
  CHECK(count > 60);
  nlohmann::json last;
  while (const auto message = states.next()) {
    if (message->binary) last = message->payload();
  }
  CHECK(last.at("result") == "finished");
  CHECK(last.at("checkpoints_visited") == 1);
}

TEST_CASE("The live view's stop has the wheels told to stand within 40 ms, and the run ends by that name") {
  Bench bench;
  const auto robot = bench.start_robot("default");
  LineTap tap(bench.device(), bench.folder() / "tapped");
  const std::uint16_t port = free_port();
  const auto daemon = bench.start_daemon(bench.configure(
      {.device = "tapped", .live_view = live_view_at(port), .route = "[[3, 0]]", .speed_m_s = 0.15}));
  REQUIRE(daemon->says("route: driving", 10s));
  LiveViewClient client(port);
  std::this_thread::sleep_for(1s);
  const auto at = LineTap::Clock::now();
  client.call_stop();
  CHECK(daemon->wait(5s) == 1);
  CHECK_THAT(daemon->err(), ContainsSubstring("live view: 127.0.0.1:"));
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: stopped, requested"));
  const auto orders = tap.drive_orders();
  REQUIRE(orders.first_standing);
  const double order_ms = std::chrono::duration<double, std::milli>(*orders.first_standing - at).count();
  CAPTURE(order_ms);
  CHECK(order_ms < 40.0);
  CHECK((!orders.last_moving || *orders.last_moving < *orders.first_standing));
}

TEST_CASE("A port that is taken is said, and the robot drives without a live view") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  boost::asio::io_context context;
  const boost::asio::ip::tcp::acceptor other(context, {boost::asio::ip::make_address("127.0.0.1"), 0});
  const auto daemon = bench.start_daemon(
      bench.configure({.live_view = live_view_at(other.local_endpoint().port()), .route = "[[0.15, 0]]"}));
  CHECK(daemon->says("no live view: http://127.0.0.1:", 5s));
  CHECK(daemon->wait(10s) == 0);
}

TEST_CASE("Two hundred clients, half of which never read, do not make a run fail or lose a tick of its log") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const std::uint16_t port = free_port();
  const auto daemon = bench.start_daemon(
      bench.configure({.run = "arm: by_signal", .live_view = live_view_at(port), .route = "[[0.6, 0]]"}));
  REQUIRE(daemon->says("the robot answers", 5s));
  const Crowd crowd(port, 100, 100);
  daemon->signal(SIGUSR1);
  CHECK(daemon->wait(15s) == 0);
  CHECK(crowd.received() > 10000);
  const Table log = bench.drive_log();
  for (std::size_t row = 1; row < log.rows(); ++row) {
    if (log.number(row, "tick") - log.number(row - 1, "tick") != 1.0) FAIL("a gap at row " << row);
  }
}

TEST_CASE(
    "Idle connections without the token keep nobody from stopping the robot, and the log says that they are "
    "there") {
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const std::uint16_t port = free_port();
  const auto daemon =
      bench.start_daemon(bench.configure({.live_view = live_view_at(port) + ", token: 0123456789abcdef",
                                          .route = "[[3, 0]]",
                                          .speed_m_s = 0.15}));
  REQUIRE(daemon->says("route: driving", 10s));
  boost::asio::io_context context;
  std::vector<boost::asio::ip::tcp::socket> idle;
  for (int i = 0; i < 400; ++i) {
    idle.emplace_back(context).connect({boost::asio::ip::make_address("127.0.0.1"), port});
  }
  CHECK(daemon->says("too many connections without a request or a token", 5s));
  LiveViewClient client(port, "/?token=0123456789abcdef");
  client.call_stop();
  CHECK(daemon->wait(5s) == 1);
  CHECK_THAT(daemon->out(), ContainsSubstring("Result: stopped, requested"));
}

TEST_CASE("Thousands of orders to stop are obeyed, counted, and said in a few lines") {
  constexpr int orders = 5000;
  Bench bench;
  const auto robot = bench.start_robot("perfect");
  const std::uint16_t port = free_port();
  const auto daemon = bench.start_daemon(bench.configure(
      {.run = "at_end: stay", .live_view = live_view_at(port), .route = "[[3, 0]]", .speed_m_s = 0.15}));
  REQUIRE(daemon->says("route: driving", 10s));
  LiveViewClient client(port);
  for (int i = 0; i < orders; ++i) {
    client.call_stop();
    if (i % 50 == 49) {  // a client that does not take its answers is dropped
      client.send_text("{}");
      client.next_text("status");
    }
  }
  REQUIRE(daemon->says(" more orders to stop, the last by 127.0.0.1:", 10s));
  daemon->signal(SIGTERM);
  daemon->wait(5s);
  const std::string said = daemon->err();
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = said.find("to stop", at)) != std::string::npos; ++at) ++lines;
  CHECK(lines < 20);
  CHECK_THAT(said, ContainsSubstring("live view: 127.0.0.1:"));
}
