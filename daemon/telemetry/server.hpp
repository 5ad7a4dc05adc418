// The live view's port: the page over HTTP, and the Foxglove protocol over WebSocket.
//
// Everything here happens on the thread that runs the io_context; nothing here knows of the robot. A client
// that does not take what it is sent is dropped, as is one that no longer answers. Who does not ask for
// anything within 5 s is let go; see admission.hpp for who is let go where there are too many.
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

#include "daemon/telemetry/admission.hpp"
#include "daemon/telemetry/conversation.hpp"
#include "daemon/telemetry/counted_notice.hpp"

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
  // A sentence for the log: connections that were closed or refused. At most one in 10 s of each kind.
  std::function<void(const std::string& what)> warn = [](const std::string&) {};
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
  // Clients, and those who are not yet, or have asked for the page only.
  std::size_t connections() const { return connections_.size(); }

  // Listens no more, and says goodbye to every client.
  void close();

 private:
  void accept();
  void take(boost::asio::ip::tcp::socket socket);
  void accept_later(const boost::system::error_code& error);
  bool has_room(const Connection& connection, bool may_control);
  std::vector<Slot> slots() const;
  void close_guest(std::size_t index);
  void forget_closed();
  void tidy_up_regularly();
  void say_what_is_due();

  boost::asio::io_context& context_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer retry_;
  boost::asio::steady_timer tidying_;
  ServerConfig config_;
  ServerHooks hooks_;
  std::function<bool(const Connection&, bool)> has_room_;
  std::vector<std::shared_ptr<Connection>> connections_;
  CountedNotice closed_guests_;
  CountedNotice refused_clients_;
  CountedNotice failed_accepts_;
  std::string last_closed_;   // whose guest was closed last
  std::string last_refused_;  // who was refused last
};

}  // namespace wheelwright::daemon::telemetry
