#include "daemon/telemetry/protocol.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "config/load/ascii_text.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

using Json = nlohmann::json;

// A client's text may hold bytes that are no UTF-8; in an answer they are replaced.
Outgoing text_of(const Json& json) {
  Outgoing message;
  message.body =
      std::make_shared<const std::string>(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  return message;
}

template <typename Integer>
std::size_t put(char* at, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i) at[i] = static_cast<char>((value >> (8 * i)) & 0xff);
  return sizeof value;
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

}  // namespace

std::string_view choose_subprotocol(std::string_view offered) {
  while (!offered.empty()) {
    const auto comma = std::min(offered.find(','), offered.size());
    const auto name = config::trim(offered.substr(0, comma));
    const auto* const known = std::find(subprotocols.begin(), subprotocols.end(), name);
    if (known != subprotocols.end()) return *known;
    offered.remove_prefix(std::min(comma + 1, offered.size()));
  }
  return {};
}

Outgoing server_info(const ServerInfo& info) {
  Json json{{"op", "serverInfo"},
            {"name", info.name},
            {"capabilities", Json::array()},
            {"supportedEncodings", {"json"}},
            {"metadata", {{"wheelwright_control", info.may_control ? "yes" : "no"}}},
            {"sessionId", info.session_id}};
  if (info.may_control) json["capabilities"] = {"clientPublish", "services"};
  return text_of(json);
}

Outgoing advertise_channels() {
  Json list = Json::array();
  for (const Channel& channel : channels()) {
    list.push_back({{"id", static_cast<std::uint32_t>(channel.id)},
                    {"topic", channel.topic},
                    {"encoding", "json"},
                    {"schemaName", channel.schema_name},
                    {"schema", channel.schema},
                    {"schemaEncoding", "jsonschema"}});
  }
  return text_of({{"op", "advertise"}, {"channels", std::move(list)}});
}

Outgoing advertise_stop() {
  const auto message = [](const char* name, const Json& properties) {
    return Json{{"encoding", "json"},
                {"schemaName", name},
                {"schemaEncoding", "jsonschema"},
                {"schema", Json{{"title", name}, {"type", "object"}, {"properties", properties}}.dump()}};
  };
  const Json stopped = {{"stopped", {{"type", "boolean"}}}};
  return text_of({{"op", "advertiseServices"},
                  {"services",
                   {{{"id", stop_service},
                     {"name", stop_topic},
                     {"type", "wheelwright.Stop"},
                     {"request", message("wheelwright.StopRequest", Json::object())},
                     {"response", message("wheelwright.StopResponse", stopped)},
                     // For clients of before 2024.
                     {"requestSchema", ""},
                     {"responseSchema", ""}}}}});
}

Outgoing status(StatusLevel level, std::string_view text) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}});
}

Outgoing message_data(std::uint32_t subscription, const Message& message) {
  constexpr std::uint8_t opcode = 1;
  Outgoing out;
  out.binary = true;
  out.may_be_skipped = message.channel != ChannelId::log;
  out.head[0] = static_cast<char>(opcode);
  out.head_size = 1;
  out.head_size += put(out.head.data() + out.head_size, subscription);
  out.head_size += put(out.head.data() + out.head_size, message.time_ns);
  out.body = message.payload;
  return out;
}

Outgoing service_response(std::uint32_t service, std::uint32_t call, std::string_view json) {
  constexpr char opcode = 3;
  constexpr std::string_view encoding = "json";
  std::array<char, 13> head{opcode};
  put(head.data() + 1, service);
  put(head.data() + 5, call);
  put(head.data() + 9, static_cast<std::uint32_t>(encoding.size()));
  Outgoing out;
  out.binary = true;
  std::string body(head.data(), head.size());
  body.append(encoding).append(json);
  out.body = std::make_shared<const std::string>(std::move(body));
  return out;
}

Outgoing service_failure(std::uint32_t service, std::uint32_t call, std::string_view why) {
  return text_of({{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", why}});
}

namespace {

using Failure = tl::unexpected<std::string>;

std::optional<std::uint32_t> id_in(const Json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (number > 0xffffffffU) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

std::optional<std::uint32_t> id_at(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found == object.end() ? std::nullopt : id_in(*found);
}

// The list under a key, each of its items read by `read`; an error where one of them is not as it should be.
template <typename Item, typename Read>
tl::expected<std::vector<Item>, std::string> list_at(const Json& json, const char* key, const char* items,
                                                     Read read) {
  const auto found = json.find(key);
  const std::string wanted = std::string("'") + key + "' must be a list of " + items;
  if (found == json.end() || !found->is_array()) return Failure(wanted);
  std::vector<Item> list;
  for (const Json& value : *found) {
    const std::optional<Item> item = read(value);
    if (!item) return Failure(wanted);
    list.push_back(*item);
  }
  return list;
}

std::optional<request::Subscription> subscription_in(const Json& value) {
  const auto id = id_at(value, "id");
  const auto channel = id_at(value, "channelId");
  if (!id || !channel) return std::nullopt;
  return request::Subscription{*id, *channel};
}

std::optional<request::ClientChannel> client_channel_in(const Json& value) {
  const auto id = id_at(value, "id");
  const auto topic = value.is_object() ? value.find("topic") : value.end();
  if (!id || topic == value.end() || !topic->is_string()) return std::nullopt;
  return request::ClientChannel{*id, topic->get<std::string>()};
}

template <typename Wanted, typename List>
tl::expected<Request, std::string> made_of(List&& list) {
  if (!list) return Failure(list.error());
  return Request{Wanted{std::move(*list)}};
}

}  // namespace

tl::expected<Request, std::string> parse_text(std::string_view text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return Failure("the message is no JSON");
  if (!json.is_object()) return Failure("the message must be a JSON object");
  const auto op = json.find("op");
  if (op == json.end() || !op->is_string()) return Failure("the message has no 'op'");
  const auto operation = op->get<std::string>();
  if (operation == "subscribe") {
    return made_of<request::Subscribe>(list_at<request::Subscription>(
        json, "subscriptions", "objects with numbers 'id' and 'channelId'", subscription_in));
  }
  if (operation == "unsubscribe") {
    return made_of<request::Unsubscribe>(list_at<std::uint32_t>(json, "subscriptionIds", "numbers", id_in));
  }
  if (operation == "advertise") {
    return made_of<request::Advertise>(list_at<request::ClientChannel>(
        json, "channels", "objects with a number 'id' and a text 'topic'", client_channel_in));
  }
  if (operation == "unadvertise") {
    return made_of<request::Unadvertise>(list_at<std::uint32_t>(json, "channelIds", "numbers", id_in));
  }
  constexpr std::size_t longest_told = 40;
  return Request{request::Other{operation.substr(0, longest_told)}};
}

tl::expected<Request, std::string> parse_binary(std::string_view bytes) {
  constexpr char publish_opcode = 1;
  constexpr char service_opcode = 2;
  constexpr std::size_t publish_head = 5;
  constexpr std::size_t service_head = 13;
  if (bytes.empty()) return Failure("a binary message must begin with its opcode");
  if (bytes[0] == publish_opcode) {
    if (bytes.size() < publish_head) return Failure("a published message must begin with its channel");
    return Request{request::Publish{number_at(bytes, 1)}};
  }
  if (bytes[0] == service_opcode) {
    if (bytes.size() < service_head || bytes.size() - service_head < number_at(bytes, 9)) {
      return Failure("a service call must hold service, call, length of the encoding's name, and that name");
    }
    return Request{request::CallService{number_at(bytes, 1), number_at(bytes, 5)}};
  }
  return Failure("opcode " + std::to_string(static_cast<unsigned char>(bytes[0])) +
                 " is unknown; 1 and 2 are known");
}

}  // namespace wheelwright::daemon::telemetry
