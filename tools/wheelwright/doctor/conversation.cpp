#include "tools/wheelwright/doctor/conversation.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "drivers/open_interface/commands.hpp"

namespace wheelwright::tools::doctor {
namespace {

using namespace std::chrono_literals;
using open_interface::CommandBytes;

constexpr std::string_view boot_line = "bl-start";  // the first one that a robot prints when it boots
constexpr auto mode_settles = 60ms;                 // the robot wants 20 ms after a change of mode
constexpr auto reply_patience = 100ms;              // 16 ms of adapter, 32 ms of line at 19200 baud, and some
constexpr auto start_again_after = 400ms;  // a robot that was just switched on misses the first Start

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

struct Reply {
  std::optional<open_interface::Reading> reading;
  Clock::time_point at;
  std::size_t bytes = 0;
};

Reply ask(RobotLine& line, open_interface::QueryReader& reader, ReceivedText& received) {
  CommandBytes query;
  query.query_list(reader.begin());
  line.send(query.bytes());
  const auto deadline = Clock::now() + reply_patience;
  Reply reply;
  while (!reply.reading) {
    const auto bytes = line.receive(deadline);
    if (bytes.empty()) break;
    reply.at = Clock::now();
    reply.bytes += bytes.size();
    for (const std::uint8_t byte : bytes) {
      if (auto reading = reader.take(byte)) reply.reading = reading;
      collect_text(reader.stray_text(), received);
    }
  }
  return reply;
}

void send_start(RobotLine& line) {
  CommandBytes start;
  start.padding(padding_bytes);
  start.drive_direct(0, 0);
  start.start();
  line.send(start.bytes());
}

// Counts frames as the robot does: from the bytes that came since the last one, so that a damaged frame
// leaves its place empty. Text in between is not counted; it ends in a carriage return and a line feed.
class FrameNumbering {
 public:
  explicit FrameNumbering(std::size_t frame_bytes) : frame_bytes_(static_cast<double>(frame_bytes)) {}

  void take_byte() { bytes_ += 1.0; }
  void take_text(std::size_t length) { bytes_ -= static_cast<double>(length) + 2.0; }
  std::int64_t close_frame() {
    number_ += std::max<std::int64_t>(1, std::llround(bytes_ / frame_bytes_));
    bytes_ = 0.0;
    return number_;
  }
  std::int64_t frames() const { return number_; }

 private:
  double frame_bytes_;
  double bytes_ = 0.0;
  std::int64_t number_ = 0;
};

}  // namespace

std::size_t collect_text(open_interface::StrayText& text, ReceivedText& received) {
  const std::string run(text.finished());
  if (run.empty()) return 0;
  auto& lines = received.lines;
  if (std::find(lines.begin(), lines.end(), run) == lines.end()) lines.push_back(run);
  ++received.count;
  if (run.find(boot_line) != std::string::npos) ++received.starts;
  text.discard();
  return run.size();
}

void listen(RobotLine& line, std::chrono::milliseconds duration, ReceivedText& received) {
  open_interface::StrayText text;
  const auto deadline = Clock::now() + duration;
  while (Clock::now() < deadline) {
    for (const std::uint8_t byte : line.receive(deadline)) {
      text.take(byte);
      collect_text(text, received);
    }
  }
}

Greeting greet(RobotLine& line, std::chrono::milliseconds patience, ReceivedText& received) {
  Greeting greeting;
  open_interface::QueryReader reader;
  const auto deadline = Clock::now() + patience;
  while (!greeting.reading && Clock::now() < deadline) {
    send_start(line);
    listen(line, mode_settles, received);
    const auto next_start = std::min(deadline, Clock::now() + start_again_after);
    while (!greeting.reading && Clock::now() < next_start) {
      const Reply reply = ask(line, reader, received);
      greeting.reading = reply.reading;
      greeting.bytes_received += reply.bytes;
    }
  }
  return greeting;
}

QueryFigures ask_repeatedly(RobotLine& line, double period_s, int times, ReceivedText& received) {
  QueryFigures figures;
  open_interface::QueryReader reader;
  std::vector<double> round_trips_s;
  const auto period = std::chrono::round<Clock::duration>(std::chrono::duration<double>(period_s));
  auto due = Clock::now();
  for (int i = 0; i < times; ++i) {
    const auto asked = Clock::now();
    const Reply reply = ask(line, reader, received);
    if (reply.reading) {
      round_trips_s.push_back(seconds(reply.at - asked));
      figures.last = reply.reading;
    }
    do due += period;
    while (due < Clock::now());
    listen(line, std::chrono::ceil<std::chrono::milliseconds>(due - Clock::now()), received);
  }
  figures.counts = reader.counts();
  if (!round_trips_s.empty()) figures.round_trip = spread_of(std::move(round_trips_s));
  return figures;
}

StreamFigures listen_to_stream(RobotLine& line, std::chrono::milliseconds duration, ReceivedText& received) {
  open_interface::StreamReader reader;
  FrameNumbering numbering(stream_frame_bytes());
  std::vector<FrameArrival> arrivals;
  CommandBytes command;
  command.stream(reader.packets());
  line.send(command.bytes());
  const auto deadline = Clock::now() + duration;
  while (Clock::now() < deadline) {
    const auto bytes = line.receive(deadline);
    const double now_s = seconds(Clock::now().time_since_epoch());
    for (const std::uint8_t byte : bytes) {
      numbering.take_byte();
      const bool complete = reader.take(byte).has_value();
      if (const std::size_t length = collect_text(reader.stray_text(), received)) numbering.take_text(length);
      if (complete) arrivals.push_back({numbering.close_frame(), now_s});
    }
  }
  command.clear();
  command.pause_stream();
  line.send(command.bytes());
  return {reader.rule(), reader.counts(), numbering.frames(), fit_period(arrivals)};
}

std::size_t stream_frame_bytes() {
  const open_interface::StreamReader reader;
  std::size_t bytes = 3;
  for (const auto id : reader.packets()) {
    bytes += 1U + open_interface::packet_info(id).bytes;
  }
  return bytes;
}

}  // namespace wheelwright::tools::doctor
