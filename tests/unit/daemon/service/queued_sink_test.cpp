#include "daemon/service/queued_sink.hpp"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

using wheelwright::daemon::QueuedSink;
using namespace std::chrono_literals;

namespace {

// Takes nothing until it is opened, as a pipe that nobody reads.
class Gate final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  void open() { opened_.set_value(); }
  std::vector<std::string> lines() {
    const std::lock_guard lock(mutex_);
    return lines_;
  }

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (lines_.empty()) opened_.get_future().wait();
    lines_.emplace_back(message.payload.data(), message.payload.size());
  }
  void flush_() override {}

  std::promise<void> opened_;
  std::vector<std::string> lines_;
};

}  // namespace

TEST_CASE("Who logs does not wait for who reads, and what was dropped is counted") {
  const auto gate = std::make_shared<Gate>();
  const auto queue = std::make_shared<QueuedSink>(gate, 8);
  spdlog::logger logger("test", queue);
  for (int i = 0; i < 1000; ++i) logger.info("message {}", i);
  CHECK_FALSE(queue->drain(20ms));
  gate->open();
  REQUIRE(queue->drain(10s));
  const auto lines = gate->lines();
  // The queue, and the message that its thread may have taken out before it was full.
  const std::size_t kept = lines.size() - 1;
  CHECK((kept == 8 || kept == 9));
  CHECK(lines.front() == "message 0");
  CHECK(lines.back().starts_with(std::to_string(1000 - kept) + " messages were dropped"));
}

TEST_CASE("Messages keep their order, and all are written before a drain ends") {
  const auto gate = std::make_shared<Gate>();
  gate->open();
  const auto queue = std::make_shared<QueuedSink>(gate, 1000);
  spdlog::logger logger("test", queue);
  for (int i = 0; i < 500; ++i) logger.info("message {}", i);
  REQUIRE(queue->drain(10s));
  const auto lines = gate->lines();
  REQUIRE(lines.size() == 500);
  CHECK(lines[123] == "message 123");
  CHECK(lines[499] == "message 499");
}

TEST_CASE("A queue whose sink hangs does not hold up its own end") {
  const auto gate = std::make_shared<Gate>();
  {
    spdlog::logger logger("test", std::make_shared<QueuedSink>(gate, 8));
    logger.info("nobody reads this");
  }
  gate->open();
  SUCCEED("ended");
}
