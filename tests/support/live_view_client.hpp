// A client of the live view as other people write them: HTTP and WebSocket over a blocking socket.
#pragma once

#include <utility>  // Boost.Asio 1.74 needs it and does not say so

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace wheelwright::test {

using Headers = std::map<std::string, std::string>;

struct HttpReply {
  unsigned status = 0;
  std::string body;
  Headers headers;
};

// Sends a request and reads the answer. `headers` replace the usual ones of their name.
HttpReply http_request(std::uint16_t port, const std::string& target, const Headers& headers = {},
                       const std::string& method = "GET");

// Sends parts as they are, each but the first once something has come, and returns what comes until the
// server closes, has sent `until`, or is silent for two seconds.
std::string raw_exchange(std::uint16_t port, const std::vector<std::string>& parts,
                         const std::string& until = "");

// One message of the server.
struct Received {
  bool binary = false;
  std::string bytes;

  nlohmann::json json() const { return nlohmann::json::parse(bytes); }
  // Of a message data frame.
  std::uint32_t subscription() const;
  std::uint64_t time_ns() const;
  nlohmann::json payload() const { return nlohmann::json::parse(bytes.substr(13)); }
};

class LiveViewClient {
 public:
  // Connects, or throws boost::system::system_error, as where the server refuses.
  explicit LiveViewClient(std::uint16_t port, const std::string& target = "/", const Headers& headers = {},
                          const std::string& subprotocol = "foxglove.sdk.v1");

  const std::string& subprotocol() const { return subprotocol_; }
  void send_text(const std::string& text);
  void send_binary(const std::string& bytes);
  void subscribe(std::uint32_t id, std::uint32_t channel);
  // Calls the service that stops the robot.
  void call_stop();

  // The next message, or nothing where none comes in time, after which none comes any more, or where the
  // server has closed.
  std::optional<Received> next(std::chrono::milliseconds at_most = std::chrono::seconds(2));
  // Reads on to the first text message of an operation; throws std::runtime_error where it does not come.
  nlohmann::json next_text(const std::string& operation);
  // Reads on to the first message of a subscription.
  Received next_data(std::uint32_t subscription, std::chrono::milliseconds at_most = std::chrono::seconds(2));
  // Whether the server has closed the connection; reads what comes before.
  bool is_closed_within(std::chrono::milliseconds at_most);

 private:
  boost::asio::io_context context_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_{context_};
  std::string subprotocol_;
  bool gave_up_ = false;
  bool closed_ = false;
};

// Many clients that have subscribed to everything: some read all that comes, on a thread of their own, the
// others nothing at all.
class Crowd {
 public:
  Crowd(std::uint16_t port, std::size_t readers, std::size_t sleepers);
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;
  ~Crowd();

  // Messages read by all readers so far.
  std::uint64_t received() const { return received_; }

 private:
  struct Reader;
  void read(Reader& reader);

  boost::asio::io_context context_;
  std::vector<std::unique_ptr<Reader>> readers_;
  std::vector<std::unique_ptr<Reader>> sleepers_;
  std::atomic<std::uint64_t> received_{0};
  std::thread thread_;
};

}  // namespace wheelwright::test
