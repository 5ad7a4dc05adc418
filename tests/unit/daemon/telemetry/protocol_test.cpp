#include "daemon/telemetry/protocol.hpp"

#include <nlohmann/json.hpp>
#include <random>

#include "daemon/telemetry/conversation.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright::daemon::telemetry;
using namespace std::string_literals;
using Json = nlohmann::json;

namespace {

std::string bytes_of(const Outgoing& message) {
  return std::string(message.head.data(), message.head_size) + *message.body;
}

Json json_of(const Outgoing& message) {
  CHECK_FALSE(message.binary);
  return Json::parse(bytes_of(message));
}

Conversation conversation(bool may_control = true) {
  return {{"robot", "session", may_control}, [](ChannelId) { return std::vector<Message>{}; }};
}

std::string subscribe(int id, int channel) {
  return Json{{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel}}}}}.dump();
}

Message message_on(ChannelId channel) {
  return {channel, 0x0102030405060708U, std::make_shared<const std::string>("{}")};
}

// The error that a message is answered with.
std::string error_of(const Reply& reply) {
  REQUIRE(reply.messages.size() == 1);
  const Json json = json_of(reply.messages.front());
  CHECK(json.at("op") == "status");
  CHECK(json.at("level") == 2);
  CHECK_FALSE(reply.stop);
  return json.at("message");
}

const std::string stop_call = "\x02\x01\0\0\0\x09\0\0\0\x04\0\0\0json{}"s;

// One by one: GCC 12 warns wrongly of what it makes of longer constants (GCC bug 105651).
std::string repeated(std::size_t count, char character) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text.push_back(character);
  return text;
}

}  // namespace

TEST_CASE("The server answers to both names of the protocol, by the first that it knows") {
  CHECK(choose_subprotocol("foxglove.sdk.v1") == "foxglove.sdk.v1");
  CHECK(choose_subprotocol("foxglove.websocket.v1") == "foxglove.websocket.v1");
  CHECK(choose_subprotocol("chat, foxglove.websocket.v1 ,foxglove.sdk.v1") == "foxglove.websocket.v1");
  CHECK(choose_subprotocol("").empty());
  CHECK(choose_subprotocol("foxglove.sdk.v11,,").empty());
}

TEST_CASE("A client is greeted with who the server is, its channels, and the service that stops") {
  const auto greeting = conversation().greeting();
  REQUIRE(greeting.size() == 3);
  const Json info = json_of(greeting[0]);
  CHECK(info.at("op") == "serverInfo");
  CHECK(info.at("name") == "robot");
  CHECK(info.at("sessionId") == "session");
  CHECK(info.at("capabilities") == Json{"clientPublish", "services"});
  const Json advertised = json_of(greeting[1]);
  CHECK(advertised.at("op") == "advertise");
  CHECK(advertised.at("channels").size() == channel_count);
  for (const Json& channel : advertised.at("channels")) {
    CHECK(channel.at("encoding") == "json");
    CHECK(channel.at("schemaEncoding") == "jsonschema");
    CHECK(Json::parse(channel.at("schema").get<std::string>()).at("type") == "object");
  }
  CHECK(json_of(greeting[2]).at("services")[0].at("name") == "/stop");
}

TEST_CASE("A message data frame is opcode, subscription, time and payload, numbers little-endian") {
  const auto frame = message_data(0x0a0b0c0d, message_on(ChannelId::pose));
  CHECK(frame.binary);
  CHECK(bytes_of(frame) == "\x01\x0d\x0c\x0b\x0a\x08\x07\x06\x05\x04\x03\x02\x01{}"s);
}

TEST_CASE("A subscriber gets what is on his channel under his own number, and nothing after he has left") {
  auto client = conversation();
  CHECK(client.take_text(subscribe(70, 1)).messages.empty());
  REQUIRE(client.addressed(message_on(ChannelId::pose)));
  CHECK(bytes_of(*client.addressed(message_on(ChannelId::pose))).substr(0, 2) == "\x01\x46"s);
  CHECK_FALSE(client.addressed(message_on(ChannelId::odometry)));
  CHECK(client.take_text(R"({"op":"unsubscribe","subscriptionIds":[70]})").messages.empty());
  CHECK_FALSE(client.addressed(message_on(ChannelId::pose)));
}

TEST_CASE("A subscriber gets at once what came before he did") {
  Conversation client({"robot", "session", true},
                      [](ChannelId channel) { return std::vector<Message>(3, message_on(channel)); });
  CHECK(client.take_text(subscribe(4, 7)).messages.size() == 3);
}

TEST_CASE("A subscription that cannot be is named and changes nothing else") {
  auto client = conversation();
  client.take_text(subscribe(1, 1));
  for (const auto& [id, channel] : {std::pair{2, 99}, {1, 2}, {3, 1}}) {
    const auto reply = client.take_text(subscribe(id, channel));
    REQUIRE(reply.messages.size() == 1);
    CHECK(json_of(reply.messages[0]).at("level") == 1);
  }
  CHECK(client.subscriptions() == 1);
}

TEST_CASE("The service stops the robot and says so, and another service does not exist") {
  auto client = conversation();
  const Reply reply = client.take_binary(stop_call);
  CHECK(reply.stop);
  REQUIRE(reply.messages.size() == 1);
  CHECK(bytes_of(reply.messages[0]) == "\x03\x01\0\0\0\x09\0\0\0\x04\0\0\0json{\"stopped\":true}"s);
  const Reply other = client.take_binary("\x02\x02\0\0\0\x09\0\0\0\x04\0\0\0json{}"s);
  CHECK_FALSE(other.stop);
  CHECK(json_of(other.messages.at(0)).at("op") == "serviceCallFailure");
}

TEST_CASE("A message that a client publishes on /stop stops the robot, on any other topic it does not") {
  auto client = conversation();
  CHECK(client.take_text(R"({"op":"advertise","channels":[{"id":5,"topic":"/stop","encoding":"json"}]})")
            .messages.empty());
  CHECK(client.take_binary("\x01\x05\0\0\0{}"s).stop);
  CHECK(client.take_text(R"({"op":"advertise","channels":[{"id":6,"topic":"/go"}]})").messages.size() == 1);
  CHECK_FALSE(client.take_binary("\x01\x06\0\0\0{}"s).stop);
  client.take_text(R"({"op":"unadvertise","channelIds":[5]})");
  CHECK_FALSE(client.take_binary("\x01\x05\0\0\0{}"s).stop);
}

TEST_CASE("Who may only watch is offered nothing to stop by, and cannot stop") {
  auto watcher = conversation(false);
  CHECK(watcher.greeting().size() == 2);
  CHECK(json_of(watcher.greeting()[0]).at("capabilities").empty());
  const Reply reply = watcher.take_binary(stop_call);
  CHECK_FALSE(reply.stop);
  CHECK(json_of(reply.messages.at(0)).at("message") == "this connection may only watch");
  watcher.take_text(R"({"op":"advertise","channels":[{"id":5,"topic":"/stop"}]})");
  CHECK_FALSE(watcher.take_binary("\x01\x05\0\0\0{}"s).stop);
}

TEST_CASE("What is no message of the protocol is answered with one line that says what would be right") {
  auto client = conversation();
  CHECK(error_of(client.take_text("{")) == "the message is no JSON");
  CHECK(error_of(client.take_text("\xff\xfe{}")) == "the message is no JSON");
  CHECK(error_of(client.take_text("[]")) == "the message must be a JSON object");
  CHECK(error_of(client.take_text("{}")) == "the message has no 'op'");
  CHECK(error_of(client.take_text(R"({"op":7})")) == "the message has no 'op'");
  CHECK_THAT(error_of(client.take_text(R"({"op":"subscribe"})")),
             ContainsSubstring("'subscriptions' must be a list"));
  CHECK_THAT(error_of(client.take_text(R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})")),
             ContainsSubstring("numbers 'id' and 'channelId'"));
  CHECK_THAT(
      error_of(client.take_text(R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})")),
      ContainsSubstring("numbers 'id' and 'channelId'"));
  CHECK_THAT(error_of(client.take_text(R"({"op":"subscribe","subscriptions":[17]})")),
             ContainsSubstring("must be a list"));
  CHECK_THAT(error_of(client.take_text(R"({"op":"unsubscribe","subscriptionIds":["1"]})")),
             ContainsSubstring("numbers"));
  CHECK_THAT(error_of(client.take_binary("")), ContainsSubstring("opcode"));
  CHECK_THAT(error_of(client.take_binary("\x07")), ContainsSubstring("opcode 7 is unknown"));
  CHECK_THAT(error_of(client.take_binary("\x01\0\0"s)), ContainsSubstring("channel"));
  CHECK_THAT(error_of(client.take_binary("\x02\x01\0\0\0\x09\0\0\0\xff\xff\xff\xffjson"s)),
             ContainsSubstring("length"));
  CHECK(client.subscriptions() == 0);
}

TEST_CASE("JSON nested as deep as a message allows is refused without running out of stack") {
  auto client = conversation();
  constexpr std::size_t depth = 64 * 1024;
  CHECK(error_of(client.take_text(repeated(depth, '['))) == "the message is no JSON");
  const std::string nested =
      R"({"op":"subscribe","subscriptions":)" + repeated(30000, '[') + repeated(30000, ']') + "}";
  CHECK_THAT(error_of(client.take_text(nested)), ContainsSubstring("must be a list"));
}

TEST_CASE("An operation that is not offered is answered by its name, cut short and as valid UTF-8") {
  auto client = conversation();
  const auto reply =
      client.take_text(R"({"op":")" + repeated(39, 'x') + "\xc3\xa4" + repeated(500, 'y') + R"("})");
  REQUIRE(reply.messages.size() == 1);
  CHECK(json_of(reply.messages[0]).at("level") == 1);
  CHECK(reply.messages[0].body->size() < 150);
}

TEST_CASE("Ten thousand messages of random bytes stop nothing and break nothing") {
  auto client = conversation(false);
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) {
    std::string bytes(random() % 40, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    if (!bytes.empty() && i % 2 == 0) bytes[0] = static_cast<char>(1 + random() % 2);
    if (client.take_binary(bytes).stop || client.take_text(bytes).stop)
      FAIL("stopped by " + std::to_string(i));
  }
}
