#include "drivers/simulation/open_interface_server.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wheelwright::simulation {
namespace {

using open_interface::PacketId;
using open_interface::PacketInfo;

constexpr std::array<int, 12> baud_of_code{300,   600,   1200,  2400,  4800,  9600,
                                           14400, 19200, 28800, 38400, 57600, 115200};
constexpr std::uint8_t stream_header = 19;
constexpr double nominal_half_base_mm = 117.5;
constexpr Nanoseconds button_time{1'000'000'000 / 6};

std::int32_t word(std::span<const std::uint8_t> data, std::size_t at) {
  const auto bits = static_cast<std::uint16_t>((data[at] << 8U) | data[at + 1]);
  return static_cast<std::int16_t>(bits);
}

bool asks_to_move(const HostCommand& command) {
  if (command.opcode == 137) return word(command.data, 0) != 0;
  return (command.opcode == 145 || command.opcode == 146) &&
         (word(command.data, 0) != 0 || word(command.data, 2) != 0);
}

}  // namespace

OpenInterfaceServer::OpenInterfaceServer(const SimulationConfig& config, Mechanics& mechanics,
                                         SensorBoard& sensors, SerialLine& from_host, SerialLine& to_host,
                                         Noise& noise)
    : link_(config.link),
      mechanics_(mechanics),
      sensors_(sensors),
      from_host_(from_host),
      to_host_(to_host),
      noise_(noise),
      charger_connected_(config.link.charger_connected),
      next_stray_text_(nanoseconds(config.link.stray_text_interval_s)) {
  publish_mode();
}

bool OpenInterfaceServer::receive(std::uint8_t byte, Nanoseconds now) {
  now_ = now;
  if (power_ != Power::awake) return false;
  constexpr std::uint8_t start = 128;
  constexpr std::uint8_t reset = 7;
  if (mode_ == OiMode::off && byte != start && byte != reset) return false;
  const auto command = parser_.feed(byte);
  if (!command) return false;
  last_command_ = now;
  obey(*command);
  return may_drive() && asks_to_move(*command);
}

void OpenInterfaceServer::obey(const HostCommand& command) {
  const auto data = command.data;
  switch (command.opcode) {
    case 7:
      return boot(now_);
    case 128:
      return enter(OiMode::passive);
    case 129:
      return change_baud(data[0]);
    case 130:
    case 131:
      return enter(OiMode::safe);
    case 132:
      return enter(OiMode::full);
    case 133:
      enter(OiMode::off);
      power_ = Power::asleep;
      return;
    case 134:
    case 135:
    case 136:
    case 143:
      return enter(OiMode::passive);
    case 140:
      if (data[0] < song_length_.size()) {
        std::int64_t sixty_fourths = 0;
        for (std::size_t i = 3; i < data.size(); i += 2) sixty_fourths += data[i];
        song_length_[data[0]] = Nanoseconds(sixty_fourths * 1'000'000'000 / 64);
      }
      return;
    case 142:
      return send_packets(data[0]);
    case 148:
      return set_stream(data.subspan(1));
    case 149:
      for (const std::uint8_t id : data.subspan(1)) send_packets(id);
      return;
    case 150:
      streaming_ = data[0] == 1;
      return;
    case 165:
      return press_buttons(data[0]);
    case 173:
      return enter(OiMode::off);
    default:
      if (may_drive()) apply_drive_command(command);
  }
}

void OpenInterfaceServer::apply_drive_command(const HostCommand& command) {
  const auto data = command.data;
  constexpr std::int32_t fastest_mm_s = 500;
  constexpr double full_duty = 255.0;
  switch (command.opcode) {
    case 137:
      return drive(std::clamp(word(data, 0), -fastest_mm_s, fastest_mm_s), word(data, 2));
    case 141:
      return play(data[0]);
    case 145: {
      const std::int32_t right = std::clamp(word(data, 0), -fastest_mm_s, fastest_mm_s);
      const std::int32_t left = std::clamp(word(data, 2), -fastest_mm_s, fastest_mm_s);
      sensors_.set(PacketId::requested_right_velocity, right);
      sensors_.set(PacketId::requested_left_velocity, left);
      return mechanics_.command_speeds(0.001 * left, 0.001 * right);
    }
    case 146:
      return mechanics_.command_duties(std::clamp(word(data, 2) / full_duty, -1.0, 1.0),
                                       std::clamp(word(data, 0) / full_duty, -1.0, 1.0));
    default:
      return;  // brushes, lamps, displays, clock: nothing that moves the robot
  }
}

void OpenInterfaceServer::drive(std::int32_t velocity_mm_s, std::int32_t radius_mm) {
  sensors_.set(PacketId::requested_velocity, velocity_mm_s);
  sensors_.set(PacketId::requested_radius, radius_mm);
  const double v = 0.001 * velocity_mm_s;
  const bool straight = radius_mm == -32768 || radius_mm == 32767 || radius_mm == 0;
  if (straight) return mechanics_.command_speeds(v, v);
  if (radius_mm == 1) return mechanics_.command_speeds(-v, v);
  if (radius_mm == -1) return mechanics_.command_speeds(v, -v);
  const double radius = std::clamp(radius_mm, -2000, 2000);
  mechanics_.command_speeds(v * (radius - nominal_half_base_mm) / radius,
                            v * (radius + nominal_half_base_mm) / radius);
}

void OpenInterfaceServer::enter(OiMode mode) {
  if (mode == OiMode::passive || mode == OiMode::off) {
    mechanics_.stop_motors();
    for (const PacketId id : {PacketId::requested_velocity, PacketId::requested_radius,
                              PacketId::requested_right_velocity, PacketId::requested_left_velocity}) {
      sensors_.set(id, 0);
    }
  }
  if (mode == OiMode::off) {
    streaming_ = false;
    parser_.reset();
  }
  mode_ = mode;
  publish_mode();
}

void OpenInterfaceServer::publish_mode() {
  sensors_.set(PacketId::oi_mode, static_cast<std::int32_t>(mode_) + (link_.mode_plus_one ? 1 : 0));
}

void OpenInterfaceServer::boot(Nanoseconds now) {
  now_ = now;
  enter(OiMode::off);
  from_host_.set_baud(link_.baud);
  to_host_.set_baud(link_.baud);
  stream_length_ = 0;
  power_ = Power::booting;
  ++boots_;
  boots_until_ = now + nanoseconds(link_.boot_time_s);
  send(link_.boot_text);
}

void OpenInterfaceServer::power_off() {
  enter(OiMode::off);
  power_ = Power::off;
}

void OpenInterfaceServer::power_on(Nanoseconds now) {
  if (power_ == Power::off) boot(now);
}

void OpenInterfaceServer::wake(Nanoseconds now) {
  if (power_ != Power::asleep) return;
  power_ = Power::awake;
  last_command_ = now;
}

void OpenInterfaceServer::change_baud(std::uint8_t code) {
  if (code >= baud_of_code.size()) return;
  from_host_.set_baud(baud_of_code[code]);
  to_host_.set_baud(baud_of_code[code]);
}

void OpenInterfaceServer::set_stream(std::span<const std::uint8_t> ids) {
  std::copy(ids.begin(), ids.end(), stream_ids_.begin());
  stream_length_ = ids.size();
  streaming_ = true;
  sensors_.set(PacketId::stream_packet_count, static_cast<std::int32_t>(ids.size()));
}

void OpenInterfaceServer::press_buttons(std::uint8_t bits) {
  sensors_.set(PacketId::buttons, bits);
  buttons_until_ = now_ + button_time;
}

void OpenInterfaceServer::play(std::uint8_t song) {
  if (song >= song_length_.size() || now_ < song_until_) return;
  song_until_ = now_ + song_length_[song];
  sensors_.set(PacketId::song_number, song);
  sensors_.set(PacketId::song_playing, 1);
}

void OpenInterfaceServer::sensor_tick(Nanoseconds now) {
  now_ = now;
  if (power_ == Power::booting && now >= boots_until_) power_ = Power::awake;
  if (power_ != Power::awake) return;
  if (now >= buttons_until_) sensors_.set(PacketId::buttons, 0);
  if (now >= song_until_) sensors_.set(PacketId::song_playing, 0);
  if (mode_ == OiMode::safe) guard_safe_mode();
  const bool may_sleep = mode_ == OiMode::passive && link_.sleep_after_s > 0.0 && !charger_connected_;
  if (may_sleep && now - last_command_ >= nanoseconds(link_.sleep_after_s)) {
    enter(OiMode::off);
    power_ = Power::asleep;
    return;
  }
  if (link_.stray_text_interval_s > 0.0 && now >= next_stray_text_) {
    next_stray_text_ += nanoseconds(link_.stray_text_interval_s);
    send(link_.stray_text);
  }
  if (streaming_ && stream_length_ > 0) send_stream_frame();
}

// Roomba 500 Open Interface page 5: a cliff while moving forward (or backward on a turn tighter than the
// robot), any wheel drop, and a charger end Safe mode.
void OpenInterfaceServer::guard_safe_mode() {
  const double v = mechanics_.chassis().forward_speed_m_s();
  const double w = mechanics_.chassis().turn_rate_rad_s();
  constexpr double robot_radius_m = 0.165;
  const bool tight_backward = v < 0.0 && std::abs(v) < std::abs(w) * robot_radius_m;
  const bool at_cliff = sensors_.any_cliff() && (v > 0.0 || tight_backward);
  if (at_cliff || sensors_.any_wheel_drop() || charger_connected_) enter(OiMode::passive);
}

std::size_t OpenInterfaceServer::append_packets(std::uint8_t id, std::span<std::uint8_t> out) {
  std::size_t written = 0;
  const auto append = [&](const PacketInfo& packet) {
    if (written + packet.bytes > out.size()) return;
    encode_value(packet, sensors_.value(packet.id), out.subspan(written, packet.bytes));
    sensors_.asked_for(packet.id);
    written += packet.bytes;
  };
  if (const auto packet = open_interface::find_packet(id)) append(*packet);
  for (const PacketInfo& packet : open_interface::packets_of_group(id)) append(packet);
  return written;
}

void OpenInterfaceServer::send_packets(std::uint8_t id) {
  std::array<std::uint8_t, 80> bytes{};
  const std::size_t length = append_packets(id, bytes);
  for (std::size_t i = 0; i < length; ++i) send(bytes[i]);
}

void OpenInterfaceServer::send_stream_frame() {
  std::array<std::uint8_t, 258> frame{stream_header};
  std::size_t length = 2;
  for (std::size_t i = 0; i < stream_length_ && length + 81 < frame.size(); ++i) {
    const std::size_t data = append_packets(stream_ids_[i], std::span(frame).subspan(length + 1));
    if (data == 0) continue;  // no such packet
    frame[length] = stream_ids_[i];
    length += 1 + data;
  }
  frame[1] = static_cast<std::uint8_t>(length - 2);
  const auto first = frame.begin() + (link_.checksum_excludes_header ? 1 : 0);
  const auto sum = std::accumulate(first, frame.begin() + static_cast<std::ptrdiff_t>(length), 0U);
  frame[length] = static_cast<std::uint8_t>(256U - (sum & 255U));
  ++length;
  for (std::size_t i = 0; i < length; ++i) send(frame[i]);
}

void OpenInterfaceServer::send(std::string_view text) {
  for (const char letter : text) send(static_cast<std::uint8_t>(letter));
}

}  // namespace wheelwright::simulation
