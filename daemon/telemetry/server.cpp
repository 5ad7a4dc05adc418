#include "daemon/telemetry/server.hpp"

#include <algorithm>
#include <chrono>

#include "daemon/telemetry/websocket_connection.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

// Where the system has no more descriptors, the listener tries again.
constexpr auto accept_again_after = std::chrono::milliseconds(500);
constexpr auto tidy_up_every = std::chrono::milliseconds(500);
constexpr auto say_every = std::chrono::seconds(10);

}  // namespace

Server::Server(asio::io_context& context, ServerConfig config, ServerHooks hooks)
    : context_(context),
      acceptor_(context),
      retry_(context),
      tidying_(context),
      config_(std::move(config)),
      hooks_(std::move(hooks)),
      has_room_([this](const Connection& connection, bool may_control) {
        return has_room(connection, may_control);
      }),
      closed_guests_(say_every),
      refused_clients_(say_every),
      failed_accepts_(say_every) {
  const tcp::endpoint endpoint(asio::ip::make_address(config_.address), config_.port);
  acceptor_.open(endpoint.protocol());
  acceptor_.set_option(tcp::acceptor::reuse_address(true));
  acceptor_.bind(endpoint);
  acceptor_.listen();
  accept();
  tidy_up_regularly();
}

Server::~Server() = default;

std::uint16_t Server::port() const {
  boost::system::error_code ignored;
  return acceptor_.local_endpoint(ignored).port();
}

void Server::accept() {
  acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    forget_closed();
    if (error) {
      accept_later(error);
    } else {
      take(std::move(socket));
      accept();
    }
  });
}

void Server::take(tcp::socket socket) {
  const auto newcomer = std::make_shared<Connection>(std::move(socket), config_, hooks_, has_room_);
  if (const auto guest = guest_to_close(slots(), newcomer->slot().source)) {
    close_guest(*guest);
    if (closed_guests_.happened(CountedNotice::Clock::now())) {
      hooks_.warn("too many connections without a request or a token, room is made among them (" +
                  last_closed_ + ")");
    }
  }
  connections_.push_back(newcomer);
  newcomer->start();
}

// Where a guest holds a file descriptor, it is had at once; where nobody does, by and by.
void Server::accept_later(const boost::system::error_code& error) {
  if (failed_accepts_.happened(CountedNotice::Clock::now())) {
    hooks_.warn("a connection could not be taken (" + error.message() + ")");
  }
  if (const auto guest = guest_to_close(slots())) {
    close_guest(*guest);
    accept();
    return;
  }
  retry_.expires_after(accept_again_after);
  retry_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled) accept();
  });
}

void Server::close_guest(std::size_t index) {
  last_closed_ = connections_.at(index)->slot().source;
  connections_.at(index)->drop();
  forget_closed();
}

bool Server::has_room(const Connection& connection, bool may_control) {
  forget_closed();
  if (has_room_for_client(slots(), may_control)) return true;
  last_refused_ = connection.slot().source;
  if (refused_clients_.happened(CountedNotice::Clock::now())) {
    hooks_.warn(std::to_string(clients()) + " clients are all there is room for, " + last_refused_ +
                " was refused");
  }
  return false;
}

std::vector<Slot> Server::slots() const {
  std::vector<Slot> slots;
  slots.reserve(connections_.size());
  for (const auto& connection : connections_) slots.push_back(connection->slot());
  return slots;
}

void Server::forget_closed() {
  std::erase_if(connections_, [](const auto& connection) { return connection->is_closed(); });
}

// What is closed gives its memory back though nobody new comes.
void Server::tidy_up_regularly() {
  tidying_.expires_after(tidy_up_every);
  tidying_.async_wait([this](const boost::system::error_code& cancelled) {
    if (cancelled) return;
    forget_closed();
    say_what_is_due();
    tidy_up_regularly();
  });
}

void Server::say_what_is_due() {
  const auto now = CountedNotice::Clock::now();
  if (const auto count = closed_guests_.due(now)) {
    hooks_.warn(std::to_string(*count) +
                " more connections without a request or a token were closed, the last of " + last_closed_);
  }
  if (const auto count = refused_clients_.due(now)) {
    hooks_.warn(std::to_string(*count) + " more clients were refused, the last " + last_refused_);
  }
  if (const auto count = failed_accepts_.due(now)) {
    hooks_.warn(std::to_string(*count) + " more connections could not be taken");
  }
}

void Server::publish(const Message& message) {
  for (const auto& connection : connections_) {
    const Conversation* const conversation = connection->conversation();
    if (conversation == nullptr) continue;
    if (auto addressed = conversation->addressed(message)) connection->send(std::move(*addressed));
  }
}

void Server::forget_backlogs() {
  for (const auto& connection : connections_) connection->forget_backlog();
}

bool Server::anyone_wants(ChannelId channel) const {
  return std::any_of(connections_.begin(), connections_.end(), [&](const auto& connection) {
    const Conversation* const conversation = connection->conversation();
    return conversation != nullptr && conversation->wants(channel);
  });
}

std::size_t Server::subscriptions() const {
  std::size_t count = 0;
  for (const auto& connection : connections_) {
    if (const auto* const conversation = connection->conversation()) count += conversation->subscriptions();
  }
  return count;
}

std::size_t Server::clients() const {
  return static_cast<std::size_t>(
      std::count_if(connections_.begin(), connections_.end(),
                    [](const auto& connection) { return connection->conversation() != nullptr; }));
}

void Server::close() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  retry_.cancel();
  tidying_.cancel();
  for (const auto& connection : connections_) connection->close();
}

}  // namespace wheelwright::daemon::telemetry
