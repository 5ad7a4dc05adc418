// The time as model files, folders of runs and messages give it.
#pragma once

#include <array>
#include <chrono>
#include <ctime>
#include <string>

namespace wheelwright::config {

// UTC, ISO 8601, to the second.
inline std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 32> buffer{};
  std::strftime(buffer.data(), buffer.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return buffer.data();
}

}  // namespace wheelwright::config
