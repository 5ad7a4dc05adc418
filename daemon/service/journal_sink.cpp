#include "daemon/service/journal_sink.hpp"

#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <string_view>

#include "config/load/printable_text.hpp"

namespace wheelwright::daemon {
namespace {

constexpr std::string_view journal = "/run/systemd/journal/socket";

// The journal's native protocol: one datagram per entry, FIELD=value lines.
class JournalSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  JournalSink(int socket, const JournalFields& fields) : socket_(socket) {
    for (const auto& [name, value] : fields) fields_ += name + "=" + config::printable(value) + "\n";
  }
  JournalSink(const JournalSink&) = delete;
  JournalSink& operator=(const JournalSink&) = delete;
  ~JournalSink() override { ::close(socket_); }

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    constexpr std::array<char, 7> priorities{'7', '7', '6', '4', '3', '2', '6'};  // of spdlog's levels
    const std::string text = config::printable({message.payload.data(), message.payload.size()});
    const auto level = static_cast<std::size_t>(message.level);
    const std::string entry = fields_ + "SYSLOG_IDENTIFIER=wheelwrightd\nPRIORITY=" + priorities.at(level) +
                              "\nMESSAGE=" + text + "\n";
    ::send(socket_, entry.data(), entry.size(), MSG_NOSIGNAL);
  }
  void flush_() override {}

  int socket_;
  std::string fields_;
};

}  // namespace

std::shared_ptr<spdlog::sinks::sink> make_journal_sink(const JournalFields& fields) {
  if (std::getenv("JOURNAL_STREAM") == nullptr) return nullptr;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(journal.begin(), journal.end(), address.sun_path);
  const int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return nullptr;
  if (::connect(descriptor, static_cast<const sockaddr*>(static_cast<const void*>(&address)),
                sizeof(address)) != 0) {
    ::close(descriptor);
    return nullptr;
  }
  return std::make_shared<JournalSink>(descriptor, fields);
}

}  // namespace wheelwright::daemon
