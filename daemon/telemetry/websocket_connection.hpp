// One caller: an HTTP request that is answered, or that becomes a WebSocket and stays.
#pragma once

#include <utility>  // Boost.Asio 1.74 needs it and does not say so

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "daemon/telemetry/access.hpp"
#include "daemon/telemetry/admission.hpp"
#include "daemon/telemetry/conversation.hpp"
#include "daemon/telemetry/http_answer.hpp"
#include "daemon/telemetry/server.hpp"

namespace wheelwright::daemon::telemetry {

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  // Whether there is room for one more client, who may stop the robot or only watch.
  using HasRoom = std::function<bool(const Connection& connection, bool may_control)>;

  // `config`, `hooks` and `has_room` outlive the io_context's last handler.
  Connection(boost::asio::ip::tcp::socket socket, const ServerConfig& config, const ServerHooks& hooks,
             const HasRoom& has_room);

  void start();
  // Puts a message into the queue; where the queue is full the client is dropped.
  void send(Outgoing message);
  // Forgets what is queued of the channels, where that is more than a client catches up with in a moment: the
  // next message is then the next that it gets.
  void forget_backlog();
  // Ends the conversation: politely where it is one, at once where not.
  void close();
  // Ends the connection at once, whatever it is.
  void drop();

  // The conversation, once it has begun; null before and for plain HTTP.
  const Conversation* conversation() const { return is_open_ ? &*conversation_ : nullptr; }
  bool is_closed() const { return is_closed_; }
  // What it takes of the room there is; valid as long as this object.
  Slot slot() const { return {source_, conversation_.has_value(), response_.has_value()}; }

 private:
  void read_request();
  void on_request();
  void answer(HttpResponse response);
  void upgrade(Access access);
  void greet();
  void read_message();
  void on_message();
  void write_next();

  boost::beast::websocket::stream<boost::beast::tcp_stream, false> stream_;  // without compression
  const ServerConfig& config_;
  const ServerHooks& hooks_;
  const HasRoom& has_room_;
  std::string caller_;  // address and port
  std::string source_;
  boost::beast::flat_buffer input_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  HttpRequest request_;
  std::optional<HttpResponse> response_;
  std::optional<Conversation> conversation_;
  std::deque<Outgoing> queue_;
  std::size_t queued_bytes_ = 0;
  bool is_open_ = false;     // as a WebSocket
  bool is_closing_ = false;  // goodbye once the queue is empty
  bool is_closed_ = false;
};

}  // namespace wheelwright::daemon::telemetry
