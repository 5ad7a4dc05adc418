#include "tests/support/live_view_client.hpp"

#include <stdexcept>

namespace wheelwright::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;

tcp::endpoint endpoint_of(std::uint16_t port) {
  return {asio::ip::make_address("127.0.0.1"), port};
}

std::uint64_t number_at(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
  }
  return value;
}

}  // namespace

HttpReply http_request(std::uint16_t port, const std::string& target, const Headers& headers,
                       const std::string& method) {
  asio::io_context context;
  tcp::socket socket(context);
  socket.connect(endpoint_of(port));
  http::request<http::empty_body> request;
  request.method_string(method);
  request.target(target);
  request.version(11);
  request.set(http::field::host, "127.0.0.1:" + std::to_string(port));
  request.set(http::field::connection, "close");
  for (const auto& [name, value] : headers) request.set(name, value);
  http::write(socket, request);
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.skip(method == "HEAD");
  http::read(socket, buffer, parser);
  const auto& response = parser.get();
  HttpReply reply{response.result_int(), response.body(), {}};
  for (const auto& field : response) {
    reply.headers[std::string(field.name_string())] = std::string(field.value());
  }
  return reply;
}

std::string raw_exchange(std::uint16_t port, const std::vector<std::string>& parts,
                         const std::string& until) {
  asio::io_context context;
  beast::tcp_stream stream(context);
  stream.connect(endpoint_of(port));
  std::string answer;
  std::array<char, 4096> buffer{};
  bool ended = false;
  std::size_t sent = 0;
  while (!ended && (until.empty() || answer.find(until) == std::string::npos)) {
    beast::error_code ignored;
    if (sent < parts.size()) asio::write(stream.socket(), asio::buffer(parts[sent++]), ignored);
    stream.expires_after(std::chrono::seconds(2));
    stream.async_read_some(asio::buffer(buffer), [&](beast::error_code error, std::size_t count) {
      answer.append(buffer.data(), count);
      ended = static_cast<bool>(error);
    });
    context.restart();
    context.run();
  }
  return answer;
}

std::uint32_t Received::subscription() const {
  return static_cast<std::uint32_t>(number_at(bytes, 1, 4));
}

std::uint64_t Received::time_ns() const {
  return number_at(bytes, 5, 8);
}

LiveViewClient::LiveViewClient(std::uint16_t port, const std::string& target, const Headers& headers,
                               const std::string& subprotocol) {
  stream_.next_layer().connect(endpoint_of(port));
  stream_.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
    request.set(http::field::sec_websocket_protocol, subprotocol);
    for (const auto& [name, value] : headers) request.set(name, value);
  }));
  websocket::response_type response;
  const auto host = headers.find("Host");
  stream_.handshake(response, host == headers.end() ? "127.0.0.1:" + std::to_string(port) : host->second,
                    target);
  subprotocol_ = std::string(response[http::field::sec_websocket_protocol]);
}

void LiveViewClient::send_text(const std::string& text) {
  stream_.binary(false);
  stream_.write(asio::buffer(text));
}

void LiveViewClient::send_binary(const std::string& bytes) {
  stream_.binary(true);
  stream_.write(asio::buffer(bytes));
}

void LiveViewClient::subscribe(std::uint32_t id, std::uint32_t channel) {
  send_text(
      nlohmann::json{{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel}}}}}.dump());
}

void LiveViewClient::call_stop() {
  using namespace std::string_literals;
  send_binary("\x02\x01\0\0\0\x07\0\0\0\x04\0\0\0json{}"s);
}

std::optional<Received> LiveViewClient::next(std::chrono::milliseconds at_most) {
  if (closed_ || gave_up_) return std::nullopt;
  beast::flat_buffer buffer;
  std::optional<Received> received;
  stream_.next_layer().expires_after(at_most);
  stream_.async_read(buffer, [&](beast::error_code error, std::size_t /*bytes*/) {
    gave_up_ = error == beast::error::timeout;
    closed_ = error && !gave_up_;
    if (!error) received = Received{stream_.got_binary(), beast::buffers_to_string(buffer.data())};
  });
  context_.restart();
  context_.run();
  return received;
}

nlohmann::json LiveViewClient::next_text(const std::string& operation) {
  while (const auto message = next()) {
    if (message->binary) continue;
    auto json = message->json();
    if (json.at("op") == operation) return json;
  }
  throw std::runtime_error("no '" + operation + "' has come");
}

Received LiveViewClient::next_data(std::uint32_t subscription, std::chrono::milliseconds at_most) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (std::chrono::steady_clock::now() < deadline) {
    const auto message = next(at_most);
    if (!message) break;
    if (message->binary && message->bytes.at(0) == 1 && message->subscription() == subscription)
      return *message;
  }
  throw std::runtime_error("nothing has come for subscription " + std::to_string(subscription));
}

bool LiveViewClient::is_closed_within(std::chrono::milliseconds at_most) {
  const auto deadline = std::chrono::steady_clock::now() + at_most;
  while (!closed_ && !gave_up_ && std::chrono::steady_clock::now() < deadline) next(at_most);
  return closed_;
}

struct Crowd::Reader {
  explicit Reader(asio::io_context& context) : stream(context) {}

  websocket::stream<beast::tcp_stream> stream;
  beast::flat_buffer buffer;
};

Crowd::Crowd(std::uint16_t port, std::size_t readers, std::size_t sleepers) {
  constexpr std::uint32_t channels = 12;
  nlohmann::json everything{{"op", "subscribe"}, {"subscriptions", nlohmann::json::array()}};
  for (std::uint32_t id = 1; id <= channels; ++id) {
    everything["subscriptions"].push_back({{"id", id}, {"channelId", id}});
  }
  const std::string subscribe = everything.dump();
  for (std::size_t i = 0; i < readers + sleepers; ++i) {
    auto& list = i < readers ? readers_ : sleepers_;
    auto& stream = list.emplace_back(std::make_unique<Reader>(context_))->stream;
    stream.next_layer().connect(endpoint_of(port));
    stream.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
      request.set(http::field::sec_websocket_protocol, "foxglove.sdk.v1");
    }));
    stream.handshake("127.0.0.1", "/");
    stream.write(asio::buffer(subscribe));
  }
  for (const auto& reader : readers_) read(*reader);
  thread_ = std::thread([this] { context_.run(); });
}

Crowd::~Crowd() {
  context_.stop();
  thread_.join();
}

void Crowd::read(Reader& reader) {
  reader.stream.async_read(reader.buffer, [this, &reader](beast::error_code error, std::size_t /*bytes*/) {
    if (error) return;
    reader.buffer.clear();
    ++received_;
    read(reader);
  });
}

}  // namespace wheelwright::test
