#include "tests/support/bag_bytes.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

namespace wheelwright::test {
namespace {

template <typename Number>
std::string raw(Number value) {
  return Bytes().number(value).str();
}

}  // namespace

std::string compressed(std::string_view method, const std::string& bytes) {
  std::string packed(2 * bytes.size() + 1024, '\0');
  if (method == "zstd") {
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  } else if (method == "lz4") {
    packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr));
  } else if (method == "bz2") {
    auto size = static_cast<unsigned>(packed.size());
    BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()),
                             static_cast<unsigned>(bytes.size()), 9, 0, 0);
    packed.resize(size);
  } else {
    return bytes;
  }
  return packed;
}

namespace mcap_bytes {

std::string record(std::uint8_t operation, const std::string& content) {
  return Bytes().number(operation).number(std::uint64_t{content.size()}).raw(content).str();
}

std::string header(std::string_view profile) {
  return record(0x01, Bytes().text(profile).text("test").str());
}

std::string schema(std::uint16_t id, std::string_view name, std::string_view encoding,
                   std::string_view text) {
  return record(0x03, Bytes().number(id).text(name).text(encoding).text(text).str());
}

std::string channel(std::uint16_t id, std::uint16_t schema, std::string_view topic,
                    std::string_view encoding) {
  return record(0x04, Bytes().number(id).number(schema).text(topic).text(encoding).text("").str());
}

std::string message(std::uint16_t channel, std::uint64_t time_ns, const std::string& data) {
  return record(
      0x05, Bytes().number(channel).number(std::uint32_t{0}).number(time_ns).number(time_ns).raw(data).str());
}

std::string chunk(std::string_view method, const std::string& records) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(records.data());
  const std::string packed = compressed(method, records);
  Bytes content;
  content.number(std::uint64_t{0}).number(std::uint64_t{0}).number(std::uint64_t{records.size()});
  content.number(static_cast<std::uint32_t>(crc32_z(0, bytes, records.size())));
  content.text(method == "none" ? "" : method).number(std::uint64_t{packed.size()}).raw(packed);
  return record(0x06, content.str());
}

std::string end() {
  const std::string footer =
      Bytes().number(std::uint64_t{0}).number(std::uint64_t{0}).number(std::uint32_t{0}).str();
  return record(0x0f, raw(std::uint32_t{0})) + record(0x02, footer) + std::string(magic);
}

}  // namespace mcap_bytes

namespace bag1_bytes {
namespace {

std::string fields_of(const std::vector<std::pair<std::string, std::string>>& fields) {
  Bytes bytes;
  for (const auto& [name, value] : fields) bytes.text(name + "=" + value);
  return bytes.str();
}

std::string operation(char code) {
  return {code};
}

}  // namespace

std::string record(const std::vector<std::pair<std::string, std::string>>& header, const std::string& data) {
  return Bytes().text(fields_of(header)).text(data).str();
}

std::string bag_header(std::uint64_t index_place) {
  return record({{"op", operation(3)},
                 {"index_pos", raw(index_place)},
                 {"conn_count", raw(std::uint32_t{1})},
                 {"chunk_count", raw(std::uint32_t{1})}},
                std::string(16, ' '));
}

std::string connection(std::uint32_t id, std::string_view topic, std::string_view type,
                       std::string_view definition) {
  return record({{"op", operation(7)}, {"conn", raw(id)}, {"topic", std::string(topic)}},
                fields_of({{"topic", std::string(topic)},
                           {"type", std::string(type)},
                           {"md5sum", "*"},
                           {"message_definition", std::string(definition)}}));
}

std::string message(std::uint32_t connection, std::uint64_t time_ns, const std::string& data) {
  constexpr std::uint64_t second = 1'000'000'000;
  const std::string time = Bytes()
                               .number(static_cast<std::uint32_t>(time_ns / second))
                               .number(static_cast<std::uint32_t>(time_ns % second))
                               .str();
  return record({{"op", operation(2)}, {"conn", raw(connection)}, {"time", time}}, data);
}

std::string chunk(std::string_view method, const std::string& records) {
  return record({{"op", operation(5)},
                 {"compression", std::string(method)},
                 {"size", raw(static_cast<std::uint32_t>(records.size()))}},
                compressed(method, records));
}

}  // namespace bag1_bytes

}  // namespace wheelwright::test
