// The live view's port: the page over HTTP, and the Foxglove protocol over WebSocket.
//
// Everything here happens on the thread that runs the io_context; nothing here knows of the robot. A client
// that does not take what it is sent is dropped, as is one that no longer answers.
#pragma once

#include <utility>  // Boost.Asio 1.74 needs it and does not say so

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/telemetry/conversation.hpp"

namespace wheelwright::daemon::telemetry {

class Connection;

struct ServerConfig {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  // 0: any that is free
  std::string token;       // see access.hpp
  std::string name;        // of the robot
  std::string session_id;  // another one after each start
  std::string_view page;   // HTML; lives as long as the server
};

// Who the server asks and tells. Called on the server's thread.
struct ServerHooks {
  Conversation::History history;
  std::function<void(const std::string& who)> stop;  // somebody wants the robot to stop; `who` is his address
};

class Server {
 public:
  // Listens at once. Throws boost::system::system_error where the port is not to be had.
  Server(boost::asio::io_context& context, ServerConfig config, ServerHooks hooks);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  std::uint16_t port() const;

  // Sends a message to all who have subscribed to its channel.
  void publish(const Message& message);
  // Clients that are behind forget what they have not been sent yet, so that what is published next reaches
  // them first.
  void forget_backlogs();
  bool anyone_wants(ChannelId channel) const;
  // Subscriptions of all clients together: what publishing costs.
  std::size_t subscriptions() const;
  std::size_t clients() const;

  // Listens no more, and says goodbye to every client.
  void close();

  static constexpr std::size_t most_connections = 256;

 private:
  friend class Connection;

  void accept();
  void forget_closed();

  boost::asio::io_context& context_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer retry_;
  ServerConfig config_;
  ServerHooks hooks_;
  std::vector<std::shared_ptr<Connection>> connections_;
};

}  // namespace wheelwright::daemon::telemetry
