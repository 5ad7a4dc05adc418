#include "drivers/simulation/terminal_server.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>

namespace wheelwright::simulation {
namespace {

namespace asio = boost::asio;
using Clock = std::chrono::steady_clock;

// How often the terminal is looked at: well below the time that two bytes at 115200 baud need to matter.
constexpr std::chrono::milliseconds beat{1};

class TruthWriter {
 public:
  TruthWriter(const TruthFile& file, const GroundTruth& truth)
      : period_(std::chrono::nanoseconds(static_cast<std::int64_t>(file.period_s * 1e9))),
        descriptor_(file.descriptor) {
    const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
    out_ << std::setprecision(9) << "# wheelwright_truth: 1\n# period_s: " << file.period_s
         << "\n# wheel_base_m: " << truth.wheel_base_m
         << "\n# metres_per_tick_left: " << truth.metres_per_tick_left
         << "\n# metres_per_tick_right: " << truth.metres_per_tick_right << "\n# started_unix_ms: "
         << std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count()
         << "\nt,x,y,theta,speed_left,speed_right\n";
  }

  TruthWriter(const TruthWriter&) = delete;
  TruthWriter& operator=(const TruthWriter&) = delete;
  ~TruthWriter() {
    flush();
    ::close(descriptor_);
  }

  std::chrono::nanoseconds next() const { return next_; }

  void write(const GroundTruth& truth) {
    out_ << std::fixed << std::setprecision(6) << 1e-9 * static_cast<double>(next_.count()) << ','
         << truth.pose.x_m << ',' << truth.pose.y_m << ',' << truth.pose.theta_rad << ','
         << truth.speed_left_m_s << ',' << truth.speed_right_m_s << '\n';
    // Who watches while the robot drives reads along, half a second behind.
    if (++rows_ % 32 == 0) flush();
    next_ += period_;
  }

 private:
  // What a full disk does not take is lost; the robot goes on.
  void flush() {
    const std::string text = std::move(out_).str();
    out_.str({});
    std::size_t written = 0;
    while (written < text.size()) {
      const ssize_t n = ::write(descriptor_, text.data() + written, text.size() - written);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return;
      written += static_cast<std::size_t>(n);
    }
  }

  std::chrono::nanoseconds period_;
  std::chrono::nanoseconds next_{0};
  std::uint64_t rows_ = 0;
  int descriptor_;
  std::ostringstream out_;
};

class Server {
 public:
  Server(SimulatedRobot& robot, PseudoTerminal& terminal, const std::optional<TruthFile>& truth)
      : robot_(robot), terminal_(terminal) {
    if (truth) truth_.emplace(*truth, robot.truth());
  }

  void run() {
    started_ = Clock::now();
    end_signals_.async_wait([this](const boost::system::error_code&, int) { io_.stop(); });
    wait_for_power_signal();
    next_beat_ = started_;
    wait_for_beat();
    io_.run();
  }

 private:
  void wait_for_power_signal() {
    power_signal_.async_wait([this](const boost::system::error_code& error, int) {
      if (error) return;
      powered_ = !powered_;
      robot_.inject({.kind = powered_ ? Fault::Kind::power_on : Fault::Kind::power_off});
      wait_for_power_signal();
    });
  }

  void wait_for_beat() {
    next_beat_ += beat;
    if (next_beat_ < Clock::now()) next_beat_ = Clock::now();  // the machine was busy: do not hurry after it
    timer_.expires_at(next_beat_);
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error) return;
      exchange();
      wait_for_beat();
    });
  }

  void exchange() {
    advance_to(Clock::now() - started_);
    if (const auto baud = terminal_.client_baud()) robot_.set_host_baud(*baud);
    std::array<std::uint8_t, 4096> buffer{};
    while (const std::size_t count = terminal_.read(buffer)) robot_.receive(std::span(buffer).first(count));
    while (const std::size_t count = robot_.transmit(buffer)) terminal_.write(std::span(buffer).first(count));
  }

  void advance_to(std::chrono::nanoseconds time) {
    while (truth_ && truth_->next() <= time) {
      robot_.advance(truth_->next() - robot_.now());
      truth_->write(robot_.truth());
    }
    if (time > robot_.now()) robot_.advance(time - robot_.now());
  }

  SimulatedRobot& robot_;
  PseudoTerminal& terminal_;
  std::optional<TruthWriter> truth_;
  asio::io_context io_;
  asio::signal_set end_signals_{io_, SIGTERM, SIGINT};
  asio::signal_set power_signal_{io_, SIGUSR1};
  asio::steady_timer timer_{io_};
  Clock::time_point started_;
  Clock::time_point next_beat_;
  bool powered_ = true;
};

}  // namespace

void serve_until_signal(SimulatedRobot& robot, PseudoTerminal& terminal,
                        const std::optional<TruthFile>& truth) {
  Server(robot, terminal, truth).run();
}

}  // namespace wheelwright::simulation
