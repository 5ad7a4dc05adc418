#include "daemon/telemetry/websocket_connection.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <utility>

namespace wheelwright::daemon::telemetry {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

// For a request, from its connection or from the answer before; for the handshake that follows it.
constexpr auto request_patience = std::chrono::seconds(5);
constexpr std::uint32_t largest_header = 8 * 1024;
constexpr std::uint64_t largest_body = 1024;
constexpr std::size_t largest_message = 64 * 1024;  // from a client
// What a slow client may be behind: about two seconds of everything, after which it is dropped.
constexpr std::size_t max_queued_bytes = 1024 * 1024;
// More than this is a backlog: about an eighth of a second of everything.
constexpr std::size_t backlog_bytes = 64 * 1024;
// The system holds no more than about this for a client, so that what is queued here is what it is behind.
constexpr int system_buffer_bytes = 128 * 1024;

std::string_view view_of(beast::string_view text) {
  return {text.data(), text.size()};
}

websocket::stream_base::timeout patience() {
  websocket::stream_base::timeout patience{};
  patience.handshake_timeout = request_patience;
  patience.idle_timeout = std::chrono::seconds(10);  // a ping half way; no answer, no client
  patience.keep_alive_pings = true;
  return patience;
}

}  // namespace

Connection::Connection(asio::ip::tcp::socket socket, const ServerConfig& config, const ServerHooks& hooks,
                       const HasRoom& has_room)
    : stream_(std::move(socket)), config_(config), hooks_(hooks), has_room_(has_room) {
  beast::error_code error;
  auto& tcp = stream_.next_layer().socket();
  const auto caller = tcp.remote_endpoint(error);
  if (!error) {
    const std::string address = caller.address().to_string();
    caller_ = address + ":" + std::to_string(caller.port());
    source_ = source_of(address);
  }
  tcp.set_option(asio::ip::tcp::no_delay(true), error);
  tcp.set_option(asio::socket_base::send_buffer_size(system_buffer_bytes), error);
}

void Connection::start() {
  read_request();
}

void Connection::read_request() {
  parser_.emplace();
  parser_->header_limit(largest_header);
  parser_->body_limit(largest_body);
  stream_.next_layer().expires_after(request_patience);
  http::async_read(stream_.next_layer(), input_, *parser_,
                   [self = shared_from_this()](beast::error_code error, std::size_t /*bytes*/) {
                     if (error) {
                       self->drop();
                       return;
                     }
                     self->on_request();
                   });
}

void Connection::on_request() {
  request_ = parser_->release();
  const Caller caller{view_of(request_[http::field::host]), view_of(request_[http::field::origin]),
                      view_of(request_[http::field::authorization]), view_of(request_.target())};
  const Access access = access_of(caller, config_.token);
  const bool admitted = access == Access::control || access == Access::watch;
  if (admitted && websocket::is_upgrade(request_)) {
    // Who sends frames before the answer does not speak the protocol.
    if (input_.size() > 0) {
      drop();
    } else {
      upgrade(access);
    }
  } else {
    answer(http_answer(request_, access, config_.page));
  }
}

void Connection::answer(HttpResponse response) {
  response_ = std::move(response);
  http::async_write(stream_.next_layer(), *response_,
                    [self = shared_from_this()](beast::error_code error, std::size_t /*bytes*/) {
                      if (error || !self->response_->keep_alive() || self->is_closing_) {
                        self->drop();
                        return;
                      }
                      self->response_.reset();
                      self->read_request();
                    });
}

void Connection::upgrade(Access access) {
  const auto protocol = choose_subprotocol(view_of(request_[http::field::sec_websocket_protocol]));
  if (protocol.empty()) {
    answer(no_subprotocol(request_));
    return;
  }
  if (!has_room_(*this, access == Access::control)) {
    answer(no_room(request_));
    return;
  }
  conversation_.emplace(ServerInfo{config_.name, config_.session_id, access == Access::control},
                        hooks_.history);
  stream_.next_layer().expires_never();
  stream_.set_option(patience());
  stream_.set_option(websocket::stream_base::decorator([protocol](websocket::response_type& response) {
    response.set(http::field::sec_websocket_protocol, beast::string_view(protocol.data(), protocol.size()));
  }));
  stream_.read_message_max(largest_message);
  stream_.async_accept(request_, [self = shared_from_this()](beast::error_code error) {
    if (error) {
      self->drop();
      return;
    }
    self->greet();
  });
}

void Connection::greet() {
  is_open_ = true;
  for (Outgoing& message : conversation_->greeting()) send(std::move(message));
  read_message();
}

void Connection::read_message() {
  stream_.async_read(input_, [self = shared_from_this()](beast::error_code error, std::size_t /*bytes*/) {
    if (error) {
      self->drop();
      return;
    }
    self->on_message();
  });
}

void Connection::on_message() {
  const auto data = input_.cdata();
  const std::string_view message(static_cast<const char*>(data.data()), data.size());
  Reply reply = stream_.got_text() ? conversation_->take_text(message) : conversation_->take_binary(message);
  input_.consume(input_.size());
  // First the wheels, then the answer.
  if (reply.stop) hooks_.stop(caller_);
  for (Outgoing& answer : reply.messages) send(std::move(answer));
  if (!is_closed_) read_message();
}

void Connection::send(Outgoing message) {
  if (!is_open_ || is_closing_ || is_closed_) return;
  queued_bytes_ += message.size();
  if (queued_bytes_ > max_queued_bytes) {
    drop();
    return;
  }
  queue_.push_back(std::move(message));
  if (queue_.size() == 1) write_next();
}

void Connection::write_next() {
  const Outgoing& message = queue_.front();
  stream_.binary(message.binary);
  const std::array<asio::const_buffer, 2> parts{asio::buffer(message.head.data(), message.head_size),
                                                asio::buffer(*message.body)};
  stream_.async_write(parts, [self = shared_from_this()](beast::error_code error, std::size_t /*bytes*/) {
    if (error || self->is_closed_) {
      self->drop();
      return;
    }
    self->queued_bytes_ -= self->queue_.front().size();
    self->queue_.pop_front();
    if (!self->queue_.empty()) {
      self->write_next();
    } else if (self->is_closing_) {
      self->is_closing_ = false;
      self->close();
    }
  });
}

void Connection::forget_backlog() {
  if (!is_open_ || queue_.empty() || queued_bytes_ <= backlog_bytes) return;
  // The first is being written.
  const auto forgotten = std::remove_if(queue_.begin() + 1, queue_.end(),
                                        [](const Outgoing& message) { return message.may_be_skipped; });
  queue_.erase(forgotten, queue_.end());
  queued_bytes_ =
      std::accumulate(queue_.begin(), queue_.end(), std::size_t{0},
                      [](std::size_t sum, const Outgoing& message) { return sum + message.size(); });
}

void Connection::close() {
  if (is_closed_ || is_closing_) return;
  is_closing_ = true;
  if (!is_open_) {
    if (!response_) drop();
    return;
  }
  if (!queue_.empty()) return;
  stream_.async_close(websocket::close_reason(websocket::close_code::going_away, "the daemon ends"),
                      [self = shared_from_this()](beast::error_code /*ignored*/) { self->drop(); });
}

// The operations in flight end with an error and let go of this object.
void Connection::drop() {
  is_closed_ = true;
  is_open_ = false;
  stream_.next_layer().close();
}

}  // namespace wheelwright::daemon::telemetry
