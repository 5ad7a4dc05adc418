#include <array>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/support/catch.hpp"
#include "tools/wheelwright/doctor/encoder_trial.hpp"
#include "tools/wheelwright/doctor/finding.hpp"
#include "tools/wheelwright/doctor/judge_host.hpp"
#include "tools/wheelwright/doctor/judge_robot.hpp"
#include "tools/wheelwright/doctor/knock.hpp"
#include "tools/wheelwright/doctor/period_fit.hpp"

using namespace wheelwright;
using namespace wheelwright::tools::doctor;

namespace {

// Frames on an even beat, each as late as `lateness` says, with every `lost`th frame missing.
template <typename Lateness>
std::vector<FrameArrival> arrivals(double period_s, int count, Lateness lateness, int lost = 0) {
  std::vector<FrameArrival> frames;
  for (int i = 0; i < count; ++i) {
    if (lost > 0 && i % lost == lost - 1) continue;
    const double sent_s = 5000.0 + period_s * i;
    frames.push_back({i, sent_s + lateness(sent_s)});
  }
  return frames;
}

StreamFigures stream_of_period(double period_s) {
  StreamFigures stream;
  stream.period = PeriodFit{period_s, 2e-6, {}};
  return stream;
}

open_interface::Reading reading(int voltage_mv, int charging_state = 0, int mode = 1) {
  open_interface::Reading reading;
  reading.voltage_mv = voltage_mv;
  reading.charging_state = static_cast<std::uint8_t>(charging_state);
  reading.oi_mode = static_cast<std::uint8_t>(mode);
  return reading;
}

HostFigures good_host() {
  HostFigures host;
  host.release = "6.1";
  host.priority = 50;
  host.lockable_memory = "no limit";
  host.memory_can_be_locked = true;
  host.lateness = {50e-6, 200e-6, 400e-6};
  return host;
}

EncoderTrial trial(double ticks_43, double ticks_44) {
  return {true, StopReason::none, ticks_43, ticks_44, 112.0};
}

}  // namespace

TEST_CASE("the period of an even beat is found exactly") {
  const auto fit = fit_period(arrivals(0.015625, 200, [](double) { return 0.003; }));
  REQUIRE(fit);
  CHECK_THAT(fit->period_s, WithinAbs(0.015625, 1e-9));
  CHECK(fit->jitter.largest_s < 1e-6);
}

TEST_CASE("the period's interval holds the truth in about 95 of 100 noisy streams") {
  int held = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> late(0.0, 0.004);
    const auto fit = fit_period(arrivals(
        0.015, 190, [&](double) { return late(random); }, 7));
    REQUIRE(fit);
    if (std::abs(fit->period_s - 0.015) <= fit->uncertainty_s) ++held;
  }
  CHECK(held > 180);
  CHECK(held < 200);
}

TEST_CASE("an adapter that hands on by its own timer does not pass for a sure period") {
  // Arrivals on a grid of 16 ms beat against 15.625 ms: neighbouring residuals are alike.
  const auto to_grid = [](double sent_s) { return 0.016 * std::ceil(sent_s / 0.016) - sent_s; };
  const auto fit = fit_period(arrivals(0.015625, 190, to_grid));
  REQUIRE(fit);
  CHECK_THAT(fit->period_s, WithinAbs(0.015625, fit->uncertainty_s));
  CHECK(fit->uncertainty_s > 5e-6);
  CHECK(fit->uncertainty_s < 2e-4);
  CHECK(fit->jitter.largest_s > 0.006);
}

TEST_CASE("too few frames give no period") {
  CHECK_FALSE(fit_period(arrivals(0.015, 9, [](double) { return 0.0; })));
}

TEST_CASE("the two periods of robots are told apart, and a configured one is judged by them") {
  roomba::LinkConfig link;
  CHECK_THAT(judge_sensor_period(stream_of_period(0.0150003), link).text,
             ContainsSubstring("the 15.0 ms kind"));
  CHECK_THAT(judge_sensor_period(stream_of_period(0.015626), link).text,
             ContainsSubstring("the 15.625 ms kind"));
  CHECK(judge_sensor_period(stream_of_period(0.0153), link).state == State::attention);

  link.transport = roomba::Transport::stream;
  link.period_s = 0.015;
  CHECK(judge_sensor_period(stream_of_period(0.0150003), link).state == State::ok);
  const auto wrong = judge_sensor_period(stream_of_period(0.015626), link);
  CHECK(wrong.state == State::failed);
  CHECK_THAT(wrong.remedy, ContainsSubstring("link.period_s: 0.015625"));
}

TEST_CASE("a reply that comes later than the period cannot work") {
  roomba::LinkConfig link;
  CHECK(judge_round_trip(Spread{0.007, 0.009, 0.020}, link).state == State::ok);
  CHECK(judge_round_trip(Spread{0.012, 0.021, 0.022}, link).state == State::attention);
  CHECK(judge_round_trip(Spread{0.033, 0.035, 0.035}, link).state == State::failed);
  CHECK(judge_round_trip(std::nullopt, link).state == State::not_tested);
  link.transport = roomba::Transport::stream;
  CHECK(judge_round_trip(Spread{0.033, 0.035, 0.035}, link).state == State::ok);
}

TEST_CASE("a robot at another speed is told how to return") {
  CHECK(judge_baud("/dev/r", 115200, 115200, 0).state == State::ok);
  const auto slow = judge_baud("/dev/r", 115200, 19200, 0);
  CHECK(slow.state == State::failed);
  CHECK_THAT(slow.remedy, ContainsSubstring("opcode 129, code 11") &&
                              ContainsSubstring("printf '\\200\\201\\013' > /dev/r"));
  CHECK_THAT(judge_baud("/dev/r", 19200, 115200, 0).remedy, ContainsSubstring("link.baud: 115200"));
  CHECK_THAT(judge_baud("/dev/r", 115200, std::nullopt, 0).text, ContainsSubstring("no answer"));
  CHECK_THAT(judge_baud("/dev/r", 115200, std::nullopt, 99).text, ContainsSubstring("no sound reply"));
}

TEST_CASE("an adapter that loses or sets a bit of every byte is named, and a sound one is not") {
  // Of a robot at rest on its battery: mode 1, 15.5 V, -200 mA, counts that stand.
  const std::array<std::uint8_t, 8> sound{1, 0x3C, 0x8C, 0xFF, 0x38, 0, 0x12, 0x35};
  const auto judged = [&](unsigned lost, unsigned set, int times = 200) {
    open_interface::LineBits bits;
    for (int i = 0; i < times; ++i) {
      for (const std::uint8_t byte : sound) bits.take(static_cast<std::uint8_t>((byte & ~lost) | set));
    }
    return judge_adapter(bits);
  };
  CHECK(judged(0, 0).state == State::ok);
  for (unsigned bit = 0; bit < 8; ++bit) {
    INFO(bit);
    const Finding lost = judged(1U << bit, 0);
    CHECK(lost.state == State::failed);
    CHECK_THAT(lost.text, ContainsSubstring("bit " + std::to_string(bit) + " never set"));
    CHECK_THAT(lost.remedy, ContainsSubstring("adapter"));
    const Finding set = judged(0, 1U << bit);
    CHECK(set.state == State::failed);
    CHECK_THAT(set.text, ContainsSubstring("bit " + std::to_string(bit) + " always set"));
  }
  CHECK(judged(0x80, 0, 10).state == State::not_tested);
}

TEST_CASE("damaged stream frames are judged by the limits of damaged replies") {
  StreamFigures stream;
  stream.rule = open_interface::ChecksumRule::header_included;
  const auto judged = [&](std::uint64_t sound, std::uint64_t corrupt, std::int64_t sent) {
    stream.counts.frames = sound;
    stream.counts.corrupt = corrupt;
    stream.sent = sent;
    return judge_checksum(stream, roomba::Transport::query).state;
  };
  CHECK(judged(190, 0, 190) == State::ok);
  CHECK(judged(180, 10, 190) == State::attention);
  CHECK(judged(161, 29, 190) == State::failed);
  CHECK(judged(161, 0, 190) == State::failed);  // lost with their headers
  CHECK(judge_replies({.asked = 100, .sound = 85, .garbled = 15}).state == State::failed);
  stream.rule = open_interface::ChecksumRule::unknown;
  CHECK(judge_checksum(stream, roomba::Transport::query).state == State::attention);
  CHECK(judge_checksum(stream, roomba::Transport::stream).state == State::failed);
}

TEST_CASE("a robot that boots again and again or prints without end is not fit to drive") {
  CHECK(judge_text({{"bl-start"}, 1, 1}, false).state == State::attention);
  const Finding boots = judge_text({{"bl-start", "STR730"}, 4, 2}, false);
  CHECK(boots.state == State::failed);
  CHECK_THAT(boots.remedy, ContainsSubstring("battery") && ContainsSubstring("board"));
  const Finding prints = judge_text({{"error"}, 12, 0}, false);
  CHECK(prints.state == State::failed);
  CHECK_THAT(prints.remedy, ContainsSubstring("battery") && ContainsSubstring("board"));
  CHECK(judge_text({{"bat: min 1 sec 2 mV 15000"}, 12, 0}, true).state == State::attention);
}

TEST_CASE("a knock's reply is known by its marks") {
  CHECK(is_knock_reply({1, 0x3C, 0xC8, 0x3C, 0xC0, 1}));
  CHECK_FALSE(is_knock_reply({1, 0x3C, 0xC8, 0x3C, 0xC0, 2}));  // two modes
  CHECK_FALSE(is_knock_reply({1, 0x3C, 0xC8, 0x3A, 0x00, 1}));  // two voltages
  CHECK_FALSE(is_knock_reply({1, 0x0C, 0xC8, 0x0C, 0xC8, 1}));  // 3.3 V
  CHECK_FALSE(is_knock_reply({'b', 'a', 't', 't', 'e', 'b'}));
}

TEST_CASE("battery and mode are judged as the daemon would") {
  CHECK(judge_battery(reading(15500), 12.0).state == State::ok);
  CHECK(judge_battery(reading(12300), 12.0).state == State::attention);
  CHECK(judge_battery(reading(11900), 12.0).state == State::failed);
  CHECK(judge_battery(reading(15500, 2), 12.0).state == State::failed);
  CHECK(judge_battery(reading(15500, 5), 12.0).state == State::attention);
  CHECK(judge_mode(reading(15500, 0, 1)).state == State::ok);
  CHECK_THAT(judge_mode(reading(15500, 0, 2)).text, ContainsSubstring("counts from one"));
  CHECK(judge_mode(reading(15500, 0, 0)).state == State::failed);
}

TEST_CASE("the wheel that was told to turn names its counter") {
  config::DaemonConfig config;
  CHECK_THAT(judge_encoders(trial(112, 6), config).text, ContainsSubstring("43 is left"));
  CHECK_THAT(judge_encoders(trial(6, 112), config).text, ContainsSubstring("43 is right"));
  CHECK(judge_encoders(trial(6, 112), config).state == State::ok);  // the daemon finds it out by itself
  CHECK(judge_encoders(trial(3, 1), config).state == State::failed);
  CHECK(judge_encoders(trial(112, 90), config).state == State::failed);
  CHECK_THAT(judge_encoders({true, StopReason::cliff, 20, 0, 112}, config).text, ContainsSubstring("cliff"));

  config.detect_encoder_order = false;
  const auto wrong = judge_encoders(trial(6, 112), config);
  CHECK(wrong.state == State::failed);
  CHECK_THAT(wrong.remedy, ContainsSubstring("right_is_43"));
}

TEST_CASE("what the machine lacks is a failure only for those who require it") {
  config::RealTimeConfig wanted;
  for (const auto& finding : judge_host(good_host(), wanted, 0.018)) CHECK(finding.state == State::ok);
  HostFigures poor = good_host();
  poor.priority = 0;
  poor.memory_can_be_locked = false;
  CHECK(verdict_on(judge_host(poor, wanted, 0.018)).fit_to_drive);
  wanted.policy = config::RealTimePolicy::require;
  CHECK_FALSE(verdict_on(judge_host(poor, wanted, 0.018)).fit_to_drive);

  HostFigures late = good_host();
  late.skipped_periods = 1;
  CHECK_FALSE(verdict_on(judge_host(late, {}, 0.018)).fit_to_drive);
}

TEST_CASE("the verdict names what failed, or else what wants attention") {
  const Finding good{"port", "opened", State::ok, ""};
  const Finding doubtful{"stray text", "\"battery\"", State::attention, "ignore it"};
  const Finding bad{"baud", "no answer", State::failed, "press Clean"};
  CHECK(verdict_on({good}).sentence == "Fit to drive.");
  CHECK(verdict_on({good, doubtful}).sentence == "Fit to drive, but have a look at stray text.");
  CHECK(verdict_on({good, not_tested("encoder order", "why")}).sentence ==
        "Fit to drive, encoder order not tested.");
  CHECK(verdict_on({bad, doubtful}).sentence == "Not fit to drive: see baud.");
  CHECK_FALSE(verdict_on({bad}).fit_to_drive);
}

TEST_CASE("the report has one line per check, one per remedy, and the verdict") {
  const std::vector<Finding> findings{{"port", "opened", State::ok, ""},
                                      {"baud", "no answer", State::failed, "press Clean"}};
  std::ostringstream plain;
  print_report(plain, findings, false);
  CHECK(plain.str() ==
        "  port  opened     ok\n"
        "  baud  no answer  failed\n"
        "\nWhat to do\n"
        "  baud: press Clean\n"
        "\nNot fit to drive: see baud.\n");
  std::ostringstream coloured;
  print_report(coloured, findings, true);
  CHECK_THAT(coloured.str(), ContainsSubstring("\033[31mfailed\033[0m"));
}

TEST_CASE("the report as JSON survives any text of the robot") {
  std::ostringstream out;
  print_json(out, "/dev/r", {{"stray text", "\xFF\"bl-start\"", State::attention, "", {{"x_ms", 1.5}}}});
  const auto json = nlohmann::json::parse(out.str());
  CHECK(json["fit_to_drive"] == true);
  CHECK(json["checks"][0]["state"] == "attention");
  CHECK(json["checks"][0]["values"]["x_ms"] == 1.5);
}
