#include "drivers/simulation/faulty_cable.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/simulation/misread_byte.hpp"
#include "drivers/simulation/serial_line.hpp"

namespace wheelwright::simulation {
namespace {

constexpr Nanoseconds pause_between_packets{5'000'000};
constexpr std::size_t max_held_back = 4096;   // bytes: what a host's or converter's buffer takes
constexpr double noise_bytes_per_s = 5000.0;  // in a silent line, where every byte is noise

}  // namespace

FaultyCable::FaultyCable(const CableFaultConfig& config)
    : sequence_(config), noise_(config.seed ^ 0xcab1eULL), next_(sequence_.next()) {}

void FaultyCable::put(Direction direction, std::span<const std::uint8_t> bytes, Nanoseconds now) {
  move_on(now);
  Lane& line = lane(direction);
  if (now - line.last_put > pause_between_packets) {
    line.passed_of_packet = 0;
    line.cut = false;
  }
  line.last_put = now;
  const bool late = at_work_ && (record_.fault.kind == CableFaultKind::delay ||
                                 record_.fault.kind == CableFaultKind::jitter);
  piece_delay_ = Nanoseconds::zero();
  if (late && hits(direction)) {
    const bool varies = record_.fault.kind == CableFaultKind::jitter;
    piece_delay_ = nanoseconds(record_.fault.amount * (varies ? noise_.uniform() : 1.0));
  }
  for (const std::uint8_t byte : bytes) put_byte(line, direction, byte, now);
}

std::size_t FaultyCable::take(Direction direction, std::span<std::uint8_t> out, Nanoseconds now) {
  move_on(now);
  Lane& line = lane(direction);
  const bool held_back = at_work_ && hits(direction) && record_.fault.kind == CableFaultKind::freeze;
  std::size_t count = 0;
  while (!held_back && count < out.size() && !line.bytes.empty() && line.bytes.front().due <= now) {
    out[count++] = line.bytes.front().byte;
    line.bytes.pop_front();
  }
  return count;
}

bool FaultyCable::connected(Nanoseconds now) {
  move_on(now);
  return !at_work_ || record_.fault.kind != CableFaultKind::disconnect;
}

std::optional<CableFault> FaultyCable::active(Nanoseconds now) {
  move_on(now);
  return at_work_ ? std::optional(record_.fault) : std::nullopt;
}

std::optional<CableFaultRecord> FaultyCable::next_finished() {
  if (finished_.empty()) return std::nullopt;
  const CableFaultRecord record = finished_.front();
  finished_.pop_front();
  return record;
}

void FaultyCable::move_on(Nanoseconds now) {
  if (at_work_) add_noise(std::min(now, record_.fault.until));
  if (at_work_ && now >= record_.fault.until) end();
  if (!at_work_ && !quiet_ && now >= next_.from) begin(now);
}

// Where the caller looks late, the fault comes late, and lasts as long as it was to last.
void FaultyCable::begin(Nanoseconds now) {
  CableFault fault = next_;
  fault.until += now - fault.from;
  fault.from = now;
  at_work_ = true;
  record_ = {.fault = fault};
  noise_until_ = now;
  next_ = sequence_.next();
  if (fault.kind != CableFaultKind::disconnect) return;
  for (Lane* line : {&to_robot_, &to_host_}) {
    record_.bytes_hit += static_cast<std::int64_t>(line->bytes.size());
    line->bytes.clear();
  }
}

void FaultyCable::end() {
  at_work_ = false;
  to_robot_.cut = false;
  to_host_.cut = false;
  finished_.push_back(record_);
}

bool FaultyCable::hits(Direction direction) const {
  return direction == Direction::to_robot ? record_.fault.to_robot : record_.fault.to_host;
}

void FaultyCable::append(Lane& line, std::uint8_t byte, Nanoseconds due) {
  if (line.bytes.size() >= max_held_back) return;
  // What was delayed is not overtaken.
  const Nanoseconds not_before = line.bytes.empty() ? due : std::max(due, line.bytes.back().due);
  line.bytes.push_back({not_before, byte});
}

void FaultyCable::put_byte(Lane& line, Direction direction, std::uint8_t byte, Nanoseconds now) {
  if (at_work_ && hits(direction)) {
    spoil(line, direction, byte, now);
  } else {
    append(line, byte, now);
  }
  ++line.passed_of_packet;
}

void FaultyCable::spoil(Lane& line, Direction direction, std::uint8_t byte, Nanoseconds now) {
  const CableFault& fault = record_.fault;
  bool hit = noise_.happens(fault.amount);
  switch (fault.kind) {
    case CableFaultKind::delay:
    case CableFaultKind::jitter:
      hit = true;
      append(line, byte, now + piece_delay_);
      break;
    case CableFaultKind::drop:
      if (!hit) append(line, byte, now);
      break;
    case CableFaultKind::duplicate:
      append(line, byte, now);
      if (hit) append(line, byte, now);
      break;
    case CableFaultKind::flip:
      append(line, hit ? static_cast<std::uint8_t>(byte ^ (1U << (noise_.bits() % 8U))) : byte, now);
      break;
    case CableFaultKind::burst:
      append(line, hit ? static_cast<std::uint8_t>(noise_.bits()) : byte, now);
      break;
    case CableFaultKind::freeze:
      hit = true;
      append(line, byte, now);
      break;
    case CableFaultKind::half_packet:
      line.cut = line.cut || line.passed_of_packet == std::llround(fault.amount);
      hit = line.cut;
      if (!hit) append(line, byte, now);
      break;
    case CableFaultKind::wrong_baud:
      hit = true;
      read_at_wrong_speed(line, direction, byte, now);
      break;
    case CableFaultKind::disconnect:
      hit = true;
      break;
  }
  ++(hit ? record_.bytes_hit : record_.bytes_passed);
}

void FaultyCable::read_at_wrong_speed(Lane& line, Direction direction, std::uint8_t byte, Nanoseconds now) {
  const double host_over_robot = record_.fault.amount;
  std::array<std::uint8_t, max_misread> read{};
  const double ratio = direction == Direction::to_robot ? host_over_robot : 1.0 / host_over_robot;
  const std::size_t count = misread(byte, ratio, read);
  for (std::size_t i = 0; i < count; ++i) append(line, read.at(i), now);
}

// Noise does not wait for bytes to spoil.
void FaultyCable::add_noise(Nanoseconds now) {
  const CableFault& fault = record_.fault;
  if (fault.kind != CableFaultKind::burst || now <= noise_until_) return;
  const double expected = 1e-9 * static_cast<double>((now - noise_until_).count()) * noise_bytes_per_s;
  noise_until_ = now;
  for (const auto direction : {Direction::to_robot, Direction::to_host}) {
    if (!hits(direction)) continue;
    const auto count = static_cast<int>(expected * fault.amount + noise_.uniform());
    for (int i = 0; i < count; ++i) append(lane(direction), static_cast<std::uint8_t>(noise_.bits()), now);
    record_.bytes_added += count;
  }
}

}  // namespace wheelwright::simulation
