// One client's side of the protocol, without the socket: what it is greeted with, what it has subscribed to,
// and what is answered to what it sends.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "daemon/telemetry/protocol.hpp"

namespace wheelwright::daemon::telemetry {

// What a client's message leads to.
struct Reply {
  std::vector<Outgoing> messages;
  bool stop = false;  // the robot is to stop
};

class Conversation {
 public:
  // What a new subscriber of a channel gets at once, so that nobody looks at an empty page.
  using History = std::function<std::vector<Message>(ChannelId)>;

  Conversation(ServerInfo info, History history) : info_(std::move(info)), history_(std::move(history)) {}

  std::vector<Outgoing> greeting() const;
  Reply take_text(std::string_view text);
  Reply take_binary(std::string_view bytes);

  // How a message reaches this client; nothing where it has not subscribed to its channel.
  std::optional<Outgoing> addressed(const Message& message) const;
  bool wants(ChannelId channel) const { return subscriptions_.contains(channel); }
  std::size_t subscriptions() const { return subscriptions_.size(); }

 private:
  Reply take(const tl::expected<Request, std::string>& request);
  void answer(const request::Subscribe& subscribe, Reply& reply);
  void answer(const request::Unsubscribe& unsubscribe, Reply& reply);
  void answer(const request::Advertise& advertise, Reply& reply);
  void answer(const request::Unadvertise& unadvertise, Reply& reply);
  void answer(const request::Publish& publish, Reply& reply);
  void answer(const request::CallService& call, Reply& reply);
  void answer(const request::Other& other, Reply& reply);

  ServerInfo info_;
  History history_;
  std::map<ChannelId, std::uint32_t> subscriptions_;
  std::set<std::uint32_t> stop_channels_;  // that the client advertised, by its own numbers
};

}  // namespace wheelwright::daemon::telemetry
