#include "tests/support/bag_bytes.hpp"
#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
using import::Recording;

namespace {

constexpr std::uint64_t second = 1'000'000'000;
constexpr std::uint64_t closed = 4096;
constexpr std::uint64_t open = 0;

std::string begin(std::uint64_t index_place) {
  return std::string(bag1_bytes::magic) + bag1_bytes::bag_header(index_place);
}

std::string connection() {
  return bag1_bytes::connection(0, "/count", "std_msgs/Int32", "int32 data\n");
}

std::string message(int value, std::uint64_t time_ns) {
  return bag1_bytes::message(0, time_ns, Bytes().number(value).str());
}

std::string index_record() {
  return bag1_bytes::record({{"op", "\x04"}, {"ver", std::string("\1\0\0\0", 4)}}, "index");
}

Recording read(const std::string& file) {
  auto recording = import::read_ros_bytes(file, "test.bag");
  REQUIRE(recording.has_value());
  return *std::move(recording);
}

std::vector<double> counts(const Recording& recording) {
  const auto* stream = recording.find("/count");
  return stream == nullptr || stream->channels.empty() ? std::vector<double>() : stream->channels[0].values;
}

}  // namespace

TEST_CASE("Chunks of a bag of ROS 1 are read whatever compressed them") {
  for (const std::string method : {"none", "bz2", "lz4"}) {
    const Recording recording = read(
        begin(closed) + bag1_bytes::chunk(method, connection() + message(1, second + 5)) + index_record() +
        bag1_bytes::chunk(method, message(2, 2 * second)) + index_record() + connection());
    CHECK(counts(recording) == std::vector<double>{1, 2});
    CHECK(recording.find("/count")->received_s[0] == Approx(1.000000005).epsilon(1e-15));
    CHECK(recording.find("/count")->type == "std_msgs/Int32");
    CHECK(recording.format ==
          (method == "none" ? "ROS 1 bag (version 2.0)" : "ROS 1 bag (version 2.0, " + method + ")"));
    CHECK(recording.remarks.empty());
  }
}

TEST_CASE("A bag that was not closed is read without its index, up to an open chunk") {
  // The recorder writes a chunk with sizes of zero and puts them in when it closes it.
  for (const std::string method : {"none", "bz2", "lz4"}) {
    const std::string records = message(2, 2) + message(3, 3);
    std::string file =
        begin(open) + bag1_bytes::chunk(method, connection() + message(1, 1)) + bag1_bytes::chunk(method, "");
    if (method != "none") {
      const std::string empty = Bytes().text(compressed(method, "")).str();
      file.resize(file.size() - empty.size());
      file += Bytes().text("").str();
    }
    const Recording recording = read(file + compressed(method, records));
    CHECK(counts(recording) == std::vector<double>{1, 2, 3});
    CHECK(!recording.remarks.empty());
    CHECK_THAT(recording.remarks.back(), ContainsSubstring("not closed"));
  }
}

TEST_CASE("A bag of ROS 1 that was cut short anywhere gives what is before the cut") {
  for (const std::string method : {"none", "bz2", "lz4"}) {
    const std::string whole = begin(closed) + bag1_bytes::chunk(method, connection() + message(1, 1)) +
                              bag1_bytes::chunk(method, message(2, 2) + message(3, 3)) + index_record();
    std::size_t most = 0;
    for (std::size_t size = bag1_bytes::magic.size() + 1; size < whole.size(); ++size) {
      const Recording recording = read(whole.substr(0, size));
      REQUIRE(counts(recording).size() >= most);
      most = counts(recording).size();
    }
    CHECK(most == 3);
    const Recording recording = read(whole.substr(0, whole.size() - index_record().size() - 2));
    CHECK(!counts(recording).empty());
    REQUIRE(recording.remarks.size() == 1);
    CHECK_THAT(recording.remarks[0], ContainsSubstring("cut short or damaged at byte"));
  }
}

TEST_CASE("Messages of a connection that the bag does not describe are counted in a remark") {
  const Recording recording =
      read(begin(closed) + bag1_bytes::message(5, 1, "x") + connection() + message(1, 2));
  CHECK(counts(recording) == std::vector<double>{1});
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("1 messages are left out"));
}

TEST_CASE("A connection without a definition keeps its rows") {
  const Recording recording =
      read(begin(closed) + bag1_bytes::connection(0, "/count", "std_msgs/Int32", "") + message(1, 2));
  CHECK(recording.find("/count")->rows == 1);
  CHECK_THAT(recording.find("/count")->not_decoded, ContainsSubstring("no definition"));
}

TEST_CASE("Lengths of records that exceed the bag end it with a remark") {
  for (const std::string& tail : {Bytes().number(std::uint32_t{0xffffffff}).str(),
                                  Bytes().number(std::uint32_t{5}).raw("\xff\xff\xff\xffx").number(1).str(),
                                  Bytes().text("").number(std::uint32_t{0xffffffff}).str()}) {
    const Recording recording = read(begin(closed) + connection() + message(1, 2) + tail);
    CHECK(counts(recording) == std::vector<double>{1});
    REQUIRE(recording.remarks.size() == 1);
    CHECK_THAT(recording.remarks[0], ContainsSubstring("cut short or damaged"));
  }
}

TEST_CASE("Old and encrypted bags of ROS 1 are refused by name") {
  CHECK_THAT(import::read_ros_bytes("#ROSBAG V1.2\nx", "old.bag").error(),
             ContainsSubstring("old.bag: ") && ContainsSubstring("before 2.0"));
  const std::string encrypted =
      bag1_bytes::record({{"op", "\x03"}, {"encryptor", "rosbag/AesCbcEncryptor"}}, "");
  CHECK_THAT(import::read_ros_bytes(std::string(bag1_bytes::magic) + encrypted, "a.bag").error(),
             ContainsSubstring("encrypted"));
}
