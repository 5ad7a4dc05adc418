// A bounded queue between those who log a message and those who read it.
//
// Standard error may lead to a full pipe, a terminal that is held (Ctrl-S), or a journal that hangs. Writing
// to it then blocks, and must block no thread that controls the robot or records it. So messages wait in a
// queue, and a thread of the queue's own writes them. A full queue drops what is new; how many were dropped
// is written as soon as there is room again.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include <spdlog/sinks/sink.h>

namespace wheelwright::daemon {

class QueuedSink final : public spdlog::sinks::sink {
 public:
  // Messages go to `target`, which only the queue's thread calls. Throws std::system_error where no thread
  // can be started.
  QueuedSink(std::shared_ptr<spdlog::sinks::sink> target, std::size_t capacity);
  QueuedSink(const QueuedSink&) = delete;
  QueuedSink& operator=(const QueuedSink&) = delete;
  // Does not wait: a thread that hangs in the sink is left behind, with the sink.
  ~QueuedSink() override;

  void log(const spdlog::details::log_msg& message) override;
  void flush() override {}
  // Set them before the first message.
  void set_pattern(const std::string& pattern) override;
  void set_formatter(std::unique_ptr<spdlog::formatter> formatter) override;

  // Waits until everything has been written, for `patience` at most. False where it has not.
  bool drain(std::chrono::milliseconds patience);

 private:
  struct Queue;
  std::shared_ptr<Queue> queue_;
};

}  // namespace wheelwright::daemon
