// A session with a robot that answers anything, driven by commands of any value, over a port that comes and
// goes.
#include "drivers/roomba/roomba_link.hpp"

#include <cmath>

#include "tests/fuzz/fuzz_input.hpp"
#include "tests/support/soak/order_watch.hpp"

using namespace wheelwright;

namespace {

class Session {
 public:
  Session(fuzz::FuzzInput& input, const roomba::LinkConfig& config) : input_(input), link_(config) {
    link_.port_opened();
  }

  void run() {
    for (int tick = 0; !input_.empty(); ++tick) {
      event(input_.byte());
      one_tick(tick);
    }
    const auto& replies = link_.reply_counts();
    const auto closed = replies.sound + replies.missing + replies.incomplete + replies.garbled;
    fuzz::must_hold(replies.asked == closed || replies.asked == closed + 1, "each query comes to one end");
  }

 private:
  void event(std::uint8_t what) {
    if (what == 1) link_.arm();
    if (what == 2) link_.stop(StopReason::requested);
    if (what == 3) link_.port_closed();
    if (what == 4) link_.port_opened();
    if (what == 5) link_.set_encoder_order(roomba::EncoderOrder::right_is_43);
    if (what == 6) link_.set_encoder_order(roomba::EncoderOrder::left_is_43);
    has_command_ = what % 3 != 0;
  }

  void one_tick(int tick) {
    Command command;
    if (has_command_) command.speed_m_s = {input_.real(), input_.real()};
    say(link_.begin_tick(tick, 0.018 * tick, has_command_ ? std::optional(command) : std::nullopt));
    bool done = false;
    for (int count = input_.byte(); count > 0; --count) {
      const auto reading = link_.receive(input_.byte());
      if (reading && !done) complete(&*reading);
      done = done || reading;
    }
    if (!done) complete(nullptr);
  }

  void complete(const open_interface::Reading* reading) {
    const SensorFrame frame = link_.complete_tick(reading);
    say(link_.urgent_bytes());
    const double limit = link_.config().largest_speed_m_s;
    fuzz::must_hold(
        std::abs(frame.command.speed_m_s.left) <= limit && std::abs(frame.command.speed_m_s.right) <= limit,
        "no command is beyond the limit, or no number");
  }

  void say(std::span<const std::uint8_t> bytes) {
    const auto moving = watch_.orders().moving;
    watch_.take(bytes);
    fuzz::must_hold(link_.armed() || watch_.orders().moving == moving, "nothing moves that is not armed");
  }

  fuzz::FuzzInput& input_;
  roomba::RoombaLink link_;
  soak::OrderWatch watch_;
  bool has_command_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  const std::uint8_t kind = input.byte();
  roomba::LinkConfig config;
  config.transport = (kind & 1U) != 0 ? roomba::Transport::stream : roomba::Transport::query;
  config.drive_mode = (kind & 2U) != 0 ? roomba::DriveMode::pwm : roomba::DriveMode::direct;
  Session(input, config).run();
  return 0;
}
