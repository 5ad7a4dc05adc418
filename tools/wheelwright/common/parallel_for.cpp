#include "tools/wheelwright/common/parallel_for.hpp"

#include <malloc.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace wheelwright::tools {
namespace {

// Threads that share all batches of jobs, also those that a job itself hands out: whoever is through with its
// own, or waits for the last ones of its batch, takes one of the newest batch that has any.
class ThreadPool {
 public:
  explicit ThreadPool(std::size_t helpers) {
    for (std::size_t i = 0; i < helpers; ++i) {
      helpers_.emplace_back([this](const std::stop_token& stop) { help(stop); });
    }
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& job) {
    Batch batch{count, job};
    std::unique_lock lock(mutex_);
    open_.push_back(&batch);
    changed_.notify_all();
    while (batch.done < batch.count) {
      if (const auto next = take()) {
        work(*next, lock);
      } else {
        changed_.wait(lock, [&] { return batch.done == batch.count || !open_.empty(); });
      }
    }
    if (batch.failure) std::rethrow_exception(batch.failure);
  }

 private:
  struct Batch {
    std::size_t count;
    const std::function<void(std::size_t)>& job;
    std::size_t taken = 0;
    std::size_t done = 0;
    std::exception_ptr failure{};
  };
  struct Job {
    Batch* batch;
    std::size_t number;
  };

  void help(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return !open_.empty(); })) work(*take(), lock);
  }

  // With the mutex held. A batch is open as long as it has jobs that nobody has taken.
  std::optional<Job> take() {
    if (open_.empty()) return std::nullopt;
    Batch* batch = open_.back();
    const Job job{batch, batch->taken++};
    if (batch->taken == batch->count) open_.pop_back();
    return job;
  }

  // The mutex is held but for the work itself. Once its last job is done, a batch may be gone.
  void work(const Job& job, std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    std::exception_ptr failure;
    try {
      job.batch->job(job.number);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure && !job.batch->failure) job.batch->failure = failure;
    if (++job.batch->done == job.batch->count) changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<Batch*> open_;
  std::vector<std::jthread> helpers_;
};

// Every free run takes and frees the same long arrays: had the system them back each time, a part of all time
// would go into that.
void keep_freed_memory() {
  constexpr int max_of_one_array = 32 << 20;  // more is refused
  constexpr int max_at_rest = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, max_of_one_array);
  mallopt(M_TRIM_THRESHOLD, max_at_rest);
}

}  // namespace

gap::ParallelFor parallel_for() {
  keep_freed_memory();
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const auto pool = std::make_shared<ThreadPool>(cores - 1);
  return [pool, cores](std::size_t count, const std::function<void(std::size_t)>& job) {
    if (cores < 2 || count < 2) return gap::serial_for(count, job);
    pool->run(count, job);
  };
}

}  // namespace wheelwright::tools
