#include "daemon/service/message_output.hpp"

#include <poll.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <future>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "daemon/service/exit_status.hpp"
#include "daemon/service/journal_sink.hpp"
#include "daemon/service/printable_formatter.hpp"
#include "daemon/service/queued_sink.hpp"

namespace wheelwright::daemon {
namespace {

constexpr std::size_t queued_messages = 512;
constexpr auto drain_patience = std::chrono::seconds(1);
// What a pipe takes whole or not at all.
constexpr std::size_t piece_bytes = 512;

std::shared_ptr<spdlog::sinks::sink> standard_error_sink() {
  const char* no_colour = std::getenv("NO_COLOR");
  const bool plain = no_colour != nullptr && *no_colour != '\0';
  if (plain) return std::make_shared<spdlog::sinks::stderr_sink_mt>();
  return std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
}

std::shared_ptr<spdlog::sinks::sink> make_sink(const config::DaemonConfig& config, bool as_service) {
  if (as_service) {
    auto journal = make_journal_sink(
        {{"WHEELWRIGHT_ROBOT", config.robot_name}, {"WHEELWRIGHT_DEVICE", config.device.string()}});
    if (journal) return journal;
  }
  auto standard_error = standard_error_sink();
  standard_error->set_formatter(make_printable_formatter("%H:%M:%S.%e %^%l%$ %v"));
  return standard_error;
}

void write_whole(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), std::min(text.size(), piece_bytes));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EAGAIN) {
      pollfd writable{descriptor, POLLOUT, 0};
      ::poll(&writable, 1, -1);
      continue;
    }
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

void set_up_messages(const config::DaemonConfig& config, bool as_service) {
  try {
    auto queued = std::make_shared<QueuedSink>(make_sink(config, as_service), queued_messages);
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("wheelwrightd", std::move(queued)));
  } catch (const std::system_error& error) {
    throw StartFailure(EndCause::internal, std::string("no thread for the messages: ") + error.what() +
                                               "; raise the limit of threads (ulimit -u, TasksMax=)");
  }
}

bool drain_messages() {
  const auto until = std::chrono::steady_clock::now() + drain_patience;
  bool drained = true;
  for (const auto& sink : spdlog::default_logger()->sinks()) {
    auto* const queued = dynamic_cast<QueuedSink*>(sink.get());
    if (queued == nullptr) continue;
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    drained = queued->drain(std::max(left, std::chrono::milliseconds(0))) && drained;
  }
  return drained;
}

bool print_within(std::chrono::milliseconds patience, int descriptor, std::string_view text) {
  auto done = std::make_shared<std::promise<void>>();
  auto written = done->get_future();
  try {
    std::thread([done, descriptor, kept = std::string(text)] {
      write_whole(descriptor, kept);
      done->set_value();
    }).detach();
  } catch (const std::system_error&) {
    pollfd writable{descriptor, POLLOUT, 0};
    if (::poll(&writable, 1, static_cast<int>(patience.count())) != 1) return false;
    return ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  }
  return written.wait_for(patience) == std::future_status::ready;
}

}  // namespace wheelwright::daemon
