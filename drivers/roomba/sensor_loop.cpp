#include "drivers/roomba/sensor_loop.hpp"

#include <utility>  // Boost.Asio 1.74 needs it and does not say so

#include <time.h>
#include <unistd.h>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>

#include <algorithm>
#include <cerrno>

#include "drivers/roomba/rest_bytes.hpp"

namespace wheelwright::roomba {
namespace {

namespace asio = boost::asio;
using std::chrono::steady_clock;

// The timer wakes so much before a deadline, and the rest is slept to the nanosecond: Asio's own way to a
// deadline costs some 40 us more (a timerfd in whole microseconds, behind epoll).
constexpr auto wake_ahead = std::chrono::microseconds(300);

void sleep_until(steady_clock::time_point deadline) {
  const auto since = deadline.time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(since);
  const timespec wake{seconds.count(), std::chrono::nanoseconds(since - seconds).count()};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) continue;
}

}  // namespace

struct SensorLoop::Io {
  asio::io_context context{1};
  asio::posix::stream_descriptor port{context};
  asio::steady_timer timer{context};
};

SensorLoop::SensorLoop(const SensorLoopConfig& config, const serial::OpenPort& first_port, LoopClient& client,
                       PortGuard* guard)
    : config_(config),
      client_(client),
      guard_(guard),
      link_(config.link),
      io_(std::make_unique<Io>()),
      period_(std::chrono::nanoseconds(std::llround(1e9 * config.link.period_s))),
      reopening_(config.link.period_s),
      encoder_order_(config.link.encoder_order) {
  adopt(first_port);
}

SensorLoop::~SensorLoop() = default;

LoopCounts SensorLoop::counts() const {
  return {counts_.ticks.value(),          counts_.overruns.value(),      counts_.skipped_periods.value(),
          counts_.writes_held_up.value(), counts_.commands_late.value(), counts_.sound_readings.value()};
}

double SensorLoop::now_s() const {
  return std::chrono::duration<double>(steady_clock::now().time_since_epoch()).count();
}

void SensorLoop::run() {
  started_ = steady_clock::now();
  deadline_ = started_ + period_;
  start_reading();
  wait_for_tick();
  io_->context.run();
  if (!io_->port.is_open()) return;
  // The robot obeys the last command for ever: whole, in order, and drained before the port is closed.
  flush_held_up();
  write(link_.farewell_bytes());
  for (int i = 0; i < 10 && !flush_held_up(); ++i) ::usleep(5000);
  close_port();
  if (guard_ != nullptr) guard_->port_closed();
}

// A running stream is the clock; the timer then only notices its silence.
steady_clock::time_point SensorLoop::timer_due() const {
  const bool streaming = config_.link.transport == Transport::stream && link_.state() == LinkState::running;
  return streaming ? deadline_ + period_ : deadline_ - wake_ahead;
}

void SensorLoop::wait_for_tick() {
  io_->timer.expires_at(timer_due());
  io_->timer.async_wait([this](const boost::system::error_code& error) {
    if (!error) on_timer();
  });
}

void SensorLoop::on_timer() {
  // A frame has come since the wait began. Were the wait begun again with each frame, Asio would need memory
  // for the old and the new one.
  if (steady_clock::now() < timer_due()) {
    wait_for_tick();
    return;
  }
  if (config_.link.transport == Transport::query) {
    sleep_until(deadline_);
    note_lateness(steady_clock::now() - deadline_);
  }
  skip_missed_periods();
  tick_due_ = deadline_;
  begun_late_ = steady_clock::now() - tick_due_;
  tick();
  if (config_.link.transport == Transport::stream) {
    stream_clock_.silence();
    if (tick_open_) finish_tick(nullptr);
  }
  deadline_ += period_;
  if (!ending_) wait_for_tick();
}

void SensorLoop::note_lateness(std::chrono::nanoseconds lateness) {
  lateness_.add(lateness);
  silence_watch_.woke_up(lateness);
  client_.on_wake_up(deadline_, lateness);
}

// After an overrun the loop goes on at the next whole period: phase is kept, what was missed is counted.
void SensorLoop::skip_missed_periods() {
  const auto late = steady_clock::now() - deadline_;
  if (late < period_ || config_.link.transport == Transport::stream) return;
  const auto missed = late / period_;
  counts_.overruns.add();
  counts_.skipped_periods.add(missed);
  if (tick_open_) finish_tick(nullptr);
  tick_ += missed;
  deadline_ += missed * period_;
  report(EventCode::overrun, static_cast<double>(missed));
}

void SensorLoop::tick() {
  if (tick_open_) finish_tick(nullptr);
  take_requests();
  if (ending_) {
    io_->context.stop();
    return;
  }
  reopen_if_due();
  begin_tick();
}

void SensorLoop::take_requests() {
  const bool arm = arm_requested_.exchange(false, std::memory_order_relaxed);
  if (end_requested_.load(std::memory_order_relaxed)) {
    end_when_standing();
  } else if (arm) {
    arm_if_there();
  }
  const StopReason stop = stop_requested_.exchange(StopReason::none, std::memory_order_relaxed);
  if (stop != StopReason::none) link_.stop(stop);
  // The wheels stand by another hand, and the plan has gone on without them.
  if (guard_ != nullptr && guard_->has_acted() && link_.armed()) link_.stop(StopReason::stalled);
  link_.set_encoder_order(encoder_order_.load(std::memory_order_relaxed));
}

// Who arms a robot that does not answer is not to see it drive off minutes later, when somebody switches it
// on.
void SensorLoop::arm_if_there() {
  if (link_.armed() && !link_.stands()) {
    report(EventCode::arm_needless, 0.0);
  } else if (link_.state() == LinkState::running) {
    link_.arm();
  } else {
    report(EventCode::arm_refused, 0.0);
  }
}

// A robot brakes only while it obeys; sent to Passive at speed it would roll on for half a second.
void SensorLoop::end_when_standing() {
  if (!end_by_tick_) {
    end_by_tick_ = tick_ + std::llround(longest_braking_s / config_.link.period_s);
    if (!link_.disarmed() && !(link_.armed() && link_.stands())) link_.stop(StopReason::requested);
  }
  ending_ = link_.state() != LinkState::running || link_.stands() || tick_ >= *end_by_tick_;
}

void SensorLoop::begin_tick() {
  ++tick_;
  counts_.ticks.add();
  if (guard_ != nullptr) guard_->beat();
  tick_open_ = true;
  write(link_.begin_tick(tick_, now_s(), client_.command_for(tick_)));
}

void SensorLoop::finish_tick(const open_interface::Reading* reading) {
  tick_open_ = false;
  SensorFrame frame = link_.complete_tick(reading);
  if (reading != nullptr) frame.late_us = lateness_of_reply_us();
  if (frame.valid) counts_.sound_readings.add();
  note_silence(frame.valid);
  counts_.commands_late.set(static_cast<std::int64_t>(link_.counts().late_commands));
  write(link_.urgent_bytes());
  client_.on_frame(frame);
  report_changes();
}

// A frame of the stream is of its own moment by the robot's clock, however late it comes: adapters hand over
// two and more at once.
std::int32_t SensorLoop::lateness_of_reply_us() {
  if (config_.link.transport == Transport::stream) return 0;
  const std::chrono::nanoseconds taken = steady_clock::now() - tick_due_;
  quickest_reply_ = std::min(quickest_reply_, taken);
  const auto late = std::max(begun_late_, taken - quickest_reply_ - held_by_adapter_);
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(late / std::chrono::microseconds(1), 0, largest_late_us));
}

void SensorLoop::note_silence(bool received) {
  const auto skipped = counts_.skipped_periods.value();
  if (received) silence_watch_.received(skipped, link_.reply_counts());
  if (link_.stop_reason() == StopReason::blind && reported_stop_ != StopReason::blind) {
    silence_ = silence_watch_.until(skipped, link_.reply_counts());
  }
}

void SensorLoop::start_reading() {
  if (!io_->port.is_open()) return;
  io_->port.async_read_some(asio::buffer(input_),
                            [this](const boost::system::error_code& error, std::size_t count) {
                              if (error == asio::error::operation_aborted) return;
                              if (error || count == 0) {
                                drop_port();
                                return;
                              }
                              on_bytes(count);
                              start_reading();
                            });
}

void SensorLoop::on_bytes(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto reading = link_.receive(input_.at(i))) on_reading(*reading);
  }
}

void SensorLoop::on_reading(const open_interface::Reading& reading) {
  if (config_.link.transport == Transport::query) {
    if (tick_open_) finish_tick(&reading);
    return;
  }
  make_up_for_damage();
  if (ending_) return;
  note_lateness(std::max(steady_clock::now() - deadline_, steady_clock::duration::zero()));
  tick();
  if (ending_) return;
  finish_tick(&reading);
  deadline_ = steady_clock::now() + period_;
}

// A damaged frame is a period without a reading.
void SensorLoop::make_up_for_damage() {
  const bool was_measured = stream_clock_.period_s().has_value();
  const auto missing = stream_clock_.frame(now_s(), link_.damaged_frames_before());
  for (std::int64_t i = 0; i < missing && !ending_; ++i) {
    tick();
    if (!ending_) finish_tick(nullptr);
  }
  if (const auto measured_s = stream_clock_.period_s(); measured_s && !was_measured) {
    report(EventCode::stream_period, *measured_s);
    if (is_another_period(*measured_s, config_.link.period_s)) link_.stop(StopReason::other_period);
  }
}

bool SensorLoop::flush_held_up() {
  if (held_up_size_ == 0) return true;
  const ssize_t written = ::write(io_->port.native_handle(), held_up_.data(), held_up_size_);
  if (written <= 0) return false;
  const auto done = static_cast<std::size_t>(written);
  std::shift_left(held_up_.begin(), held_up_.begin() + static_cast<std::ptrdiff_t>(held_up_size_), written);
  held_up_size_ -= done;
  return held_up_size_ == 0;
}

// A command goes out whole or, if the port takes only part of it now, its rest goes out before anything else.
void SensorLoop::write(std::span<const std::uint8_t> bytes) {
  if (bytes.empty() || !io_->port.is_open()) return;
  if (!flush_held_up()) {
    drop_port();
    return;
  }
  ssize_t written = ::write(io_->port.native_handle(), bytes.data(), bytes.size());
  if (written < 0 && errno != EAGAIN && errno != EINTR) {
    drop_port();
    return;
  }
  written = std::max<ssize_t>(written, 0);
  const auto rest = bytes.subspan(static_cast<std::size_t>(written));
  if (rest.empty()) return;
  counts_.writes_held_up.add();
  std::copy(rest.begin(), rest.end(), held_up_.begin());
  held_up_size_ = rest.size();
}

void SensorLoop::adopt(const serial::OpenPort& port) {
  io_->port.assign(port.descriptor);
  held_up_size_ = 0;
  stream_clock_ = {};
  held_by_adapter_ = std::chrono::milliseconds(port.latency_timer_ms.value_or(0));
  link_.port_opened();
  if (guard_ != nullptr) guard_->port_opened(port.descriptor);
}

void SensorLoop::close_port() {
  boost::system::error_code ignored;
  io_->port.close(ignored);
}

void SensorLoop::drop_port() {
  if (!io_->port.is_open()) return;
  close_port();
  if (guard_ != nullptr) guard_->port_dropped();
  link_.stop(StopReason::link_lost);
  link_.port_closed();
  reopening_.closed(tick_);
}

void SensorLoop::reopen_if_due() {
  if (link_.state() == LinkState::lost) drop_port();
  if (link_.state() != LinkState::closed || !reopening_.due(tick_)) return;
  const auto port = serial::open_port(config_.device, config_.baud);
  if (port) {
    adopt(*port);
    start_reading();
    report(EventCode::port_opened, 0.0);
    return;
  }
  reopening_.failed(tick_);
}

void SensorLoop::report_changes() {
  if (link_.state() != reported_state_) {
    if (link_.state() == LinkState::running) {
      report(EventCode::robot_answers, 1e-3 * link_.last_reading().voltage_mv);
    }
    if (reported_state_ == LinkState::running) report(EventCode::link_lost, 0.0);
    reported_state_ = link_.state();
  }
  if (link_.armed() != reported_armed_) {
    reported_armed_ = link_.armed();
    if (reported_armed_) report(EventCode::armed, 0.0);
  }
  if (link_.stop_reason() != reported_stop_) {
    reported_stop_ = link_.stop_reason();
    if (reported_stop_ != StopReason::none) report(EventCode::stopped, static_cast<double>(reported_stop_));
  }
  if (!reported_rule_ && link_.checksum_rule() != open_interface::ChecksumRule::unknown) {
    reported_rule_ = true;
    report(EventCode::checksum_rule, static_cast<double>(link_.checksum_rule()));
  }
  const LinkCounts& counts = link_.counts();
  if (counts.times_moved_unarmed != reported_unarmed_motion_) {
    reported_unarmed_motion_ = counts.times_moved_unarmed;
    report(EventCode::moves_unarmed, 0.0);
  }
  if (counts.stuck_bits != reported_stuck_bits_) {
    reported_stuck_bits_ = counts.stuck_bits;
    if (counts.stuck_bits != 0) report(EventCode::counts_stuck, counts.stuck_bits);
  }
  if (const auto text = link_.stray_text().finished(); !text.empty()) {
    report(EventCode::robot_text, 0.0, text);
    link_.stray_text().discard();
  }
}

void SensorLoop::report(EventCode code, double value, std::string_view text) {
  Event event;
  event.t_s = static_cast<double>(tick_) * config_.link.period_s;
  event.code = code;
  event.value = value;
  std::copy_n(text.begin(), std::min(text.size(), event.text.size() - 1), event.text.begin());
  client_.on_event(event);
}

}  // namespace wheelwright::roomba
