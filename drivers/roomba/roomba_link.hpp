// The link to a Roomba, without clock, port or thread: ticks and bytes in, bytes and sensor frames out.
//
// Query transport, each tick:   begin_tick -> write -> receive bytes -> complete_tick with the reading
//                               (or complete_tick without one when the next tick comes first).
// Stream transport:             receive bytes -> begin_tick -> write -> complete_tick with the reading.
//
// Safety lives here, nearest to the wheels: a bump, cliff, wheel drop, overcurrent, change of mode, charger,
// low battery, 0.25 s without a sound reading (blind_limit_s) or the fourth late command in a row stops the
// wheels in the same tick. The reason is latched; nothing moves again until arm() is called.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/open_interface/commands.hpp"
#include "drivers/open_interface/counter_bits.hpp"
#include "drivers/open_interface/encoder_counter.hpp"
#include "drivers/open_interface/query_reader.hpp"
#include "drivers/open_interface/stream_reader.hpp"
#include "drivers/roomba/link_config.hpp"
#include "drivers/roomba/unarmed_motion.hpp"
#include "model/log/sensor_frame.hpp"

namespace wheelwright::roomba {

enum class LinkState : std::uint8_t {
  closed,    // no port
  starting,  // port open, robot told to start, no sound reading yet
  running,   // readings come
  lost,      // they came and stopped; the port should be opened again
};
std::string_view name_of(LinkState state);

struct LinkCounts {
  std::uint64_t implausible = 0;    // sound replies with counts that no wheel can have made
  std::uint64_t late_commands = 0;  // ticks at which no command had come in time
  std::uint64_t times_lost = 0;
  std::uint64_t times_moved_unarmed = 0;  // beginnings of motion that nobody ordered
  unsigned stuck_bits = 0;  // of the encoder counts, since the port was opened: the line loses them
};

class RoombaLink {
 public:
  explicit RoombaLink(const LinkConfig& config);

  // The port was opened: the next tick ends whatever command was half sent, stops the wheels and starts the
  // Open Interface. Encoder counts continue from the same total with a new origin; nothing is armed.
  void port_opened();
  void port_closed();

  // Asks for the driving mode and obeys commands once the robot confirms it. Clears a latched stop.
  void arm();
  // Stops the wheels and latches the reason.
  void stop(StopReason reason);

  // Begins a tick. `command` is absent where none has come in time. Returns what to write now, valid until
  // the next call.
  std::span<const std::uint8_t> begin_tick(std::int64_t tick, double host_time_s,
                                           const std::optional<Command>& command);

  // Takes a byte that came from the robot.
  std::optional<open_interface::Reading> receive(std::uint8_t byte);

  // Ends the tick with its reading, or without one. Anything unsafe in it stops the wheels: then
  // urgent_bytes() says so.
  SensorFrame complete_tick(const open_interface::Reading* reading);

  // What has to be written at once, between ticks; empty nearly always. Valid until the next call.
  std::span<const std::uint8_t> urgent_bytes();

  // What to write before the port is closed: wheels to rest, then Passive, then Off.
  std::span<const std::uint8_t> farewell_bytes();

  // Exchanges the counters of left and right from the next sample on (packets 43 and 44: documents of the
  // protocol disagree).
  void set_encoder_order(EncoderOrder order);

  LinkState state() const { return state_; }
  StopReason stop_reason() const { return stop_; }
  bool armed() const { return arm_state_ == ArmState::armed; }
  // Neither armed nor about to be.
  bool disarmed() const { return arm_state_ == ArmState::disarmed; }
  // The robot is told to stand, and its counts have not changed for some ticks.
  bool stands() const;
  const LinkCounts& counts() const { return counts_; }
  const open_interface::ReplyCounts& reply_counts() const { return query_.counts(); }
  int damaged_frames_before() const { return stream_.damaged_before(); }
  const open_interface::StreamCounts& stream_counts() const { return stream_.counts(); }
  open_interface::ChecksumRule checksum_rule() const { return stream_.rule(); }
  open_interface::StrayText& stray_text();
  const open_interface::Reading& last_reading() const { return last_reading_; }
  const LinkConfig& config() const { return config_; }

 private:
  enum class ArmState : std::uint8_t { disarmed, asking, armed };

  Command applied_command(const std::optional<Command>& command);
  void add_drive(open_interface::CommandBytes& out, const WheelPair& speed_m_s) const;
  void write_tick_commands();
  void handshake();
  void ask_for_mode();
  void revive_stream();
  bool in_doubt_of_passive() const;
  void take_reading(const open_interface::Reading& reading, SensorFrame& frame);
  void take_counts(const open_interface::Reading& reading, SensorFrame& frame);
  void note_counter_bits(const open_interface::Reading& reading, const WheelTicks& counted_before);
  void begin_after_counter_reset();
  void note_silence();
  void follow_mode(std::uint8_t reported_mode);
  int ticks_of(double seconds) const;

  LinkConfig config_;
  LinkState state_ = LinkState::closed;
  ArmState arm_state_ = ArmState::disarmed;
  StopReason stop_ = StopReason::none;
  LinkCounts counts_;

  open_interface::QueryReader query_;
  open_interface::StreamReader stream_;
  open_interface::EncoderCounter first_counter_;   // packet 43
  open_interface::EncoderCounter second_counter_;  // packet 44
  open_interface::CounterBits first_bits_;
  open_interface::CounterBits second_bits_;
  UnarmedMotion unarmed_motion_;
  open_interface::Reading last_reading_;
  open_interface::CommandBytes out_;
  open_interface::CommandBytes urgent_;

  SensorFrame frame_;     // of the tick that is under way
  Command last_command_;  // of the tick before
  std::int64_t last_sound_tick_ = 0;
  std::int64_t ticks_since_open_ = 0;
  std::int64_t asking_since_tick_ = 0;
  int late_in_a_row_ = 0;
  int standing_ticks_ = 0;
  int implausible_in_a_row_ = 0;
  int mode_offset_ = 0;          // some 600-series firmware reports the mode plus one
  int says_safe_unasked_ = 0;    // readings in a row, since the port was opened
  bool asked_for_mode_ = false;  // Safe or Full, since the port was opened
  bool after_gap_ = true;
  bool last_reply_failed_ = false;
};

}  // namespace wheelwright::roomba
