#include "drivers/simulation/faulty_bridge.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <span>
#include <utility>

namespace wheelwright::simulation {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr std::size_t received = 30;  // bytes: most of a reply

double seconds(std::chrono::nanoseconds time) {
  return duration<double>(time).count();
}

}  // namespace

FaultyBridge::FaultyBridge(int robot, std::filesystem::path link, const CableFaultConfig& config)
    : robot_(robot),
      path_(std::move(link)),
      cable_(config),
      started_(steady_clock::now()),
      started_unix_s_(duration<double>(std::chrono::system_clock::now().time_since_epoch()).count()) {
  plug(true);
}

std::chrono::nanoseconds FaultyBridge::now() const {
  return steady_clock::now() - started_;
}

void FaultyBridge::plug(bool in) {
  link_.reset();
  terminal_.reset();
  if (!in) return;
  terminal_ = std::make_unique<PseudoTerminal>();
  link_ = std::make_unique<TerminalLink>(path_, terminal_->path());
}

bool FaultyBridge::carry() {
  const auto time = now();
  if (cable_.connected(time) != (terminal_ != nullptr)) plug(terminal_ == nullptr);
  const bool there = carry_to_robot(time) && carry_to_host(time);
  note_finished(time);
  return there;
}

bool FaultyBridge::carry_to_robot(std::chrono::nanoseconds now) {
  std::array<std::uint8_t, 1024> buffer{};
  while (const std::size_t count = terminal_ ? terminal_->read(buffer) : 0) {
    cable_.put(Direction::to_robot, std::span(buffer).first(count), now);
  }
  while (const std::size_t count = cable_.take(Direction::to_robot, buffer, now)) {
    const ssize_t written = ::write(robot_, buffer.data(), count);
    if (written < 0 && errno != EAGAIN && errno != EINTR) return false;
  }
  return true;
}

bool FaultyBridge::carry_to_host(std::chrono::nanoseconds now) {
  std::array<std::uint8_t, 1024> buffer{};
  ssize_t count = 0;
  while ((count = ::read(robot_, buffer.data(), buffer.size())) > 0) {
    cable_.put(Direction::to_host, std::span(buffer).first(static_cast<std::size_t>(count)), now);
  }
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) return false;
  while (const std::size_t arrived = cable_.take(Direction::to_host, buffer, now)) {
    if (terminal_) terminal_->write(std::span(buffer).first(arrived));
    received_bytes_ += arrived;
  }
  return true;
}

void FaultyBridge::note_finished(std::chrono::nanoseconds now) {
  if (waiting_ && received_bytes_ >= received) {
    waiting_->answered_after_s = seconds(now) + started_unix_s_ - waiting_->until_unix_s;
    finished_.push_back(*std::exchange(waiting_, std::nullopt));
  }
  while (const auto record = cable_.next_finished()) {
    if (waiting_) finished_.push_back(*waiting_);
    waiting_ = BridgeFault{.record = *record,
                           .from_unix_s = started_unix_s_ + seconds(record->fault.from),
                           .until_unix_s = started_unix_s_ + seconds(now)};
    received_bytes_ = 0;
  }
}

std::optional<BridgeFault> FaultyBridge::next_finished() {
  if (finished_.empty()) return std::nullopt;
  const BridgeFault fault = finished_.front();
  finished_.pop_front();
  return fault;
}

}  // namespace wheelwright::simulation
