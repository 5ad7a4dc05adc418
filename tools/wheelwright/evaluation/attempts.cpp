#include "tools/wheelwright/evaluation/attempts.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

namespace wheelwright::tools {
namespace {

class Attempts {
 public:
  Attempts(const EvaluationPlan& plan, std::size_t count, const Progress& progress)
      : plan_(plan), progress_(progress), outcomes_(count) {}

  // Takes attempts until none is left.
  void work() {
    while (const auto number = take()) {
      try {
        const AttemptOutcome outcome = run_attempt(plan_, *number);
        const std::lock_guard lock(mutex_);
        outcomes_[*number] = outcome;
        if (progress_) progress_(++done_);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        error_ = std::current_exception();
      }
    }
  }

  std::vector<AttemptOutcome> result() {
    if (error_) std::rethrow_exception(error_);
    return std::move(outcomes_);
  }

 private:
  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    if (error_ || next_ == outcomes_.size()) return std::nullopt;
    return next_++;
  }

  const EvaluationPlan& plan_;
  const Progress& progress_;
  std::mutex mutex_;
  std::vector<AttemptOutcome> outcomes_;
  std::exception_ptr error_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
};

}  // namespace

std::vector<AttemptOutcome> run_attempts(const EvaluationPlan& plan, std::size_t count, unsigned threads,
                                         const Progress& progress) {
  Attempts attempts(plan, count, progress);
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) {
      workers.emplace_back([&attempts] { attempts.work(); });
    }
    attempts.work();
  }
  return attempts.result();
}

}  // namespace wheelwright::tools
