// One thread of another process, held still as if it hung; the other threads go on.
#pragma once

#include <sys/types.h>

#include <string>

namespace wheelwright::bench {

class HeldThread {
 public:
  // By the thread's name (pthread_setname_np). Converts to false where there is no such thread or the system
  // does not allow it. The thread goes on when this object goes.
  HeldThread(pid_t process, const std::string& name);
  HeldThread(const HeldThread&) = delete;
  HeldThread& operator=(const HeldThread&) = delete;
  ~HeldThread();

  explicit operator bool() const { return thread_ > 0; }

 private:
  pid_t thread_ = -1;
};

}  // namespace wheelwright::bench
