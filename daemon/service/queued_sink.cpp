#include "daemon/service/queued_sink.hpp"

#include <pthread.h>
#include <spdlog/details/log_msg.h>
#include <spdlog/fmt/fmt.h>
#include <sys/signal.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace wheelwright::daemon {
// Shared with the thread, which may outlive the sink.
struct QueuedSink::Queue {
  struct Message {
    spdlog::log_clock::time_point time;
    spdlog::level::level_enum level = spdlog::level::info;
    std::string text;
  };

  std::shared_ptr<spdlog::sinks::sink> target;
  std::size_t capacity = 0;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Message> messages;
  std::size_t dropped = 0;
  bool writing = false;
  bool ending = false;

  void run();
  void write(const Message& message) const;
};

void QueuedSink::Queue::write(const Message& message) const {
  try {
    target->log({message.time, {}, {}, message.level, message.text});
    target->flush();
  } catch (const std::exception&) {
    return;  // nobody is there to read that either
  }
}

void QueuedSink::Queue::run() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [this] { return ending || !messages.empty(); });
    if (messages.empty()) return;
    const Message next = std::move(messages.front());
    messages.pop_front();
    const std::size_t lost = messages.empty() ? std::exchange(dropped, 0) : 0;
    writing = true;
    lock.unlock();
    write(next);
    if (lost > 0) {
      write({next.time, spdlog::level::warn,
             fmt::format("{} messages were dropped: standard error or the journal did not take them in time",
                         lost)});
    }
    lock.lock();
    writing = false;
    changed.notify_all();
  }
}

QueuedSink::QueuedSink(std::shared_ptr<spdlog::sinks::sink> target, std::size_t capacity)
    : queue_(std::make_shared<Queue>()) {
  queue_->target = std::move(target);
  queue_->capacity = capacity;
  // The thread takes no signal: those of the daemon go to its supervisor.
  sigset_t all{};
  sigset_t before{};
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    std::thread([queue = queue_] { queue->run(); }).detach();
  } catch (...) {
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

QueuedSink::~QueuedSink() {
  const std::lock_guard lock(queue_->mutex);
  queue_->ending = true;
  queue_->changed.notify_all();
}

void QueuedSink::log(const spdlog::details::log_msg& message) {
  const std::lock_guard lock(queue_->mutex);
  if (queue_->messages.size() >= queue_->capacity) {
    ++queue_->dropped;
    return;
  }
  queue_->messages.push_back({message.time, message.level, {message.payload.data(), message.payload.size()}});
  queue_->changed.notify_all();
}

void QueuedSink::set_pattern(const std::string& pattern) {
  queue_->target->set_pattern(pattern);
}

void QueuedSink::set_formatter(std::unique_ptr<spdlog::formatter> formatter) {
  queue_->target->set_formatter(std::move(formatter));
}

bool QueuedSink::drain(std::chrono::milliseconds patience) {
  std::unique_lock lock(queue_->mutex);
  return queue_->changed.wait_for(lock, patience,
                                  [this] { return queue_->messages.empty() && !queue_->writing; });
}

}  // namespace wheelwright::daemon
