// The Foxglove WebSocket protocol, as much of it as the live view speaks: how the server's messages are
// written, and how a client's are read. Text messages are JSON with the key `op`; binary ones begin with an
// opcode, and numbers in them are little-endian.
//
// The protocol has had two names; on the wire they are the same.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "daemon/telemetry/channels.hpp"

namespace wheelwright::daemon::telemetry {

constexpr std::array<std::string_view, 2> subprotocols{"foxglove.sdk.v1", "foxglove.websocket.v1"};

// The first of the names in a Sec-WebSocket-Protocol header that this server knows; empty where there is
// none.
std::string_view choose_subprotocol(std::string_view offered);

// One WebSocket message on its way to a client. The body may be shared by many.
struct Outgoing {
  bool binary = false;
  bool may_be_skipped = false;  // telemetry: the next message of its channel says how things are
  std::array<char, 13> head{};  // of binary messages, in front of the body
  std::size_t head_size = 0;
  std::shared_ptr<const std::string> body;

  std::size_t size() const { return head_size + body->size(); }
};

enum class StatusLevel : int { info = 0, warning = 1, error = 2 };

struct ServerInfo {
  std::string name;
  std::string session_id;  // another one after each start of the daemon
  bool may_control = false;
};

// The one service: POST nothing, and the wheels come to rest.
constexpr std::uint32_t stop_service = 1;
constexpr std::string_view stop_topic = "/stop";  // also that of a message that a client publishes

Outgoing server_info(const ServerInfo& info);
Outgoing advertise_channels();
Outgoing advertise_stop();
Outgoing status(StatusLevel level, std::string_view text);
Outgoing message_data(std::uint32_t subscription, const Message& message);
Outgoing service_response(std::uint32_t service, std::uint32_t call, std::string_view json);
Outgoing service_failure(std::uint32_t service, std::uint32_t call, std::string_view why);

// What a client may ask.
namespace request {
struct Subscription {
  std::uint32_t id = 0;
  std::uint32_t channel = 0;
};
struct Subscribe {
  std::vector<Subscription> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};
struct ClientChannel {
  std::uint32_t id = 0;
  std::string topic;
};
struct Advertise {
  std::vector<ClientChannel> channels;
};
struct Unadvertise {
  std::vector<std::uint32_t> channels;
};
struct Publish {
  std::uint32_t channel = 0;
};
struct CallService {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
};
// An operation of the protocol, or of a later one, that this server does not offer.
struct Other {
  std::string operation;
};
}  // namespace request

using Request = std::variant<request::Subscribe, request::Unsubscribe, request::Advertise,
                             request::Unadvertise, request::Publish, request::CallService, request::Other>;

// Reads a message of a client, or says in one line what is wrong with it. Any bytes may come.
tl::expected<Request, std::string> parse_text(std::string_view text);
tl::expected<Request, std::string> parse_binary(std::string_view bytes);

}  // namespace wheelwright::daemon::telemetry
