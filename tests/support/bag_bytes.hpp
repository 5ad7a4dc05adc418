// The bytes of small bags, written as the specifications of their formats have it, for tests of readers.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::test {

// Values one behind another, little-endian.
class Bytes {
 public:
  template <typename Number>
  Bytes& number(Number value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    text_.append(raw, sizeof value);
    return *this;
  }
  Bytes& raw(std::string_view bytes) {
    text_ += bytes;
    return *this;
  }
  // A length of 32 bits and as many bytes: a string of MCAP and of ROS 1.
  Bytes& text(std::string_view bytes) { return number(static_cast<std::uint32_t>(bytes.size())).raw(bytes); }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

// A message of CDR: values are aligned to their size. `big_endian` turns their bytes round.
class CdrBytes {
 public:
  explicit CdrBytes(bool big_endian = false) : big_endian_(big_endian) {}
  template <typename Number>
  CdrBytes& number(Number value) {
    body_.resize((body_.size() + sizeof value - 1) / sizeof value * sizeof value);
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    body_ += big_endian_ ? std::string(raw.rbegin(), raw.rend()) : raw;
    return *this;
  }
  CdrBytes& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    body_ += text;
    body_ += '\0';
    return *this;
  }
  std::string str() const { return std::string({'\0', big_endian_ ? '\0' : '\1', '\0', '\0'}) + body_; }

 private:
  bool big_endian_;
  std::string body_;
};

std::string compressed(std::string_view method, const std::string& bytes);  // "none", "bz2", "lz4", "zstd"

// Records of an MCAP file (mcap.dev/spec).
namespace mcap_bytes {
inline constexpr std::string_view magic = "\x89MCAP0\r\n";
std::string record(std::uint8_t operation, const std::string& content);
std::string header(std::string_view profile);
std::string schema(std::uint16_t id, std::string_view name, std::string_view encoding, std::string_view text);
std::string channel(std::uint16_t id, std::uint16_t schema, std::string_view topic,
                    std::string_view encoding);
std::string message(std::uint16_t channel, std::uint64_t time_ns, const std::string& data);
std::string chunk(std::string_view method, const std::string& records);
std::string end();  // of the data, the footer, and the magic once more
}  // namespace mcap_bytes

// Records of a bag of ROS 1 (wiki.ros.org/Bags/Format/2.0).
namespace bag1_bytes {
inline constexpr std::string_view magic = "#ROSBAG V2.0\n";
std::string record(const std::vector<std::pair<std::string, std::string>>& header, const std::string& data);
std::string bag_header(std::uint64_t index_place);
std::string connection(std::uint32_t id, std::string_view topic, std::string_view type,
                       std::string_view definition);
std::string message(std::uint32_t connection, std::uint64_t time_ns, const std::string& data);
std::string chunk(std::string_view method, const std::string& records);
}  // namespace bag1_bytes

}  // namespace wheelwright::test
