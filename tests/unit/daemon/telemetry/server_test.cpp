#include "daemon/telemetry/server.hpp"

#include <sys/resource.h>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include <atomic>
#include <functional>
#include <future>
#include <thread>
#include <type_traits>

#include "tests/support/catch.hpp"
#include "tests/support/live_view_client.hpp"

using namespace wheelwright::daemon::telemetry;
using namespace wheelwright::test;
using namespace std::chrono_literals;

namespace {

constexpr std::string_view page = "<!doctype html>the page";

// A server on a free port of this machine, with its thread.
class Service {
 public:
  explicit Service(const std::string& token = "")
      : server_(context_, {"127.0.0.1", 0, token, "robot", "session", page}, hooks()),
        thread_([this] { context_.run(); }) {}
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;
  ~Service() {
    boost::asio::post(context_, [this] { server_.close(); });
    std::this_thread::sleep_for(20ms);
    context_.stop();
    thread_.join();
  }

  std::uint16_t port() const { return server_.port(); }
  int stops() const { return stops_; }
  void publish(ChannelId channel, const std::string& payload) {
    boost::asio::post(context_, [this, channel, text = std::make_shared<const std::string>(payload)] {
      server_.publish({channel, 42, text});
    });
  }
  void forget_backlogs() {
    boost::asio::post(context_, [this] { server_.forget_backlogs(); });
  }
  void close() {
    boost::asio::post(context_, [this] { server_.close(); });
  }
  std::size_t clients() {
    return on_thread([this] { return server_.clients(); });
  }
  std::size_t connections() {
    return on_thread([this] { return server_.connections(); });
  }
  std::vector<std::string> warnings() {
    return on_thread([this] { return warnings_; });
  }

 private:
  ServerHooks hooks() {
    return {[](ChannelId) { return std::vector<Message>{}; }, [this](const std::string&) { ++stops_; },
            [this](const std::string& what) { warnings_.push_back(what); }};
  }
  template <typename Ask>
  std::invoke_result_t<Ask> on_thread(Ask ask) {
    std::promise<std::invoke_result_t<Ask>> answer;
    boost::asio::post(context_, [&] { answer.set_value(ask()); });
    return answer.get_future().get();
  }

  std::vector<std::string> warnings_;
  std::atomic<int> stops_{0};
  boost::asio::io_context context_{1};
  Server server_;
  std::thread thread_;
};

// One by one: GCC 12 warns wrongly of what it makes of longer constants (GCC bug 105651).
std::string repeated(std::size_t count, char character) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text.push_back(character);
  return text;
}

// Clients by the hundred, each of several files, are more than the 1024 that many systems allow at first.
void allow_all_files_that_may_be_had() {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
}

// Whether a condition comes true within ten seconds.
bool eventually(const std::function<bool()>& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

}  // namespace

TEST_CASE("The live view's port gives its page, and one line for everything else") {
  const Service service;
  const auto reply = http_request(service.port(), "/");
  CHECK(reply.status == 200);
  CHECK(reply.body == page);
  CHECK_THAT(reply.headers.at("Content-Security-Policy"), ContainsSubstring("default-src 'none'"));
  CHECK(http_request(service.port(), "/?whatever").status == 200);
  CHECK(http_request(service.port(), "/other").status == 404);
  CHECK(http_request(service.port(), "/", {}, "POST").status == 405);
  const auto head = http_request(service.port(), "/", {}, "HEAD");
  CHECK(head.status == 200);
  CHECK(head.headers.at("Content-Length") == std::to_string(page.size()));
  CHECK(http_request(service.port(), "/", {{"Host", "evil.example"}}).status == 403);
}

TEST_CASE("A WebSocket from a web page elsewhere is refused before it is one") {
  const Service service;
  CHECK_THROWS(LiveViewClient(service.port(), "/", {{"Origin", "https://evil.example"}}));
  CHECK_THROWS(LiveViewClient(service.port(), "/", {{"Host", "evil.example"}}));
  CHECK_THROWS(LiveViewClient(service.port(), "/", {}, "chat"));
  CHECK_NOTHROW(LiveViewClient(service.port(), "/", {{"Origin", "http://127.0.0.1:1234"}}));
}

TEST_CASE("With a token neither page nor WebSocket is to be had without it") {
  const Service service("0123456789abcdef");
  CHECK(http_request(service.port(), "/").status == 401);
  CHECK(http_request(service.port(), "/?token=0123456789abcdef", {{"Host", "robot.example"}}).status == 200);
  CHECK_THROWS(LiveViewClient(service.port()));
  LiveViewClient client(service.port(), "/?token=0123456789abcdef");
  client.call_stop();
  while (const auto message = client.next()) {
    if (message->binary) break;
  }
  CHECK(service.stops() == 1);
}

TEST_CASE("A client of either protocol name is greeted, gets what it subscribes to, and stops the robot") {
  Service service;
  for (const std::string name : {"foxglove.sdk.v1", "foxglove.websocket.v1"}) {
    LiveViewClient client(service.port(), "/", {}, name);
    CHECK(client.subprotocol() == name);
    CHECK(client.next_text("serverInfo").at("name") == "robot");
    client.next_text("advertiseServices");
    client.subscribe(9, static_cast<std::uint32_t>(ChannelId::state));
    client.send_text("{}");
    client.next_text("status");  // so the subscription has been taken, too
    service.publish(ChannelId::pose, R"({"not":"for him"})");
    service.publish(ChannelId::state, R"({"for":"him"})");
    const auto data = client.next_data(9);
    CHECK(data.payload().at("for") == "him");
    CHECK(data.time_ns() == 42);
    const int before = service.stops();
    client.call_stop();
    const auto answer = client.next();
    REQUIRE(answer);
    CHECK(answer->bytes.substr(0, 1) == "\x03");
    CHECK(service.stops() == before + 1);
  }
}

TEST_CASE("A client that sends more than a message may hold is dropped, and the next one is served") {
  const Service service;
  LiveViewClient client(service.port());
  client.send_text(repeated(65 * 1024, ' '));
  CHECK(client.is_closed_within(2s));
  CHECK_NOTHROW(LiveViewClient(service.port()).next_text("serverInfo"));
}

TEST_CASE("Bytes that are no HTTP, and headers without end, are not kept waiting for") {
  const Service service;
  for (const std::string& bytes : {std::string("\x16\x03\x01\x02"), std::string("GET\r\n\r\n"),
                                   std::string(300, '\0'), "GET / HTTP/1.1\r\n" + repeated(20000, 'a'),
                                   std::string("GET / HTTP/1.1\r\nContent-Length: 99999999\r\n\r\n")}) {
    CHECK(raw_exchange(service.port(), {bytes}).empty());
  }
  CHECK(http_request(service.port(), "/").status == 200);
}

TEST_CASE("A WebSocket frame that breaks the rules ends that connection only") {
  const Service service;
  const std::string upgrade =
      "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n";
  using namespace std::string_literals;
  // Unmasked; reserved bits; reserved opcode; a length of 2^63; a fragmented ping; a continuation of nothing.
  for (const std::string& frame :
       {"\x81\x02hi"s, "\xf1\x80\0\0\0\0"s, "\x83\x80\0\0\0\0"s, "\x82\xff\x80\0\0\0\0\0\0\0\0\0\0\0"s,
        "\x09\x80\0\0\0\0"s, "\x80\x80\0\0\0\0"s}) {
    const std::string close = "\x88\x02";
    const std::string answer = raw_exchange(service.port(), {upgrade, frame}, close);
    CHECK_THAT(answer, ContainsSubstring("101 Switching Protocols"));
    CHECK_THAT(answer, ContainsSubstring(close));
  }
  // Nobody may send a frame before the upgrade is answered.
  CHECK(raw_exchange(service.port(), {upgrade + "\x81\x80\x01\x02\x03\x04"}).empty());
  CHECK(http_request(service.port(), "/").status == 200);
}

TEST_CASE("A client that reads nothing is dropped once its queue is full, and the others miss nothing") {
  Service service;
  LiveViewClient sleeper(service.port());
  LiveViewClient reader(service.port());
  for (LiveViewClient* client : {&sleeper, &reader}) {
    client->subscribe(1, static_cast<std::uint32_t>(ChannelId::scene));
    client->send_text("{}");
    client->next_text("status");
  }
  const std::string payload(64 * 1024, 'x');
  int received = 0;
  for (int i = 0; i < 400; ++i) {
    service.publish(ChannelId::scene, payload);
    received += reader.next() ? 1 : 0;
  }
  CHECK(received == 400);
  CHECK(service.clients() == 1);
}

TEST_CASE(
    "A client that is behind is told the end first, and what was said and what others get is not forgotten") {
  constexpr int count = 240;
  const std::string pose(4 * 1024, ' ');  // all of them: less than makes the server drop a client
  Service service;
  LiveViewClient behind(service.port());
  LiveViewClient reader(service.port());
  for (LiveViewClient* client : {&behind, &reader}) {
    client->subscribe(1, static_cast<std::uint32_t>(ChannelId::pose));
    client->subscribe(2, static_cast<std::uint32_t>(ChannelId::state));
    client->subscribe(3, static_cast<std::uint32_t>(ChannelId::log));
    client->send_text("{}");
    client->next_text("status");
  }
  for (int i = 0; i < count; ++i) {
    service.publish(ChannelId::pose, pose + std::to_string(i));
    CHECK_NOTHROW(reader.next_data(1));
  }
  service.publish(ChannelId::log, R"({"said":"once"})");
  service.forget_backlogs();
  service.publish(ChannelId::state, R"({"result":"finished"})");
  service.close();

  const auto poses_until_end = [](LiveViewClient& client) {
    int poses = 0;
    bool has_log = false;
    while (const auto message = client.next()) {
      if (!message->binary) continue;
      has_log = has_log || message->subscription() == 3;
      poses += message->subscription() == 1 ? 1 : 0;
      if (message->subscription() != 2) continue;
      CHECK(message->payload().at("result") == "finished");
      CHECK(has_log);
      return poses;
    }
    FAIL("the end was not told");
    return poses;
  };
  CHECK(poses_until_end(reader) == 0);  // it has had them all
  // What the system held already, on both sides, came before.
  CHECK(poses_until_end(behind) < count / 2 + count / 4);
  CHECK(behind.is_closed_within(2s));
}

TEST_CASE(
    "No more clients are let in than there is room for, which is said, and there is room again when they "
    "go") {
  allow_all_files_that_may_be_had();
  Service service;
  {
    std::vector<std::unique_ptr<LiveViewClient>> clients;
    for (std::size_t i = 0; i < max_clients; ++i) {
      clients.push_back(std::make_unique<LiveViewClient>(service.port()));
    }
    for (int i = 0; i < 3; ++i) CHECK_THROWS(LiveViewClient(service.port()));
    CHECK(service.warnings() ==
          std::vector<std::string>{"256 clients are all there is room for, 127.0.0.1 was refused"});
    CHECK(http_request(service.port(), "/").status == 200);
  }
  CHECK(eventually([&] { return service.clients() == 0; }));
  CHECK_NOTHROW(LiveViewClient(service.port()));
}

TEST_CASE("Connections that show no token keep nobody out who shows it, and are said in one line") {
  allow_all_files_that_may_be_had();
  Service service("0123456789abcdef");
  LiveViewClient early(service.port(), "/?token=0123456789abcdef");
  boost::asio::io_context context;
  std::vector<boost::asio::ip::tcp::socket> idle;
  const boost::asio::ip::tcp::endpoint endpoint(boost::asio::ip::make_address("127.0.0.1"), service.port());
  for (std::size_t i = 0; i < 2 * max_clients; ++i) idle.emplace_back(context).connect(endpoint);
  CHECK(http_request(service.port(), "/?token=0123456789abcdef").status == 200);
  LiveViewClient late(service.port(), "/?token=0123456789abcdef");
  for (LiveViewClient* client : {&early, &late}) {
    client->call_stop();
    client->send_text("{}");
    client->next_text("status");
  }
  CHECK(service.stops() == 2);
  CHECK(service.connections() <= max_guests_per_address + 2);
  CHECK(service.warnings() ==
        std::vector<std::string>{"too many connections without a request or a token, room "
                                 "is made among them (127.0.0.1)"});
}

TEST_CASE("Who asks for nothing is let go after some seconds, and what he took is given back") {
  Service service;
  boost::asio::io_context context;
  boost::asio::ip::tcp::socket idle(context);
  idle.connect({boost::asio::ip::make_address("127.0.0.1"), service.port()});
  boost::asio::write(idle, boost::asio::buffer(std::string("GET / HTTP/1.1\r\n")));
  char byte = 0;
  boost::system::error_code error;
  boost::asio::read(idle, boost::asio::buffer(&byte, 1), error);  // until the server closes
  CHECK(error);
  CHECK(eventually([&] { return service.connections() == 0; }));
}

TEST_CASE("Who is refused does not keep the connection") {
  const Service service("0123456789abcdef");
  CHECK(http_request(service.port(), "/", {{"Connection", "keep-alive"}}).headers.at("Connection") ==
        "close");
}
