// The sensor loop: a Roomba on a serial port, one tick after the other. Queries go out on absolute deadlines;
// a stream of the robot is its own clock, and a timer only notices its silence.
//
// One thread calls run() and owns port, timer and tick; nothing else is posted to it. What it has to say it
// says through LoopClient, whose functions are called on that thread and must neither block nor allocate.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "drivers/roomba/lateness_histogram.hpp"
#include "drivers/roomba/port_guard.hpp"
#include "drivers/roomba/reopen_schedule.hpp"
#include "drivers/roomba/roomba_link.hpp"
#include "drivers/roomba/silence.hpp"
#include "drivers/roomba/stream_clock.hpp"
#include "drivers/serial/serial_port.hpp"

namespace wheelwright::roomba {

enum class EventCode : std::uint8_t {
  port_opened,
  robot_answers,  // value: battery voltage
  link_lost,
  robot_text,  // text: what the robot printed by itself
  armed,
  arm_refused,    // the robot does not answer
  arm_needless,   // it is armed and drives
  stopped,        // value: StopReason
  overrun,        // value: periods that were skipped
  checksum_rule,  // value: ChecksumRule
  stream_period,  // value: seconds between frames, as measured
  moves_unarmed,  // the wheels turn though nobody has ordered it
  counts_stuck,   // value: bits of the encoder counts that never change; the line loses them
};

// Something that happened in the loop, for a log that is written elsewhere.
struct Event {
  double t_s = 0.0;
  EventCode code{};
  double value = 0.0;
  std::array<char, 96> text{};
};

class LoopClient {
 public:
  virtual ~LoopClient() = default;
  // The command of a tick, or nothing where none has come in time.
  virtual std::optional<Command> command_for(std::int64_t tick) = 0;
  virtual void on_frame(const SensorFrame& frame) = 0;
  virtual void on_event(const Event& event) = 0;
  // The loop has woken up for a tick, or a frame of the stream has come, so much after it was due.
  virtual void on_wake_up(std::chrono::steady_clock::time_point /*due*/, std::chrono::nanoseconds /*late*/) {}
};

// What the loop counted so far.
struct LoopCounts {
  std::int64_t ticks = 0;
  std::int64_t overruns = 0;         // wake-ups that came a period or more late
  std::int64_t skipped_periods = 0;  // periods lost to them
  std::int64_t writes_held_up = 0;   // writes that the port did not take whole at once
  std::int64_t commands_late = 0;    // ticks at which no command had come in time
  std::int64_t sound_readings = 0;
};

struct SensorLoopConfig {
  LinkConfig link;
  std::filesystem::path device;
  int baud = 115200;
};

class SensorLoop {
 public:
  // `first_port` is the port as it was opened at start-up (so that a missing device is an error there).
  // Without a guard nobody stops the wheels when this process cannot.
  SensorLoop(const SensorLoopConfig& config, const serial::OpenPort& first_port, LoopClient& client,
             PortGuard* guard = nullptr);
  ~SensorLoop();

  // Loops until request_end(), then puts the wheels to rest and leaves the robot in Off mode. Where an
  // exception leaves it, the guard has to stop the wheels. Where the port is closed at the end there is no
  // way to the robot: nothing is sent, and the state of the link is not `running`.
  void run();

  // From any thread or signal handler; take effect with the next tick. Only a robot that answers is armed.
  void request_end() { end_requested_.store(true, std::memory_order_relaxed); }
  void request_arm() { arm_requested_.store(true, std::memory_order_relaxed); }
  void request_stop(StopReason reason) { stop_requested_.store(reason, std::memory_order_relaxed); }
  void request_encoder_order(EncoderOrder order) { encoder_order_.store(order, std::memory_order_relaxed); }

  // From any thread. The ticks advance whether or not there is a robot: a watchdog's food.
  LoopCounts counts() const;
  const LatenessHistogram& lateness() const { return lateness_; }

  // After run() has returned, or from the loop's own thread.
  const RoombaLink& link() const { return link_; }
  // How it came to the stop for want of a sound reading (StopReason::blind), the last time.
  const std::optional<Silence>& silence() const { return silence_; }

 private:
  struct Io;

  std::chrono::steady_clock::time_point timer_due() const;
  void wait_for_tick();
  void on_timer();
  void start_reading();
  void on_bytes(std::size_t count);
  void on_reading(const open_interface::Reading& reading);
  void tick();
  void begin_tick();
  void finish_tick(const open_interface::Reading* reading);
  void note_lateness(std::chrono::nanoseconds lateness);
  void note_silence(bool received);
  std::int32_t lateness_of_reply_us();
  void skip_missed_periods();
  void take_requests();
  void arm_if_there();
  void end_when_standing();
  void write(std::span<const std::uint8_t> bytes);
  bool flush_held_up();
  void adopt(const serial::OpenPort& port);
  void close_port();
  void drop_port();
  void reopen_if_due();
  void report_changes();
  void report(EventCode code, double value, std::string_view text = {});
  void make_up_for_damage();
  double now_s() const;

  SensorLoopConfig config_;
  LoopClient& client_;
  PortGuard* guard_;
  RoombaLink link_;
  std::unique_ptr<Io> io_;
  std::chrono::nanoseconds period_;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point deadline_;
  std::int64_t tick_ = -1;
  std::chrono::steady_clock::time_point tick_due_;
  std::chrono::nanoseconds begun_late_{};
  std::chrono::nanoseconds quickest_reply_ = std::chrono::nanoseconds::max();
  std::chrono::nanoseconds held_by_adapter_{};  // for so long at most, whatever the machine does
  SilenceWatch silence_watch_;
  std::optional<Silence> silence_;
  bool tick_open_ = false;
  bool ending_ = false;
  std::optional<std::int64_t> end_by_tick_;

  std::array<std::uint8_t, 1024> input_{};
  std::array<std::uint8_t, 256> held_up_{};
  std::size_t held_up_size_ = 0;

  ReopenSchedule reopening_;
  LinkState reported_state_ = LinkState::closed;
  StopReason reported_stop_ = StopReason::none;
  bool reported_armed_ = false;
  bool reported_rule_ = false;
  std::uint64_t reported_unarmed_motion_ = 0;
  unsigned reported_stuck_bits_ = 0;
  StreamClock stream_clock_;

  struct {
    LoopCount ticks, overruns, skipped_periods, writes_held_up, commands_late, sound_readings;
  } counts_;
  LatenessHistogram lateness_;
  std::atomic<bool> end_requested_{false};
  std::atomic<bool> arm_requested_{false};
  std::atomic<StopReason> stop_requested_{StopReason::none};
  std::atomic<EncoderOrder> encoder_order_;
};

}  // namespace wheelwright::roomba
