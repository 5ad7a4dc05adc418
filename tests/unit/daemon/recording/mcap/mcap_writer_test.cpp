// What another reader makes of the files is in tests/mcap.
#include "daemon/recording/mcap/writer.hpp"

#include "daemon/recording/mcap/crc32.hpp"
#include "daemon/recording/mcap/json_object.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

// A disk that is full while `full` is set.
struct Disk {
  std::string bytes;
  bool full = false;
  mcap::Sink sink() {
    return [this](std::string_view more) {
      if (!full) bytes += more;
      return !full;
    };
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

mcap::WriterOptions uncompressed() {
  mcap::WriterOptions options;
  options.compress = false;
  return options;
}

}  // namespace

TEST_CASE("The checksum is the CRC-32 of zip and PNG, in one piece or in several") {
  CHECK(mcap::crc32("123456789") == 0xCBF43926U);
  CHECK(mcap::crc32("") == 0U);
  const std::string text = "the quick brown fox jumps over the lazy dog";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    CHECK(mcap::crc32(text.substr(cut), mcap::crc32(text.substr(0, cut))) == mcap::crc32(text));
  }
}

TEST_CASE("An MCAP file begins and ends with the magic bytes") {
  Disk disk;
  mcap::Writer writer(disk.sink(), {});
  CHECK(writer.finish());
  CHECK(disk.bytes.starts_with("\x89MCAP0\r\n"));
  CHECK(disk.bytes.ends_with("\x89MCAP0\r\n"));
}

TEST_CASE("A chunk is handed on when it is ended, not before") {
  Disk disk;
  mcap::Writer writer(disk.sink(), {}, uncompressed());
  const auto channel = writer.add_channel("/one", "one", "{}");
  writer.add(channel, 1, R"({"a":1})");
  CHECK(count(disk.bytes, R"({"a":1})") == 0);
  writer.end_chunk();
  CHECK(count(disk.bytes, R"({"a":1})") == 1);
}

TEST_CASE("After a refused chunk the next one tells its channels again, and the messages count as lost") {
  Disk disk;
  mcap::Writer writer(disk.sink(), {}, uncompressed());
  const auto channel = writer.add_channel("/topic", "kind", "{}");
  disk.full = true;
  writer.add(channel, 1, "{}");
  writer.add(channel, 2, "{}");
  writer.end_chunk();
  CHECK(writer.lost_messages() == 2);
  CHECK(count(disk.bytes, "/topic") == 0);
  disk.full = false;
  writer.add(channel, 3, R"({"kept":true})");
  writer.end_chunk();
  CHECK(count(disk.bytes, "/topic") == 1);
  CHECK(count(disk.bytes, R"({"kept":true})") == 1);
  writer.add(channel, 4, "{}");
  writer.end_chunk();
  CHECK(count(disk.bytes, "/topic") == 1);
}

TEST_CASE("Messages that compress well make a small file") {
  Disk plain;
  Disk packed;
  mcap::Writer one(plain.sink(), {}, uncompressed());
  mcap::Writer other(packed.sink(), {});
  for (mcap::Writer* writer : {&one, &other}) {
    const auto channel = writer->add_channel("/topic", "kind", "{}");
    for (std::uint64_t k = 0; k < 1000; ++k) writer->add(channel, k, R"({"speed_m_s":0.15,"theta_rad":1.5})");
    writer->finish();
  }
  CHECK(packed.bytes.size() < plain.bytes.size() / 2);
}

TEST_CASE("JSON numbers are short, and what is not finite is null") {
  mcap::JsonObject json;
  json.begin().number("a", 0.1).number("b", -0.0000001).number("c", 1.0 / 0.0).number("d", 200.0);
  CHECK(json.end() == R"({"a":0.1,"b":0,"c":null,"d":200})");
}

TEST_CASE("JSON texts are escaped, times are seconds and nanoseconds") {
  mcap::JsonObject json;
  json.begin().text("a", "one \"two\"\n\\").time("t", 1'500'000'000).flag("f", true);
  CHECK(json.end() == R"({"a":"one \"two\"\u000a\\","t":{"sec":1,"nsec":500000000},"f":true})");
}

TEST_CASE("JSON stays UTF-8 whatever bytes a name has") {
  mcap::JsonObject json;
  json.begin().text("name", "a\xff\u009b");
  CHECK(json.end() == R"({"name":"a\ufffd\u009b"})");
}
