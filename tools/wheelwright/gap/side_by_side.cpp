#include "tools/wheelwright/gap/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace wheelwright::tools {
namespace {

thread_local bool at_work = false;

// One call of for-each: threads take the next number until there is none.
class Jobs {
 public:
  Jobs(std::size_t count, const std::function<void(std::size_t)>& job) : count_(count), job_(job) {}

  void work() {
    at_work = true;
    for (std::size_t i = next_++; i < count_; i = next_++) {
      try {
        job_(i);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
      }
    }
    at_work = false;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& job_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

gap::ForEach side_by_side() {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return [cores](std::size_t count, const std::function<void(std::size_t)>& job) {
    const std::size_t threads = std::min(cores, count);
    if (threads < 2 || at_work) return gap::for_each_in_turn(count, job);
    Jobs jobs(count, job);
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < threads; ++i) others.emplace_back([&jobs] { jobs.work(); });
      jobs.work();
    }
    jobs.rethrow();
  };
}

}  // namespace wheelwright::tools
