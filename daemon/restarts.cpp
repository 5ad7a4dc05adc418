#include "daemon/restarts.hpp"

#include <algorithm>
#include <fstream>
#include <string>

namespace wheelwright::daemon {
namespace {

constexpr int longest_back_off_s = 60;

void write_number(const std::filesystem::path& file, int number) {
  if (!file.empty()) std::ofstream(file) << number << '\n';
}

}  // namespace

Restarts::Restarts(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  attempts_file_ = folder / "attempts";
  armed_file_ = folder / "armed";
  std::ifstream(attempts_file_) >> attempts_before_;
  std::error_code ignored;
  was_armed_ = std::filesystem::exists(armed_file_, ignored);
  write_number(attempts_file_, attempts_before_ + 1);
}

std::chrono::seconds Restarts::back_off() const {
  if (attempts_before_ <= 1) return std::chrono::seconds(0);
  return std::chrono::seconds(std::min(1 << std::min(attempts_before_ - 2, 10), longest_back_off_s));
}

void Restarts::armed() {
  write_number(armed_file_, 1);
}

void Restarts::lasted() {
  if (!lasted_) write_number(attempts_file_, 0);
  lasted_ = true;
}

void Restarts::ended_in_order() {
  std::error_code ignored;
  for (const auto& file : {attempts_file_, armed_file_}) {
    if (!file.empty()) std::filesystem::remove(file, ignored);
  }
}

}  // namespace wheelwright::daemon
