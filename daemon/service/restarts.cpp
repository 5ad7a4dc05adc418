#include "daemon/service/restarts.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include "config/load/atomic_file.hpp"

namespace wheelwright::daemon {
namespace {

constexpr int longest_back_off_s = 60;
constexpr auto armed_note = "the process before this one ended while the robot was armed";
constexpr std::size_t longest_note = 200;

void write_number(const std::filesystem::path& file, int number) {
  if (!file.empty()) std::ofstream(file) << number << '\n';
}

// Whatever is in the note, its being there counts.
std::optional<std::string> read_note(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::symlink_status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return std::nullopt;
  if (!std::filesystem::is_regular_file(status)) return file.string() + " cannot be read";
  std::array<char, longest_note> text{};
  std::ifstream(file).read(text.data(), text.size() - 1);
  std::string line(text.data());
  line.resize(std::min(line.find('\n'), line.size()));
  const bool printable = std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; });
  return line.empty() || !printable ? std::string(armed_note) : line;
}

}  // namespace

Restarts::Restarts(const std::optional<ServiceFolders>& folders) {
  if (!folders) return;
  as_service_ = true;
  if (!folders->runtime.empty()) attempts_file_ = folders->runtime / "attempts";
  std::ifstream(attempts_file_) >> attempts_before_;
  write_number(attempts_file_, attempts_before_ + 1);
  if (folders->state.empty()) return;
  hold_file_ = folders->state / "hold";
  hold_ = read_note(hold_file_);
}

std::chrono::seconds Restarts::back_off() const {
  if (attempts_before_ <= 1) return std::chrono::seconds(0);
  return std::chrono::seconds(std::min(1 << std::min(attempts_before_ - 2, 10), longest_back_off_s));
}

std::optional<std::string> Restarts::armed() {
  if (!as_service_) return std::nullopt;
  if (hold_file_.empty()) {
    return "STATE_DIRECTORY is not set, so that nothing would remember it; the unit needs "
           "StateDirectory=wheelwright";
  }
  return config::write_file_atomically(hold_file_, std::string(armed_note) + "\n");
}

void Restarts::lasted() {
  if (!lasted_) write_number(attempts_file_, 0);
  lasted_ = true;
}

void Restarts::ended_in_order() {
  ended_in_drive();
  std::error_code ignored;
  if (!hold_file_.empty()) std::filesystem::remove(hold_file_, ignored);
}

void Restarts::ended_in_drive() {
  std::error_code ignored;
  if (!attempts_file_.empty()) std::filesystem::remove(attempts_file_, ignored);
}

}  // namespace wheelwright::daemon
