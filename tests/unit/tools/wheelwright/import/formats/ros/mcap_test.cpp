#include "tests/support/bag_bytes.hpp"
#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
using import::Recording;

namespace {

constexpr std::uint64_t second = 1'000'000'000;

std::string description() {
  return mcap_bytes::schema(1, "std_msgs/msg/Int32", "ros2msg", "int32 data") +
         mcap_bytes::channel(1, 1, "/count", "cdr");
}

std::string message(int value, std::uint64_t time_ns) {
  return mcap_bytes::message(1, time_ns, CdrBytes().number(value).str());
}

std::string begin(std::string_view profile = "ros2") {
  return std::string(mcap_bytes::magic) + mcap_bytes::header(profile);
}

Recording read(const std::string& file) {
  auto recording = import::read_ros_bytes(file, "test.mcap");
  REQUIRE(recording.has_value());
  return *std::move(recording);
}

std::vector<double> counts(const Recording& recording) {
  const auto* stream = recording.find("/count");
  return stream == nullptr || stream->channels.empty() ? std::vector<double>() : stream->channels[0].values;
}

}  // namespace

TEST_CASE("Chunks of MCAP are read whatever compressed them, and without any") {
  for (const std::string method : {"none", "lz4", "zstd"}) {
    const Recording recording =
        read(begin() + mcap_bytes::chunk(method, description() + message(1, second)) +
             mcap_bytes::chunk(method, message(2, 2 * second)) + message(3, 3 * second) + mcap_bytes::end());
    CHECK(counts(recording) == std::vector<double>{1, 2, 3});
    CHECK(recording.find("/count")->received_s == std::vector<double>{1, 2, 3});
    CHECK(recording.find("/count")->type == "std_msgs/Int32");
    CHECK(recording.format == (method == "none" ? "ROS 2 bag (MCAP)" : "ROS 2 bag (MCAP, " + method + ")"));
    CHECK(recording.remarks.empty());
  }
}

TEST_CASE("Messages recorded out of order are sorted by their log time, with a remark") {
  const Recording recording =
      read(begin() + description() + message(1, 5) + message(2, 3) + message(3, 4) + mcap_bytes::end());
  CHECK(counts(recording) == std::vector<double>{2, 3, 1});
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("/count") && ContainsSubstring("sorted"));
}

TEST_CASE("An MCAP file that was cut short anywhere gives what is before the cut") {
  for (const std::string method : {"none", "lz4", "zstd"}) {
    const std::string whole = begin() + mcap_bytes::chunk(method, description() + message(1, 1)) +
                              mcap_bytes::chunk(method, message(2, 2) + message(3, 3)) + message(4, 4);
    std::size_t most = 0;
    for (std::size_t size = mcap_bytes::magic.size(); size < whole.size(); ++size) {
      const Recording recording = read(whole.substr(0, size));
      REQUIRE(counts(recording).size() >= most);
      most = counts(recording).size();
      REQUIRE(recording.remarks.size() == 1);
      REQUIRE_THAT(recording.remarks[0], ContainsSubstring("cut short or damaged at byte"));
    }
    CHECK(most == 3);
  }
}

TEST_CASE("A chunk whose checksum is wrong is left out, with a remark") {
  std::string chunk = mcap_bytes::chunk("none", message(2, 2));
  chunk[chunk.size() - 3] ^= 1;
  const Recording recording =
      read(begin() + description() + message(1, 1) + chunk + message(3, 3) + mcap_bytes::end());
  CHECK(counts(recording) == std::vector<double>{1, 3});
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("checksum"));
}

TEST_CASE("A chunk that is compressed in another way is named, and the rest is read") {
  std::string chunk = mcap_bytes::chunk("zstd", message(2, 2));
  chunk.replace(chunk.find("zstd"), 4, "lzma");
  const Recording recording = read(begin() + description() + chunk + message(3, 3) + mcap_bytes::end());
  CHECK(counts(recording) == std::vector<double>{3});
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("\"lzma\""));
}

TEST_CASE("A chunk that announces more than it holds, or more than memory, does not take it") {
  std::string chunk = mcap_bytes::chunk("zstd", message(2, 2));
  constexpr std::size_t unpacked_size_place = 9 + 16;
  for (const int size : {0x01, 0xff}) {
    chunk[unpacked_size_place + (size == 0xff ? 7 : 3)] = static_cast<char>(size);
    const Recording recording = read(begin() + description() + chunk + message(3, 3) + mcap_bytes::end());
    CHECK(counts(recording).back() == 3);
    CHECK(recording.remarks.size() == 1);
  }
}

TEST_CASE("Messages of a channel that the file does not describe are counted in a remark") {
  const Recording recording =
      read(begin() + description() + mcap_bytes::message(7, 1, "x") + message(1, 2) + mcap_bytes::end());
  CHECK(counts(recording) == std::vector<double>{1});
  CHECK(recording.remarks.size() == 1);
}

TEST_CASE("Channels of one topic and type are one stream, and of another type another") {
  const Recording recording =
      read(begin("ros1") + description() + mcap_bytes::channel(2, 1, "/count", "cdr") +
           mcap_bytes::schema(3, "std_msgs/msg/Int8", "ros2msg", "int8 data") +
           mcap_bytes::channel(3, 3, "/count", "cdr") + message(1, 1) +
           mcap_bytes::message(2, 2, CdrBytes().number(2).str()) +
           mcap_bytes::message(3, 3, CdrBytes().number(std::int8_t{3}).str()) + mcap_bytes::end());
  CHECK(counts(recording) == std::vector<double>{1, 2});
  REQUIRE(recording.find("/count (std_msgs/Int8)") != nullptr);
  CHECK(recording.find("/count (std_msgs/Int8)")->rows == 1);
  CHECK(recording.format == "ROS 1 recording (MCAP)");
}
