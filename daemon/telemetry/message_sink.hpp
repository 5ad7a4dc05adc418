// Catches what the daemon says in its log, for the live view. The threads that drive never log.
#pragma once

#include <spdlog/sinks/base_sink.h>

#include <chrono>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace wheelwright::daemon::telemetry {

class MessageSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  struct Line {
    std::chrono::system_clock::time_point at;
    spdlog::level::level_enum level;
    std::string text;
  };

  // What has been said since the last call.
  std::vector<Line> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(lines_, {});
  }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (lines_.size() >= max_lines) return;
    lines_.push_back({message.time, message.level, {message.payload.data(), message.payload.size()}});
  }
  void flush_() override {}

 private:
  static constexpr std::size_t max_lines = 1000;
  std::vector<Line> lines_;
};

}  // namespace wheelwright::daemon::telemetry
