#include "tools/wheelwright/doctor/examination.hpp"

#include <cmath>

#include "drivers/serial/port_holders.hpp"
#include "tools/wheelwright/doctor/conversation.hpp"
#include "tools/wheelwright/doctor/encoder_trial.hpp"
#include "tools/wheelwright/doctor/judge_host.hpp"
#include "tools/wheelwright/doctor/judge_robot.hpp"
#include "tools/wheelwright/doctor/knock.hpp"
#include "tools/wheelwright/doctor/robot_line.hpp"

namespace wheelwright::tools::doctor {
namespace {

using namespace std::chrono_literals;

constexpr auto listening = 300ms;
constexpr auto greeting_patience = 1500ms;
constexpr int knocks = 3;  // a robot that was just switched on misses the first
constexpr double asking_s = 2.0;
constexpr auto streaming = 3000ms;
constexpr double shortest_refresh_s = 0.015;
constexpr double bits_per_byte = 10.0;

class Examination {
 public:
  Examination(const config::DaemonConfig& config, bool move, const Progress& progress)
      : config_(config), move_(move), progress_(progress) {}

  std::vector<Finding> run() {
    examine_robot();
    progress_("waking up on time");
    for (auto& finding : judge_host(examine_host(config_.real_time, config_.link.period_s), config_.real_time,
                                    config_.link.period_s)) {
      findings_.push_back(std::move(finding));
    }
    return std::move(findings_);
  }

 private:
  void examine_robot() {
    RobotLine line(config_.device, config_.baud);
    other_programs_ = serial::names_of(serial::other_holders(config_.device));
    const PortFacts port{config_.device.string(), driver_of(config_.device),
                         other_programs_,         is_on_board(config_.device),
                         line.port().low_latency, line.port().latency_timer_ms};
    findings_.push_back(judge_port(port));
    findings_.push_back(judge_latency_timer(port));
    progress_("listening");
    ReceivedText received;
    listen(line, listening, received);
    const bool answers = find_baud(line, received);
    const QueryFigures queries = answers ? ask(line, received) : QueryFigures{};
    const StreamFigures stream = answers ? let_it_stream(line, received) : StreamFigures{};
    judge(answers, received, line.bits(), queries, stream);
    findings_.push_back(encoders(line, answers, queries));
  }

  // Knocks at both speeds, the configured one first, and only then with more noise. Leaves the line at the
  // speed that the robot answers at.
  bool find_baud(RobotLine& line, ReceivedText& received) {
    std::size_t bytes_received = 0;
    for (const bool padded : {false, true}) {
      for (const int baud : {config_.baud, config_.baud == 115200 ? 19200 : 115200}) {
        progress_("knocking at " + std::to_string(baud) + " baud");
        if (baud != line.baud()) line.change_baud(baud);
        if (!robot_answers(line, padded, received, bytes_received)) continue;
        line.note_robot();
        findings_.push_back(judge_baud(config_.device.string(), config_.baud, baud, bytes_received));
        return true;
      }
    }
    findings_.push_back(
        judge_baud(config_.device.string(), config_.baud, std::nullopt, bytes_received, other_programs_));
    return false;
  }

  bool robot_answers(RobotLine& line, bool padded, ReceivedText& received, std::size_t& bytes_received) {
    for (int i = 0; i < knocks; ++i) {
      const KnockAnswer answer = knock(line, padded, received);
      bytes_received += answer.bytes_received;
      if (!answer.robot_is_there) continue;
      const Greeting greeting = greet(line, greeting_patience, received);
      if (greeting.reading) after_start_ = *greeting.reading;
      return greeting.reading.has_value();
    }
    return false;
  }

  QueryFigures ask(RobotLine& line, ReceivedText& received) {
    progress_("asking at the pace of the loop");
    const int times = static_cast<int>(std::ceil(asking_s / config_.link.period_s));
    return ask_repeatedly(line, config_.link.period_s, times, received);
  }

  // A stream that does not fit its period garbles itself.
  StreamFigures let_it_stream(RobotLine& line, ReceivedText& received) {
    const double frame_s = bits_per_byte * static_cast<double>(stream_frame_bytes()) / line.baud();
    if (frame_s > shortest_refresh_s) {
      why_no_stream_ = "a frame takes " + std::to_string(std::lround(1e3 * frame_s)) + " ms at " +
                       std::to_string(line.baud()) + " baud";
      return {};
    }
    progress_("listening to the stream");
    return listen_to_stream(line, streaming, received);
  }

  void judge(bool answers, const ReceivedText& received, const open_interface::LineBits& bits,
             const QueryFigures& queries, const StreamFigures& stream) {
    findings_.push_back(judge_text(received, after_start_.charging_state != 0));
    if (!answers) {
      for (const char* const check : {"adapter", "mode", "battery", "replies", "query round trip",
                                      "checksum rule", "sensor period", "stream jitter"}) {
        findings_.push_back(not_tested(check, "no answer"));
      }
      return;
    }
    findings_.push_back(judge_adapter(bits));
    findings_.push_back(judge_mode(after_start_));
    findings_.push_back(judge_battery(queries.last.value_or(after_start_), config_.link.lowest_battery_v));
    findings_.push_back(judge_replies(queries.counts));
    findings_.push_back(judge_round_trip(queries.round_trip, config_.link));
    if (!why_no_stream_.empty()) {
      for (const char* const check : {"checksum rule", "sensor period", "stream jitter"}) {
        findings_.push_back(not_tested(check, why_no_stream_));
      }
      return;
    }
    findings_.push_back(judge_checksum(stream, config_.link.transport));
    findings_.push_back(judge_sensor_period(stream, config_.link));
    findings_.push_back(judge_jitter(stream, config_.link.period_s));
  }

  Finding encoders(RobotLine& line, bool answers, const QueryFigures& queries) {
    if (!answers) return not_tested("encoder order", "no answer");
    if (!move_) return not_tested("encoder order", "--move turns a wheel to find out");
    if (!queries.round_trip) return not_tested("encoder order", "no replies to steer by");
    progress_("turning the left wheel");
    return judge_encoders(try_left_wheel(line, config_, queries.round_trip->p99_s), config_);
  }

  const config::DaemonConfig& config_;
  bool move_;
  const Progress& progress_;
  std::vector<Finding> findings_;
  open_interface::Reading after_start_;
  std::string why_no_stream_;
  std::string other_programs_;
};

}  // namespace

std::vector<Finding> examine(const config::DaemonConfig& config, bool move, const Progress& progress) {
  return Examination(config, move, progress).run();
}

}  // namespace wheelwright::tools::doctor
