#include "daemon/telemetry/live_view.hpp"

#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "config/load/utc_now.hpp"
#include "daemon/telemetry/messages.hpp"
#include "daemon/telemetry/page.hpp"
#include "daemon/threads/calibrator_thread.hpp"

namespace wheelwright::daemon::telemetry {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::steady_clock;

constexpr auto look_every = milliseconds(40);
constexpr auto scene_every = milliseconds(200);
constexpr auto state_every = milliseconds(500);
constexpr auto goodbye_patience = milliseconds(2500);
constexpr std::size_t kept_messages = 200;
// What all clients together get; beyond it, ticks are left out rather than sent late. About a fifth of one
// core of a small board.
constexpr double max_messages_per_s = 20000.0;
constexpr int niceness = 10;

std::int64_t nanoseconds_since_epoch(auto time) {
  return std::chrono::duration_cast<nanoseconds>(time.time_since_epoch()).count();
}

LogLevel level_of(spdlog::level::level_enum level) {
  switch (level) {
    case spdlog::level::trace:
    case spdlog::level::debug:
      return LogLevel::debug;
    case spdlog::level::warn:
      return LogLevel::warning;
    case spdlog::level::err:
      return LogLevel::error;
    case spdlog::level::critical:
      return LogLevel::fatal;
    default:
      return LogLevel::info;
  }
}

std::string where(const config::LiveViewConfig& config) {
  const bool is_ipv6 = config.address.find(':') != std::string::npos;
  return fmt::format("http://{}:{}/", is_ipv6 ? "[" + config.address + "]" : config.address, config.port);
}

}  // namespace

LiveView::LiveView(const config::DaemonConfig& config, roomba::SensorLoop& sensor_loop, Wiring& wiring)
    : config_(config),
      sensor_loop_(sensor_loop),
      wiring_(wiring),
      unix_minus_steady_ns_(nanoseconds_since_epoch(std::chrono::system_clock::now()) -
                            nanoseconds_since_epoch(steady_clock::now())),
      scene_(config.route) {
  const config::LiveViewConfig& live_view = config.live_view;
  if (live_view.port == 0) return;
  if (!live_view.truth.empty()) truth_.emplace(live_view.truth);
  try {
    ServerHooks hooks;
    hooks.history = [this](ChannelId channel) { return history(channel); };
    hooks.stop = [this](const std::string& who) { take_stop(who); };
    hooks.warn = [](const std::string& what) { spdlog::warn("live view: {}", what); };
    const std::string session_id = config::utc_now() + "/" + std::to_string(unix_minus_steady_ns_);
    server_ =
        std::make_unique<Server>(context_,
                                 ServerConfig{live_view.address, static_cast<std::uint16_t>(live_view.port),
                                              live_view.token, config.robot_name, session_id, page()},
                                 std::move(hooks));
  } catch (const std::exception& error) {
    spdlog::warn("no live view: {} is not available ({}); live_view.port says another", where(live_view),
                 error.what());
    return;
  }
  spdlog::default_logger()->sinks().push_back(messages_);
  wiring.has_telemetry = true;
  spdlog::info("live view: {}{}", where(live_view), live_view.token.empty() ? "" : "?token=...");
}

// The process may go on with another run.
LiveView::~LiveView() {
  std::erase(spdlog::default_logger()->sinks(), messages_);
}

void LiveView::run() {
  if (!server_) return;
  ::setpriority(PRIO_PROCESS, 0, niceness);  // of this thread: Linux takes the 0 so
  wait();
  while (!context_.stopped()) {
    try {
      context_.run();
    } catch (const std::exception& error) {
      if (failures_.happened(steady_clock::now())) spdlog::error("live view: {}", error.what());
    }
  }
}

void LiveView::end(const std::string& result, const std::string& outcome) {
  if (!server_) return;
  boost::asio::post(context_, [this, result, outcome] {
    result_ = result;
    outcome_ = outcome;
    state_changed_ = true;
    say_goodbye();
  });
}

// Each order stops the robot; not each has a line of the log.
void LiveView::take_stop(const std::string& who) {
  sensor_loop_.request_stop(StopReason::requested);
  last_stop_by_ = who;
  if (stops_.happened(steady_clock::now())) spdlog::warn("live view: {} asks for a stop", who);
}

void LiveView::wait() {
  timer_.expires_after(look_every);
  timer_.async_wait([this](const boost::system::error_code& cancelled) {
    if (cancelled) return;
    wait();
    look();
  });
}

void LiveView::look() {
  const double per_s = static_cast<double>(server_->subscriptions()) / config_.link.period_s;
  every_ = static_cast<std::uint64_t>(std::max(1.0, std::ceil(per_s / max_messages_per_s)));
  LogEntry entry;
  while (wiring_.telemetry.entries.pop(entry)) take(entry);
  const auto now = steady_clock::now();
  say_repetitions(stops_.due(now), failures_.due(now));
  publish_wake_ups();
  publish_messages();
  publish_truth();
  publish_scene(now);
  publish_state(now);
}

void LiveView::take(const LogEntry& entry) {
  const auto differs = [&](const LogEntry& last) {
    return last.frame.command.activity != entry.frame.command.activity ||
           last.frame.stop != entry.frame.stop || last.frame.armed != entry.frame.armed ||
           last.record.visited != entry.record.visited ||
           last.record.model_version != entry.record.model_version;
  };
  state_changed_ = state_changed_ || !last_ || differs(*last_);
  if (scene_.take(entry) && truth_) truth_->start_at(time_of(entry));
  last_ = entry;
  if (is_due(ticks_++)) publish_tick(entry);
}

bool LiveView::is_due(std::uint64_t count) const {
  return count % every_ == 0;
}

void LiveView::publish(ChannelId channel, std::uint64_t time_ns, std::string payload) {
  server_->publish({channel, time_ns, std::make_shared<const std::string>(std::move(payload))});
}

std::optional<std::string> LiveView::text_of(ChannelId channel, const LogEntry& entry) const {
  const std::uint64_t time_ns = time_of(entry);
  const PoseRecord& record = entry.record;
  switch (channel) {
    case ChannelId::pose:
      return pose_message(time_ns, steering_pose(record, config_.pose_source));
    case ChannelId::predicted:
      if (!record.has_prediction) return std::nullopt;
      return pose_message(time_ns, record.predicted);
    case ChannelId::odometry:
      return pose_message(time_ns, record.odometry);
    case ChannelId::filtered:
      if (!record.hybrid) return std::nullopt;
      return pose_message(time_ns, record.hybrid->pose);
    case ChannelId::transform:
      return transform_message(time_ns, steering_pose(record, config_.pose_source));
    case ChannelId::wheels:
      return wheels_message(time_ns, entry);
    case ChannelId::light_bumper:
      if (!entry.frame.valid) return std::nullopt;
      return light_bumper_message(time_ns, entry.frame);
    case ChannelId::state:
      return state_text();
    default:
      return std::nullopt;
  }
}

void LiveView::publish_tick(const LogEntry& entry) {
  for (const ChannelId channel :
       {ChannelId::pose, ChannelId::predicted, ChannelId::odometry, ChannelId::filtered, ChannelId::transform,
        ChannelId::wheels, ChannelId::light_bumper}) {
    if (!server_->anyone_wants(channel)) continue;
    if (auto text = text_of(channel, entry)) publish(channel, time_of(entry), std::move(*text));
  }
}

// Where wake-ups are left out, the latest of them stands for all.
void LiveView::publish_wake_ups() {
  WakeUp wake_up;
  while (wiring_.telemetry.wake_ups.pop(wake_up)) {
    latest_wake_up_ = std::max(latest_wake_up_, wake_up.late);
    if (!is_due(wake_ups_++)) continue;
    const std::uint64_t time_ns = unix_ns(wake_up.due + wake_up.late);
    const double late_s = std::chrono::duration<double>(latest_wake_up_).count();
    if (server_->anyone_wants(ChannelId::loop))
      publish(ChannelId::loop, time_ns, loop_message(time_ns, late_s));
    latest_wake_up_ = nanoseconds{0};
  }
}

void LiveView::publish_truth() {
  if (!truth_) return;
  for (const TimedPose& truth : truth_->read()) {
    scene_.take_truth(truth.pose);
    if (!is_due(truths_++)) continue;
    last_truth_ = Message{ChannelId::truth, truth.time_ns,
                          std::make_shared<const std::string>(pose_message(truth.time_ns, truth.pose))};
    server_->publish(*last_truth_);
  }
}

void LiveView::publish_messages() {
  for (const MessageSink::Line& line : messages_->take()) {
    const auto time_ns = static_cast<std::uint64_t>(nanoseconds_since_epoch(line.at));
    const Message message{
        ChannelId::log, time_ns,
        std::make_shared<const std::string>(log_message(time_ns, level_of(line.level), line.text))};
    last_messages_.push_back(message);
    if (last_messages_.size() > kept_messages) last_messages_.pop_front();
    server_->publish(message);
  }
}

void LiveView::publish_scene(steady_clock::time_point now) {
  if (now < next_scene_) return;
  next_scene_ = now + scene_every;
  const std::uint64_t time_ns = unix_ns(now);
  if (auto changes = scene_.changes(time_ns)) publish(ChannelId::scene, time_ns, std::move(*changes));
}

void LiveView::publish_state(steady_clock::time_point now) {
  if (!last_ || (!state_changed_ && now < next_state_)) return;
  next_state_ = now + state_every;
  state_changed_ = false;
  if (server_->anyone_wants(ChannelId::state)) publish(ChannelId::state, time_of(*last_), state_text());
}

std::string LiveView::state_text() const {
  return state_message(
      time_of(*last_), *last_, config_,
      {wiring_.robot_answers.load(std::memory_order_relaxed),
       wiring_.telemetry.dropped.load(std::memory_order_relaxed), server_->clients(), result_, outcome_});
}

std::vector<Message> LiveView::history(ChannelId channel) const {
  if (channel == ChannelId::log) return {last_messages_.begin(), last_messages_.end()};
  if (channel == ChannelId::truth) {
    return last_truth_ ? std::vector<Message>{*last_truth_} : std::vector<Message>{};
  }
  if (channel == ChannelId::scene) {
    const std::uint64_t time_ns = unix_ns(steady_clock::now());
    return {{channel, time_ns, std::make_shared<const std::string>(scene_.everything(time_ns))}};
  }
  const auto text = last_ ? text_of(channel, *last_) : std::nullopt;
  if (!text) return {};
  return {{channel, time_of(*last_), std::make_shared<const std::string>(*text)}};
}

void LiveView::say_repetitions(std::optional<std::uint64_t> stops, std::optional<std::uint64_t> failures) {
  if (stops) spdlog::warn("live view: {} more orders to stop, the last by {}", *stops, last_stop_by_);
  if (failures) spdlog::error("live view: {} more errors", *failures);
}

// What is still to be said is said, and what then is still open is closed for good. How the run came out is
// said first: a client that is behind may not be there for the rest.
void LiveView::say_goodbye() {
  timer_.cancel();
  say_repetitions(stops_.rest(), failures_.rest());
  server_->forget_backlogs();
  publish_state(steady_clock::now());
  next_scene_ = {};
  look();
  server_->close();
  leave_by(steady_clock::now() + goodbye_patience);
}

// As soon as nobody is there any more: a slow client still gets what is on its way, a dead one does not keep
// the process.
void LiveView::leave_by(steady_clock::time_point deadline) {
  timer_.expires_after(look_every);
  timer_.async_wait([this, deadline](const boost::system::error_code& /*ignored*/) {
    if (server_->clients() == 0 || steady_clock::now() >= deadline) {
      context_.stop();
    } else {
      leave_by(deadline);
    }
  });
}

std::uint64_t LiveView::unix_ns(steady_clock::time_point time) const {
  return static_cast<std::uint64_t>(nanoseconds_since_epoch(time) + unix_minus_steady_ns_);
}

std::uint64_t LiveView::time_of(const LogEntry& entry) const {
  return static_cast<std::uint64_t>(std::llround(1e9 * entry.frame.host_time_s) + unix_minus_steady_ns_);
}

}  // namespace wheelwright::daemon::telemetry
