#include "daemon/telemetry/server.hpp"

#include <algorithm>
#include <chrono>

#include "daemon/telemetry/connection.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

// Where the system has no more descriptors, the listener tries again.
constexpr auto accept_again_after = std::chrono::milliseconds(500);

}  // namespace

Server::Server(asio::io_context& context, ServerConfig config, ServerHooks hooks)
    : context_(context),
      acceptor_(context),
      retry_(context),
      config_(std::move(config)),
      hooks_(std::move(hooks)) {
  const tcp::endpoint endpoint(asio::ip::make_address(config_.address), config_.port);
  acceptor_.open(endpoint.protocol());
  acceptor_.set_option(tcp::acceptor::reuse_address(true));
  acceptor_.bind(endpoint);
  acceptor_.listen();
  accept();
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
      retry_.expires_after(accept_again_after);
      retry_.async_wait([this](const boost::system::error_code& cancelled) {
        if (!cancelled) accept();
      });
      return;
    }
    // One too many is closed without a word.
    if (connections_.size() < most_connections) {
      connections_.push_back(std::make_shared<Connection>(std::move(socket), config_, hooks_));
      connections_.back()->start();
    }
    accept();
  });
}

void Server::forget_closed() {
  std::erase_if(connections_, [](const auto& connection) { return connection->is_closed(); });
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
  for (const auto& connection : connections_) connection->close();
}

}  // namespace wheelwright::daemon::telemetry
