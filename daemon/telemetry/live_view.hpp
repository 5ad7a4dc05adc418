// The thread of the live view: it takes ticks and wake-ups from its rings, makes messages of those that
// somebody wants, and serves them. Whatever happens here, the robot drives on.
#pragma once

#include <utility>  // Boost.Asio 1.74 needs it and does not say so

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/load/daemon_config.hpp"
#include "daemon/telemetry/counted_notice.hpp"
#include "daemon/telemetry/message_sink.hpp"
#include "daemon/telemetry/scene.hpp"
#include "daemon/telemetry/server.hpp"
#include "daemon/telemetry/truth_trail.hpp"
#include "daemon/wiring/wiring.hpp"

namespace wheelwright::daemon::telemetry {

class LiveView {
 public:
  // Listens at once and sets wiring.has_telemetry; so before any other thread starts. Where the port is not
  // to be had it says so in the log and there is no live view: a robot is not kept from driving by that.
  LiveView(const config::DaemonConfig& config, roomba::SensorLoop& sensor_loop, Wiring& wiring);
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;
  ~LiveView();

  // Serves until end(). Returns at once where there is no live view.
  void run();

  // From any thread: tells the clients how the run came out, and ends run().
  void end(const std::string& result, const std::string& outcome);

 private:
  void wait();
  void look();
  void take(const LogEntry& entry);
  void publish(ChannelId channel, std::uint64_t time_ns, std::string payload);
  void publish_tick(const LogEntry& entry);
  void publish_wake_ups();
  void publish_truth();
  void publish_messages();
  void publish_scene(std::chrono::steady_clock::time_point now);
  void publish_state(std::chrono::steady_clock::time_point now);
  void take_stop(const std::string& who);
  // What was too often to be said each time.
  void say_repetitions(std::optional<std::uint64_t> stops, std::optional<std::uint64_t> failures);
  void say_goodbye();
  void leave_by(std::chrono::steady_clock::time_point deadline);
  std::vector<Message> history(ChannelId channel) const;
  std::optional<std::string> text_of(ChannelId channel, const LogEntry& entry) const;
  std::string state_text() const;
  bool is_due(std::uint64_t count) const;
  std::uint64_t unix_ns(std::chrono::steady_clock::time_point time) const;
  std::uint64_t time_of(const LogEntry& entry) const;

  const config::DaemonConfig& config_;
  roomba::SensorLoop& sensor_loop_;
  Wiring& wiring_;
  std::int64_t unix_minus_steady_ns_;
  boost::asio::io_context context_{1};
  boost::asio::steady_timer timer_{context_};
  std::shared_ptr<MessageSink> messages_ = std::make_shared<MessageSink>();
  std::unique_ptr<Server> server_;

  Scene scene_;
  std::optional<TruthTrail> truth_;
  std::optional<Message> last_truth_;
  std::optional<LogEntry> last_;
  std::deque<Message> last_messages_;
  std::string result_;
  std::string outcome_;
  CountedNotice stops_{std::chrono::seconds(5)};
  CountedNotice failures_{std::chrono::seconds(5)};
  std::string last_stop_by_;
  std::uint64_t ticks_ = 0;
  std::uint64_t wake_ups_ = 0;
  std::uint64_t truths_ = 0;
  std::uint64_t every_ = 1;  // of so many ticks one is sent
  std::chrono::nanoseconds latest_wake_up_{0};
  std::chrono::steady_clock::time_point next_scene_;
  std::chrono::steady_clock::time_point next_state_;
  bool state_changed_ = true;
};

}  // namespace wheelwright::daemon::telemetry
