#include "drivers/roomba/rest_sequence.hpp"

#include <poll.h>
#include <unistd.h>

#include "drivers/roomba/rest_bytes.hpp"

namespace wheelwright::roomba {
namespace {

void wait(std::chrono::milliseconds time) {
  ::poll(nullptr, 0, static_cast<int>(time.count()));
}

}  // namespace

void write_whole(int port, std::span<const std::uint8_t> bytes) {
  constexpr int tries = 10;
  constexpr std::chrono::milliseconds between{2};
  for (int i = 0; i < tries && !bytes.empty(); ++i) {
    const ssize_t written = ::write(port, bytes.data(), bytes.size());
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    if (!bytes.empty()) wait(between);
  }
}

void rest_and_leave(int port, const open_interface::CommandBytes& rest) {
  for (int i = 0; i < rest_orders; ++i) {
    write_whole(port, rest.bytes());
    wait(rest_order_period);
  }
  wait(std::chrono::milliseconds(static_cast<int>(1000.0 * longest_braking_s)));
  open_interface::CommandBytes passive;
  passive.start();
  write_whole(port, passive.bytes());
  wait(rest_order_period);  // a pseudo-terminal forgets what is unread when it is closed
}

}  // namespace wheelwright::roomba
