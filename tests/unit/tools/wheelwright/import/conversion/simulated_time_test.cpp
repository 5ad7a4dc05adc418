#include "tools/wheelwright/import/conversion/simulated_time.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright;
using import::Channel;
using import::Recording;
using import::Stream;

namespace {

Stream topic(const std::string& name, double clock_rate, std::size_t rows = 600) {
  Stream stream{.name = name,
                .type = {},
                .rows = rows,
                .received_s = {},
                .channels = {},
                .places = {},
                .run_starts = {},
                .not_decoded = {}};
  Channel stamps{"header.stamp", "", {}};
  for (std::size_t i = 0; i < rows; ++i) {
    stream.received_s.push_back(1.7e9 + 0.1 * static_cast<double>(i));
    stamps.values.push_back(5.0 + 0.1 * clock_rate * static_cast<double>(i));
  }
  stream.channels.push_back(stamps);
  return stream;
}

Recording recording_of(std::vector<Stream> streams) {
  Recording recording;
  recording.streams = std::move(streams);
  return recording;
}

}  // namespace

TEST_CASE("Where a simulation runs at half the speed of the recorder, all topics have its time") {
  Stream commands = topic("/cmd_vel", 1.0);
  commands.channels.clear();  // a Twist has no stamp
  for (double& t : commands.received_s) t += 0.05;
  Recording recording = recording_of({topic("/joint_states", 0.5), commands});
  import::take_simulated_time(recording);
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("0.500 times"));
  CHECK_THAT(recording.streams[0].received_s[100], WithinAbs(10.0, 1e-6));
  CHECK_THAT(recording.streams[1].received_s[100], WithinAbs(10.025, 1e-6));
  CHECK_THAT(recording.streams[1].received_s.back(), WithinAbs(5.0 + 0.05 * 599 + 0.025, 1e-6));
}

TEST_CASE("Stamps at the speed of the recorder, of two clocks or that jump leave the times alone") {
  Recording other_start = recording_of({topic("/joint_states", 1.0)});
  Recording two_clocks = recording_of({topic("/joint_states", 0.5), topic("/scan", 0.8)});
  Recording one_real = recording_of({topic("/joint_states", 0.5), topic("/scan", 1.0)});
  Recording jumps = recording_of({topic("/joint_states", 0.5)});
  jumps.streams[0].channels[0].values[300] = 0.0;
  for (Recording* recording : {&other_start, &two_clocks, &one_real, &jumps}) {
    import::take_simulated_time(*recording);
    CHECK(recording->remarks.empty());
    CHECK(recording->streams[0].received_s.front() == 1.7e9);
  }
}
