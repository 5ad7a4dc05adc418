#include "daemon/telemetry/conversation.hpp"

#include <algorithm>
#include <string>

namespace wheelwright::daemon::telemetry {
namespace {

constexpr std::size_t max_stop_channels = 64;
constexpr std::string_view only_watches = "this connection may only watch";

}  // namespace

std::vector<Outgoing> Conversation::greeting() const {
  std::vector<Outgoing> messages{server_info(info_), advertise_channels()};
  if (info_.may_control) messages.push_back(advertise_stop());
  return messages;
}

Reply Conversation::take_text(std::string_view text) {
  return take(parse_text(text));
}

Reply Conversation::take_binary(std::string_view bytes) {
  return take(parse_binary(bytes));
}

std::optional<Outgoing> Conversation::addressed(const Message& message) const {
  const auto found = subscriptions_.find(message.channel);
  if (found == subscriptions_.end()) return std::nullopt;
  return message_data(found->second, message);
}

Reply Conversation::take(const tl::expected<Request, std::string>& request) {
  Reply reply;
  if (request) {
    std::visit([&](const auto& asked) { answer(asked, reply); }, *request);
  } else {
    reply.messages.push_back(status(StatusLevel::error, request.error()));
  }
  return reply;
}

void Conversation::answer(const request::Subscribe& subscribe, Reply& reply) {
  for (const auto& [id, number] : subscribe.subscriptions) {
    const Channel* const channel = find_channel(number);
    const bool id_is_taken = std::any_of(subscriptions_.begin(), subscriptions_.end(),
                                         [id = id](const auto& entry) { return entry.second == id; });
    if (channel == nullptr || id_is_taken || wants(channel->id)) {
      const std::string what = channel == nullptr ? "there is no channel " + std::to_string(number)
                               : id_is_taken      ? "subscription " + std::to_string(id) + " exists"
                                                  : "channel " + std::to_string(number) + " is subscribed to";
      reply.messages.push_back(status(StatusLevel::warning, what));
      continue;
    }
    subscriptions_[channel->id] = id;
    for (const Message& message : history_(channel->id)) reply.messages.push_back(message_data(id, message));
  }
}

void Conversation::answer(const request::Unsubscribe& unsubscribe, Reply& reply) {
  for (const std::uint32_t id : unsubscribe.subscriptions) {
    const auto gone = std::erase_if(subscriptions_, [&](const auto& entry) { return entry.second == id; });
    if (gone == 0) {
      reply.messages.push_back(
          status(StatusLevel::warning, "there is no subscription " + std::to_string(id)));
    }
  }
}

void Conversation::answer(const request::Advertise& advertise, Reply& reply) {
  for (const auto& [id, topic] : advertise.channels) {
    if (!info_.may_control || topic != stop_topic || stop_channels_.size() >= max_stop_channels) {
      const std::string why =
          info_.may_control ? "nothing is taken but " + std::string(stop_topic) : std::string(only_watches);
      reply.messages.push_back(status(StatusLevel::warning, why));
      continue;
    }
    stop_channels_.insert(id);
  }
}

void Conversation::answer(const request::Unadvertise& unadvertise, Reply& /*reply*/) {
  for (const std::uint32_t id : unadvertise.channels) stop_channels_.erase(id);
}

void Conversation::answer(const request::Publish& publish, Reply& reply) {
  if (stop_channels_.contains(publish.channel)) {
    reply.stop = true;
  } else {
    reply.messages.push_back(status(
        StatusLevel::error, "channel " + std::to_string(publish.channel) + " has not been advertised"));
  }
}

void Conversation::answer(const request::CallService& call, Reply& reply) {
  if (!info_.may_control) {
    reply.messages.push_back(service_failure(call.service, call.call, only_watches));
  } else if (call.service != stop_service) {
    reply.messages.push_back(service_failure(call.service, call.call, "there is no such service"));
  } else {
    reply.stop = true;
    reply.messages.push_back(service_response(call.service, call.call, R"({"stopped":true})"));
  }
}

void Conversation::answer(const request::Other& other, Reply& reply) {
  reply.messages.push_back(status(StatusLevel::warning, "'" + other.operation + "' is not offered"));
}

}  // namespace wheelwright::daemon::telemetry
