#include "tools/wheelwright/doctor/judge_robot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/load/text_format.hpp"

namespace wheelwright::tools::doctor {
namespace {

using config::fixed_number;
using config::plain_number;

std::string milliseconds(double duration_s, int decimals = 1) {
  return fixed_number(1e3 * duration_s, decimals);
}

std::string describe_spread(const Spread& spread) {
  return "p50 " + milliseconds(spread.p50_s) + ", p99 " + milliseconds(spread.p99_s) + ", largest " +
         milliseconds(spread.largest_s) + " ms";
}

std::vector<std::pair<std::string, double>> values_of(const Spread& spread) {
  return {
      {"p50_ms", 1e3 * spread.p50_s}, {"p99_ms", 1e3 * spread.p99_s}, {"largest_ms", 1e3 * spread.largest_s}};
}

std::string name_of_mode(int mode) {
  constexpr std::array names{"Off", "Passive", "Safe", "Full"};
  const auto index = static_cast<std::size_t>(mode);
  return index < names.size() ? names.at(index) : "mode " + std::to_string(mode);
}

std::string name_of_charging(int state) {
  constexpr std::array names{"not charging",     "reconditioning",          "charging",
                             "trickle charging", "waiting for the charger", "charging fault"};
  const auto index = static_cast<std::size_t>(state);
  return index < names.size() ? names.at(index) : "charging state " + std::to_string(state);
}

// Of the replies or frames that a robot sent, how good a share of sound ones is.
State state_by_share(double sound) {
  if (sound >= 0.99) return State::ok;
  return sound >= 0.9 ? State::attention : State::failed;
}

constexpr const char* damaged_line =
    "bytes are lost or damaged on the way: shorten the wires, twist them with ground, check the 5 V levels";

// "7", or "5, 6".
std::string bit_list(unsigned bits) {
  std::string list;
  for (int bit = 0; bit < 8; ++bit) {
    if (((bits >> static_cast<unsigned>(bit)) & 1U) != 0)
      list += (list.empty() ? "" : ", ") + std::to_string(bit);
  }
  return list;
}

// The two periods that robots are known to have (15 ms by the manual, 1/64 s as measured).
std::optional<double> known_period_s(double period_s) {
  for (const double known_s : {0.015, 0.015625}) {
    if (std::abs(period_s / known_s - 1.0) < 0.01) return known_s;
  }
  return std::nullopt;
}

}  // namespace

Finding judge_port(const PortFacts& port) {
  std::string text = port.device;
  if (!port.driver.empty()) text += ", " + port.driver;
  Finding finding{"port", text + ", opened", State::ok, ""};
  if (!port.other_programs.empty()) {
    finding.text = text + ", also open in " + port.other_programs;
    finding.state = State::failed;
    finding.remedy = "end " + port.other_programs + ": two programs on one port take bytes from each other";
  } else if (port.driver == "bcm2835-aux-uart") {
    finding.text = text + ", a mini UART";
    finding.state = State::attention;
    finding.remedy =
        "its baud rate follows the processor's clock: write core_freq=250 into config.txt, or give the robot "
        "the "
        "other UART by dtoverlay=disable-bt (then /dev/ttyAMA0); as a service see systemd/README.md, UART";
  } else if (port.on_board) {
    finding.remedy =
        "the service waits for /dev/roomba and never starts with this port: it needs the drop-in of "
        "systemd/README.md, UART";
  }
  return finding;
}

Finding judge_latency_timer(const PortFacts& port) {
  constexpr int longest_ms = 2;
  if (!port.latency_timer_ms) return {"latency timer", "none, or not shown by the driver", State::ok, ""};
  const int timer_ms = *port.latency_timer_ms;
  Finding finding{"latency timer", std::to_string(timer_ms) + " ms", State::ok, "", {}};
  finding.values = {{"latency_timer_ms", timer_ms}};
  if (timer_ms <= longest_ms) return finding;
  finding.state = State::attention;
  finding.remedy =
      "the adapter holds data back; install the udev rule in systemd/, or write 1 to "
      "/sys/bus/usb-serial/devices/NAME/latency_timer as root";
  return finding;
}

Finding judge_baud(const std::string& device, int configured_baud, std::optional<int> answering_baud,
                   std::size_t bytes_received, const std::string& other_programs) {
  if (!answering_baud) {
    const bool silent = bytes_received == 0;
    if (!other_programs.empty()) {
      return {"baud", "no sound reply at 115200 or 19200 baud", State::failed,
              "end " + other_programs + ", which takes the robot's answers away, and try again"};
    }
    return {
        "baud",
        silent ? "no answer at 115200 or 19200 baud" : "bytes, but no sound reply at 115200 or 19200 baud",
        State::failed,
        silent ? "press the robot's Clean button to wake it; then check battery, cable (its TXD is our RXD), "
                 "and that this is the robot's port"
               : "it may still be booting, the cable may lack a ground, or the adapter may lose bits (seven "
                 "data bits, "
                 "parity)"};
  }
  Finding finding{
      "baud", "answers at " + std::to_string(*answering_baud), State::ok, "", {{"baud", *answering_baud}}};
  if (*answering_baud == configured_baud) return finding;
  finding.state = State::failed;
  finding.text += ", not at " + std::to_string(configured_baud);
  finding.remedy =
      *answering_baud == 19200
          ? "take the battery out for a moment, or return to 115200 with opcode 129, code 11: stty -F " +
                device + " 19200 raw -echo -hupcl && printf '\\200\\201\\013' > " + device
          : "set link.baud: " + std::to_string(*answering_baud);
  return finding;
}

Finding judge_adapter(const open_interface::LineBits& bits) {
  constexpr std::uint64_t enough_bytes = 1000;
  const std::string bytes = std::to_string(bits.bytes()) + " bytes";
  const std::string stuck = bit_list(bits.never_set() | bits.always_set());
  Finding finding{"adapter",
                  "all eight bits pass, in " + bytes,
                  State::ok,
                  "",
                  {{"bytes", static_cast<double>(bits.bytes())},
                   {"bits_never_set", bits.never_set()},
                   {"bits_always_set", bits.always_set()}}};
  if (stuck.empty()) return finding;
  if (bits.bytes() < enough_bytes) return not_tested("adapter", "only " + bytes + " came");
  const bool lost = bits.never_set() != 0;
  finding.text = (lost ? "bit " + bit_list(bits.never_set()) + " never set" : "") +
                 (lost && bits.always_set() != 0 ? ", " : "") +
                 (bits.always_set() != 0 ? "bit " + bit_list(bits.always_set()) + " always set" : "") +
                 " in " + bytes;
  finding.state = State::failed;
  finding.remedy =
      "the serial adapter damages every byte: use another adapter, and check its wiring, its 5 V levels and "
      "that "
      "nothing sets seven data bits or parity; no reading that comes through it is right";
  return finding;
}

Finding judge_text(const ReceivedText& received, bool charging) {
  constexpr int max_lines = 5;
  if (received.count == 0) return {"stray text", "none", State::ok, ""};
  std::string text = "\"" + received.lines.front() + "\"";
  if (received.count > 1) text += " and " + std::to_string(received.count - 1) + " more";
  Finding finding{"stray text", std::move(text), State::attention, "", {}};
  finding.values = {{"lines", received.count}, {"starts", received.starts}};
  if (received.starts > 1) {
    finding.text = "the robot booted " + std::to_string(received.starts) + " times: " + finding.text;
    finding.state = State::failed;
    finding.remedy =
        "it boots again and again: its battery is empty, old or badly seated (charge or replace it, clean "
        "the "
        "contacts), or its board is damaged";
  } else if (received.count > max_lines && !charging) {
    finding.state = State::failed;
    finding.remedy =
        "it prints without end: read the text; a battery that fails and a damaged board do this; take the "
        "battery out for ten seconds, then charge or replace it";
  } else {
    finding.remedy =
        "the robot prints by itself (docked, booting or short of power); readings that it hits are lost, "
        "nothing is shifted";
  }
  return finding;
}

Finding judge_mode(const open_interface::Reading& after_start) {
  constexpr int passive = 1;
  const int mode = after_start.oi_mode;
  Finding finding{"mode", name_of_mode(mode) + " after Start", State::ok, "", {{"oi_mode", mode}}};
  if (mode == passive) return finding;
  if (mode == passive + 1) {
    finding.text = "Passive after Start, reported as 2: this firmware counts from one";
    return finding;
  }
  finding.state = State::failed;
  finding.remedy = "it does not obey Start; take the battery out for ten seconds and try again";
  return finding;
}

Finding judge_battery(const open_interface::Reading& reading, double lowest_v) {
  constexpr double comfortable_v = 0.7;
  constexpr int fault = 5;
  const double voltage_v = 1e-3 * reading.voltage_mv;
  Finding finding{"battery",
                  fixed_number(voltage_v, 2) + " V, " + name_of_charging(reading.charging_state),
                  State::ok,
                  "",
                  {{"voltage_v", voltage_v}, {"charging_state", reading.charging_state}}};
  if (reading.charging_state != 0 && reading.charging_state < fault) {
    finding.state = State::failed;
    finding.remedy = "take the robot off its charger: it does not drive on it";
  } else if (voltage_v < lowest_v) {
    finding.state = State::failed;
    finding.remedy =
        "charge it: below " + plain_number(lowest_v) + " V (limits.lowest_battery_v) it is stopped";
  } else if (voltage_v < lowest_v + comfortable_v) {
    finding.state = State::attention;
    finding.remedy =
        "charge it soon: below " + plain_number(lowest_v) + " V (limits.lowest_battery_v) it is stopped";
  } else if (reading.charging_state == fault) {
    finding.state = State::attention;
    finding.remedy = "the robot could not charge its battery the last time; look at contacts and battery";
  }
  return finding;
}

Finding judge_replies(const open_interface::ReplyCounts& counts) {
  const double sound = static_cast<double>(counts.sound);
  const double asked = std::max(static_cast<double>(counts.asked), 1.0);
  Finding finding{"replies",
                  std::to_string(counts.sound) + " of " + std::to_string(counts.asked) + " sound",
                  State::ok,
                  "",
                  {{"sound", sound}, {"asked", static_cast<double>(counts.asked)}}};
  if (state_by_share(sound / asked) == State::ok) return finding;
  finding.text += " (" + std::to_string(counts.missing) + " missing, " + std::to_string(counts.incomplete) +
                  " incomplete, " + std::to_string(counts.garbled) + " garbled)";
  finding.state = state_by_share(sound / asked);
  finding.remedy = damaged_line;
  return finding;
}

Finding judge_round_trip(const std::optional<Spread>& round_trip, const roomba::LinkConfig& link) {
  if (!round_trip) return not_tested("query round trip", "no reply");
  Finding finding{"query round trip", describe_spread(*round_trip), State::ok, "", values_of(*round_trip)};
  if (link.transport == roomba::Transport::stream || round_trip->p99_s < link.period_s) return finding;
  const bool hopeless = round_trip->p50_s >= link.period_s;
  finding.state = hopeless ? State::failed : State::attention;
  finding.remedy =
      std::string(hopeless ? "every second reply or more" : "some replies") +
      " come later than the period of " + milliseconds(link.period_s) +
      " ms and are lost: lower the latency timer, use 115200 baud, or set link.transport: stream";
  return finding;
}

Finding judge_checksum(const StreamFigures& stream, roomba::Transport transport) {
  using open_interface::ChecksumRule;
  const auto sound = static_cast<double>(stream.counts.frames);
  const auto corrupt = static_cast<double>(stream.counts.corrupt);
  const double sent = std::max({static_cast<double>(stream.sent), sound + corrupt, 1.0});
  const std::string counts = std::to_string(stream.counts.frames) + " of " + plain_number(sent) +
                             " frames sound, " + std::to_string(stream.counts.corrupt) + " corrupt";
  Finding finding{
      "checksum rule", "", State::ok, "", {{"frames", sound}, {"corrupt", corrupt}, {"sent", sent}}};
  if (stream.rule == ChecksumRule::unknown) {
    finding.text = "unknown, " + counts;
    finding.state = transport == roomba::Transport::stream ? State::failed : State::attention;
    finding.remedy = "the robot does not stream, or too few frames arrive sound; use link.transport: query";
    return finding;
  }
  finding.text = (stream.rule == ChecksumRule::header_included ? "header included (Create 2), "
                                                               : "header excluded (Roomba 500), ") +
                 counts;
  finding.state = state_by_share(sound / sent);
  if (finding.state != State::ok) finding.remedy = damaged_line;
  return finding;
}

Finding judge_sensor_period(const StreamFigures& stream, const roomba::LinkConfig& link) {
  if (!stream.period) return not_tested("sensor period", "no stream");
  const PeriodFit& fit = *stream.period;
  const auto known_s = known_period_s(fit.period_s);
  Finding finding{"sensor period",
                  milliseconds(fit.period_s, 3) + " +- " + milliseconds(fit.uncertainty_s, 3) + " ms: ",
                  State::ok,
                  "",
                  {{"period_ms", 1e3 * fit.period_s}, {"uncertainty_ms", 1e3 * fit.uncertainty_s}}};
  finding.text += known_s ? "the " + std::string(*known_s == 0.015 ? "15.0" : "15.625") + " ms kind"
                          : "neither 15.0 nor 15.625";
  const double wanted_s = known_s.value_or(fit.period_s);
  constexpr double largest_mismatch = 0.005;
  if (link.transport == roomba::Transport::stream &&
      std::abs(link.period_s / fit.period_s - 1.0) > largest_mismatch) {
    finding.state = State::failed;
    finding.remedy = "set link.period_s: " + plain_number(wanted_s) + " (it is " +
                     plain_number(link.period_s) + "): with link.transport: stream the robot sets the pace";
  } else if (!known_s) {
    finding.state = State::attention;
    finding.remedy =
        "no robot is known with this period; frames may be missing: see checksum rule and replies";
  }
  return finding;
}

Finding judge_jitter(const StreamFigures& stream, double period_s) {
  if (!stream.period) return not_tested("stream jitter", "no stream");
  const Spread& jitter = stream.period->jitter;
  Finding finding{"stream jitter", describe_spread(jitter), State::ok, "", values_of(jitter)};
  if (jitter.p99_s < 0.25 * period_s) return finding;
  finding.state = State::attention;
  finding.remedy =
      "frames arrive in batches: lower the adapter's latency timer, or look at the load of this machine";
  return finding;
}

Finding not_tested(const std::string& check, const std::string& why) {
  return {check, "not tested (" + why + ")", State::not_tested, ""};
}

}  // namespace wheelwright::tools::doctor
