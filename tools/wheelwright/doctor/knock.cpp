#include "tools/wheelwright/doctor/knock.hpp"

#include <algorithm>
#include <cstdlib>

#include "drivers/open_interface/commands.hpp"

namespace wheelwright::tools::doctor {
namespace {

using namespace std::chrono_literals;
using open_interface::PacketId;

constexpr auto patience = 250ms;
constexpr std::array asked{PacketId::oi_mode, PacketId::voltage, PacketId::voltage, PacketId::oi_mode};

}  // namespace

bool is_knock_reply(const std::array<std::uint8_t, 6>& bytes) {
  constexpr int highest_mode = 4;  // firmware that counts from one
  constexpr int max_change_mv = 300;
  const int first_mv = 256 * bytes[1] + bytes[2];
  const int second_mv = 256 * bytes[3] + bytes[4];
  return bytes[0] == bytes[5] && bytes[0] <= highest_mode && first_mv >= open_interface::lowest_voltage_mv &&
         first_mv <= open_interface::highest_voltage_mv && std::abs(first_mv - second_mv) <= max_change_mv;
}

KnockAnswer knock(RobotLine& line, bool padded, ReceivedText& received) {
  open_interface::CommandBytes bytes;
  if (padded) bytes.padding(padding_bytes);
  bytes.start();
  bytes.query_list(asked);
  line.send(bytes.bytes());
  KnockAnswer answer;
  std::array<std::uint8_t, 6> last{};
  open_interface::StrayText text;
  const auto deadline = Clock::now() + patience;
  while (!answer.robot_is_there && Clock::now() < deadline) {
    for (const std::uint8_t byte : line.receive(deadline)) {
      std::rotate(last.begin(), last.begin() + 1, last.end());
      last.back() = byte;
      ++answer.bytes_received;
      answer.robot_is_there =
          answer.robot_is_there || (answer.bytes_received >= last.size() && is_knock_reply(last));
      text.take(byte);
      collect_text(text, received);
    }
  }
  return answer;
}

}  // namespace wheelwright::tools::doctor
