// What a service manager is told, by the protocol of sd_notify(3): datagrams of KEY=value lines.
//
// Some thirty lines of our own, so that the daemon needs no libsystemd on boards that have none.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace wheelwright::daemon {

class ServiceNotifier {
 public:
  // Takes NOTIFY_SOCKET and WATCHDOG_USEC from the environment. Without them every call does nothing.
  ServiceNotifier();
  ServiceNotifier(const ServiceNotifier&) = delete;
  ServiceNotifier& operator=(const ServiceNotifier&) = delete;
  ~ServiceNotifier();

  // Once: the service has started.
  void ready();
  // One line for people; sent where it differs from the last one.
  void status(const std::string& line);
  // `progress` is the sensor loop's own count of ticks. Feeds the watchdog as long as it moves, and not
  // otherwise.
  void feed(std::int64_t progress);
  // The end has begun.
  void stopping();

  // The watchdog wants to hear of the loop within this time; nothing where there is none.
  std::optional<std::chrono::microseconds> watchdog() const { return watchdog_; }

 private:
  void send(const std::string& text);

  int socket_ = -1;
  std::optional<std::chrono::microseconds> watchdog_;
  std::chrono::steady_clock::time_point last_feed_;
  std::int64_t last_progress_ = -1;
  std::string last_status_;
  bool ready_ = false;
};

}  // namespace wheelwright::daemon
