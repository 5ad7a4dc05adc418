// What becomes of the fields of messages, whatever file they come from.
#include <cmath>
#include <sstream>

#include "tests/support/bag_bytes.hpp"
#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/formats/ros/messages/definition.hpp"
#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
using import::Recording;
using import::Stream;
using import::ros::Dialect;
using import::ros::parse_definition;

namespace {

struct Topic {
  std::string encoding;  // of messages
  std::string schema_encoding;
  std::string definition;
  std::string type = "a/msg/T";
};

Recording recording_of(const Topic& topic, const std::vector<std::string>& messages) {
  std::string file(mcap_bytes::magic);
  file += mcap_bytes::header("ros2");
  if (!topic.schema_encoding.empty())
    file += mcap_bytes::schema(1, topic.type, topic.schema_encoding, topic.definition);
  file += mcap_bytes::channel(1, topic.schema_encoding.empty() ? 0 : 1, "/t", topic.encoding);
  std::uint64_t time_ns = 5'000'000'000;
  for (const std::string& message : messages) file += mcap_bytes::message(1, time_ns++, message);
  auto recording = import::read_ros_bytes(file + mcap_bytes::end(), "test.mcap");
  REQUIRE(recording.has_value());
  return *std::move(recording);
}

Recording of_cdr(const std::string& definition, const std::vector<std::string>& messages) {
  return recording_of({"cdr", "ros2msg", definition}, messages);
}

Recording of_ros1(const std::string& definition, const std::vector<std::string>& messages) {
  return recording_of({"ros1", "ros1msg", definition}, messages);
}

double value(const Recording& recording, std::string_view channel, std::size_t row = 0) {
  const Stream* stream = recording.find("/t");
  REQUIRE(stream != nullptr);
  INFO(channel << ": " << stream->not_decoded);
  REQUIRE(stream->find(channel) != nullptr);
  return stream->find(channel)->values.at(row);
}

std::vector<std::string> names(const Recording& recording) {
  std::vector<std::string> result;
  for (const auto& channel : recording.streams.at(0).channels) result.push_back(channel.name);
  return result;
}

std::string reason(const Recording& recording) {
  return recording.streams.at(0).not_decoded;
}

}  // namespace

TEST_CASE("Numbers of every kind are read in both byte orders, aligned to their size") {
  const std::string definition =
      "bool a\nint8 b\nuint16 c\nint32 d\nuint8 e\nint64 f\nfloat32 g\nfloat64 h\nuint8 i\nuint64 j\n";
  for (const bool big_endian : {false, true}) {
    CdrBytes message(big_endian);
    message.number(std::uint8_t{2}).number(std::int8_t{-3}).number(std::uint16_t{40000}).number(-70000);
    message.number(std::uint8_t{255}).number(std::int64_t{-5'000'000'000}).number(0.5F).number(-1e300);
    message.number(std::uint8_t{7}).number(std::uint64_t{1} << 40U);
    const Recording recording = of_cdr(definition, {message.str()});
    CHECK(value(recording, "a") == 1);
    CHECK(value(recording, "b") == -3);
    CHECK(value(recording, "c") == 40000);
    CHECK(value(recording, "d") == -70000);
    CHECK(value(recording, "e") == 255);
    CHECK(value(recording, "f") == -5e9);
    CHECK(value(recording, "g") == 0.5);
    CHECK(value(recording, "h") == -1e300);
    CHECK(value(recording, "i") == 7);
    CHECK(value(recording, "j") == std::ldexp(1.0, 40));
  }
}

TEST_CASE("The second version of plain CDR aligns to 4 bytes at most") {
  const std::string body = Bytes().number(std::int32_t{1}).number(2.5).str();
  const Recording recording = of_cdr("int32 a\nfloat64 b", {std::string("\0\x07\0\0", 4) + body});
  CHECK(value(recording, "b") == 2.5);
}

TEST_CASE("CDR with parameter lists is refused by its topic") {
  const Recording recording = of_cdr("int32 a", {std::string("\0\3\0\0\1\0\0\0", 8)});
  CHECK(recording.streams.at(0).rows == 1);
  CHECK_THAT(reason(recording), ContainsSubstring("parameter lists"));
}

TEST_CASE("Messages of ROS 1 are packed, and their time has unsigned seconds") {
  const std::string definition =
      "Header header\nbyte b\nduration d\n====\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring "
      "frame_id\n";
  const std::string message = Bytes()
                                  .number(std::uint32_t{9})
                                  .number(std::uint32_t{4'000'000'000})
                                  .number(std::uint32_t{500'000'000})
                                  .text("map")
                                  .number(std::int8_t{-1})
                                  .number(std::int32_t{-2})
                                  .number(std::int32_t{250'000'000})
                                  .str();
  const Recording recording = of_ros1(definition, {message});
  CHECK(value(recording, "header.stamp") == 4'000'000'000.5);
  CHECK(value(recording, "header.seq") == 9);
  CHECK(value(recording, "b") == -1);
  CHECK(value(recording, "d") == -1.75);
  REQUIRE(recording.metadata.size() == 1);
  CHECK(recording.metadata[0] == std::pair<std::string, std::string>("/t header.frame_id", "map"));
}

TEST_CASE("A time of ROS 2 is seconds, with or without its definition in the file") {
  for (const std::string behind : {"", "\n====\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"}) {
    CdrBytes message;
    message.number(std::uint8_t{1}).number(std::int32_t{-1}).number(std::uint32_t{500'000'000});
    CHECK(value(of_cdr("uint8 a\nbuiltin_interfaces/Time at" + behind, {message.str()}), "at") == -0.5);
  }
}

TEST_CASE("Constants, defaults, comments and bounds of a definition are understood") {
  const std::string definition =
      "# a comment\n\nint32 LIMIT=5\nstring WORD = a # b\nuint8 MODE_A  =  1   # one\r\n"
      "int32 x 7  # a default\nstring<=10 s \"a = b\"\nint32[<=3] bounded\nstring<=5[<=2] words\n  float64   "
      "y\n";
  CdrBytes message;
  message.number(std::int32_t{3})
      .text("hi")
      .number(std::uint32_t{2})
      .number(std::int32_t{4})
      .number(std::int32_t{5});
  message.number(std::uint32_t{1}).text("w").number(2.5);
  const Recording recording = of_cdr(definition, {message.str()});
  CHECK(value(recording, "x") == 3);
  CHECK(value(recording, "bounded[1]") == 5);
  CHECK(value(recording, "y") == 2.5);
  CHECK(recording.streams[0].channels.size() == 4);
}

TEST_CASE("Parts are found by their full name, by their package, or as the only ones of their name") {
  const std::string definition =
      "Near n\nb/Far f\nc/msg/Third t\nStray s\n=====\nMSG: a/Near\nint8 v\n===\nMSG: b/msg/Far\nint8 v\n"
      "===\nMSG: c/Third\nint8 v\n===\nMSG: d/Stray\nint8 v\n";
  const Recording recording = of_ros1(definition, {std::string("\1\2\3\4", 4)});
  CHECK(value(recording, "n.v") == 1);
  CHECK(value(recording, "f.v") == 2);
  CHECK(value(recording, "t.v") == 3);
  CHECK(value(recording, "s.v") == 4);
}

TEST_CASE("Arrays of up to 16 numbers have a channel for each, larger ones and covariances none") {
  const std::string definition =
      "int8[3] small\nint8[17] large\nfloat64[9] rotation\nfloat32[36] pose_covariance\nint8[] any\nint8 "
      "last";
  Bytes message;
  message.raw(std::string("\1\2\3", 3)).raw(std::string(17, 'x')).raw(std::string(72 + 144, 'x'));
  message.text(std::string(20, 'x')).number(std::int8_t{9});
  Bytes shorter;
  shorter.raw(std::string("\1\2\3", 3))
      .raw(std::string(17 + 72 + 144, 'x'))
      .text("\5")
      .number(std::int8_t{8});
  const Recording recording = of_ros1(definition, {message.str(), shorter.str()});
  CHECK(recording.streams[0].channels.size() == 5);
  CHECK(value(recording, "small[2]") == 3);
  CHECK(value(recording, "last", 0) == 9);
  CHECK(value(recording, "last", 1) == 8);
  CHECK(std::isnan(value(recording, "any[0]", 0)));
  CHECK(value(recording, "any[0]", 1) == 5);
}

TEST_CASE("Arrays of up to 8 messages have the channels of each") {
  const std::string definition = "Wheel[] wheels\nint8 last\n===\nMSG: a/Wheel\nstring label\nint8 speed\n";
  Bytes two;
  two.number(std::uint32_t{2}).text("l").raw("\1").text("r").raw("\2").raw("\7");
  Bytes nine;
  nine.number(std::uint32_t{9});
  for (int i = 0; i < 9; ++i) nine.text("x").raw("\3");
  nine.raw("\6");
  const Recording recording = of_ros1(definition, {two.str(), nine.str()});
  CHECK(value(recording, "wheels[1].speed") == 2);
  CHECK(std::isnan(value(recording, "wheels[1].speed", 1)));
  CHECK(value(recording, "last", 1) == 6);
  CHECK(recording.streams[0].channels.size() == 3);
}

TEST_CASE("Joints are told by their names, in whatever order a message has them") {
  const std::string definition = "string[] name\nfloat64[] position\nfloat64[] velocity\n";
  const auto message = [](const std::vector<std::string>& joints, double first) {
    CdrBytes bytes;
    bytes.number(static_cast<std::uint32_t>(joints.size()));
    for (const auto& joint : joints) bytes.text(joint);
    bytes.number(static_cast<std::uint32_t>(joints.size()));
    for (std::size_t i = 0; i < joints.size(); ++i) bytes.number(first + static_cast<double>(i));
    return bytes.number(std::uint32_t{0}).str();
  };
  const Recording recording =
      of_cdr(definition, {message({"left", "right"}, 1), message({"right", "left"}, 5), message({"arm"}, 8)});
  CHECK(names(recording) == std::vector<std::string>{"position[left]", "position[right]", "position[arm]"});
  CHECK(value(recording, "position[left]", 0) == 1);
  CHECK(value(recording, "position[left]", 1) == 6);
  CHECK(value(recording, "position[right]", 1) == 5);
  CHECK(std::isnan(value(recording, "position[left]", 2)));
  CHECK(value(recording, "position[arm]", 2) == 8);
}

TEST_CASE("Transforms are a stream for each pair of frames, without leading slashes") {
  const std::string definition =
      "geometry_msgs/TransformStamped[] transforms\n===\nMSG: geometry_msgs/TransformStamped\nHeader header\n"
      "string child_frame_id\nTransform transform\n===\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring "
      "frame_id\n"
      "===\nMSG: geometry_msgs/Transform\nVector3 translation\n===\nMSG: geometry_msgs/Vector3\nfloat64 x\n";
  Bytes message;
  message.number(std::uint32_t{2});
  for (const auto& [parent, child, x] : {std::tuple("/map", "odom", 1.5), std::tuple("odom", "/base", 2.5)}) {
    message.number(std::uint32_t{0}).number(std::uint64_t{7}).text(parent).text(child).number(x);
  }
  const Recording recording =
      recording_of({"ros1", "ros1msg", definition, "tf2_msgs/TFMessage"}, {message.str(), message.str()});
  REQUIRE(recording.streams.size() == 2);
  const Stream* stream = recording.find("/t:odom.base");
  REQUIRE(stream != nullptr);
  CHECK(stream->rows == 2);
  CHECK(stream->find("transform.translation.x")->values == std::vector<double>{2.5, 2.5});
  CHECK(recording.find("/t:map.odom")->find("header.stamp")->values[0] == 7);
}

TEST_CASE("A usual type of ROS 2 is decoded without a definition in the file") {
  CdrBytes twist;
  for (int i = 1; i <= 6; ++i) twist.number(static_cast<double>(i));
  const Recording recording = recording_of({"cdr", "", ""}, {twist.str()});
  CHECK_THAT(reason(recording), ContainsSubstring("no definition"));
  const Recording known =
      recording_of({"cdr", "ros2idl", "module geometry_msgs {", "geometry_msgs/msg/Twist"}, {twist.str()});
  CHECK(value(known, "angular.z") == 6);
  CHECK(known.streams[0].type == "geometry_msgs/Twist");
}

TEST_CASE("A topic that cannot be decoded keeps its rows and says why") {
  const auto why = [](const Topic& topic) {
    const Recording recording = recording_of(topic, {"some bytes", "more"});
    CHECK(recording.streams.at(0).rows == 2);
    CHECK(recording.streams.at(0).received_s.size() == 2);
    CHECK(recording.streams.at(0).channels.empty());
    return reason(recording);
  };
  CHECK_THAT(why({"cdr", "ros2idl", "module a {"}), ContainsSubstring("ros2idl"));
  CHECK_THAT(why({"protobuf", "protobuf", "x"}), ContainsSubstring("protobuf"));
  CHECK_THAT(why({"ros1", "ros1msg", "b/Missing x"}), ContainsSubstring("lacks that of b/Missing"));
  CHECK_THAT(why({"ros1", "ros1msg", "a/T x"}), ContainsSubstring("nests"));
  CHECK_THAT(why({"ros1", "ros1msg", "int32"}), ContainsSubstring("no field"));
  CHECK_THAT(why({"cdr", "ros2msg", "wstring w"}), ContainsSubstring("wstring"));
  CHECK_THAT(why({"ros1", "ros1msg", "int8 a"}), ContainsSubstring("message 1 has 9 bytes more"));
  CHECK_THAT(why({"ros1", "ros1msg", "float64[90] a"}), ContainsSubstring("message 1 is shorter"));
}

TEST_CASE("A message that is damaged has no numbers, and the others have theirs") {
  const Recording recording =
      of_ros1("int32 a", {std::string("\1\0\0\0", 4), "x", std::string("\2\0\0\0", 4)});
  CHECK(value(recording, "a", 0) == 1);
  CHECK(std::isnan(value(recording, "a", 1)));
  CHECK(value(recording, "a", 2) == 2);
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("/t: 1 of 3 messages are damaged"));
}

TEST_CASE("Lengths in a message that exceed it end in a remark, not in memory or time") {
  const std::string huge = Bytes().number(std::uint32_t{0xffffffff}).str();
  for (const std::string field :
       {"string a", "string[] a", "int8[] a", "float64[] a", "E[] a\n===\nMSG: a/E\nstring s",
        "int8[4294967295] a", "string[4294967295] a", "E[4294967295] a\n===\nMSG: a/E\nint8 s"}) {
    INFO(field);
    CHECK_THAT(reason(of_ros1(field, {huge})), ContainsSubstring("shorter"));
  }
}

TEST_CASE("Elements without bytes take no time, however many they are") {
  const std::string nothing =
      "===\nMSG: a/B\nC[4000000000] c\n===\nMSG: a/C\nD[4000000000] d\n===\nMSG: a/D\nint8 X=1\n";
  CHECK(value(of_ros1("B[4000000000] b\nint8 last\n" + nothing, {"\5"}), "last") == 5);
  const std::string sequence = Bytes().number(std::uint32_t{0xffffffff}).raw("\5").str();
  CHECK(value(of_ros1("B[] b\nint8 last\n" + nothing, {sequence}), "last") == 5);
}

TEST_CASE("A definition that stands for more fields than memory holds is refused") {
  std::ostringstream definition;
  definition << "A0 a\n";
  for (int level = 0; level < 20; ++level) {
    definition << "===\nMSG: a/A" << level << "\n";
    for (int field = 0; field < 10; ++field) definition << "A" << level + 1 << " f" << field << "\n";
  }
  definition << "===\nMSG: a/A20\nint8 f\n";
  CHECK_THAT(reason(of_ros1(definition.str(), {"x"})), ContainsSubstring("too large"));
}

TEST_CASE("Messages of JSON have their numbers by path") {
  const Recording recording = recording_of(
      {"json", "jsonschema", "{}"},
      {R"({"stamp": {"sec": 3, "nsec": 500000000}, "on": true, "p": {"x": -1.5}, "v": [1, 2], "s": "text"})",
       "no JSON"});
  CHECK(value(recording, "stamp") == 3.5);
  CHECK(value(recording, "on") == 1);
  CHECK(value(recording, "p.x") == -1.5);
  CHECK(value(recording, "v[1]") == 2);
  CHECK(recording.streams[0].channels.size() == 5);
  CHECK(std::isnan(value(recording, "p.x", 1)));
}

TEST_CASE("A message that rosbag2 compressed by itself is unpacked") {
  CdrBytes message;
  message.number(2.5);
  CHECK(value(of_cdr("float64 a", {compressed("zstd", message.str())}), "a") == 2.5);
}

TEST_CASE("An empty message of ROS 2 has a byte, and no numbers") {
  const Recording recording = of_cdr("", {CdrBytes().number(std::uint8_t{0}).str()});
  CHECK_THAT(reason(recording), ContainsSubstring("no definition"));
  CHECK(parse_definition("std_msgs/Empty", "", Dialect::ros2)->types[0].fields.size() == 1);
  CHECK(parse_definition("std_msgs/Empty", "", Dialect::ros1)->types[0].fields.empty());
}
