#include "tools/wheelwright/import/formats/ros/mcap/scan_mcap.hpp"

#include <zlib.h>

#include <cstdint>
#include <unordered_map>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/ros/storage/field_reader.hpp"

namespace wheelwright::import::ros {
namespace {

constexpr std::uint64_t record_head_bytes = 9;
constexpr std::uint64_t message_head_bytes = 22;
constexpr std::uint64_t chunk_head_bytes = 128;  // enough for its numbers and the name of its compression
constexpr std::uint64_t max_description_bytes = 16U << 20U;

enum class Operation : std::uint8_t {
  header = 0x01,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  metadata = 0x0c,
  data_end = 0x0f,
};

struct Schema {
  std::string name;
  std::string encoding;
  std::string text;
};

struct ChunkHead {
  std::uint64_t unpacked_bytes = 0;
  std::uint32_t checksum = 0;
  std::string compression;
  std::uint64_t packed_place = 0;  // from the start of the record's content
  std::uint64_t packed_bytes = 0;
};

std::optional<ChunkHead> chunk_head(std::string_view content) {
  FieldReader fields(content);
  fields.bytes(16);  // the times of its first and last message
  ChunkHead head;
  head.unpacked_bytes = fields.number<std::uint64_t>();
  head.checksum = fields.number<std::uint32_t>();
  head.compression = fields.text();
  head.packed_bytes = fields.number<std::uint64_t>();
  head.packed_place = content.size() - fields.rest().size();
  return fields.ok() ? std::optional(std::move(head)) : std::nullopt;
}

std::uint32_t checksum_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

class Scanner {
 public:
  Scanner(FileBytes& file, const std::string& label, BagRecording& recording)
      : file_(file), label_(label), recording_(recording) {}

  std::string scan_file() {
    std::uint64_t place = mcap_magic.size();
    while (!recording_.is_full() && file_.left(place) >= record_head_bytes) {
      FieldReader head(file_.view(place, record_head_bytes));
      const auto operation = static_cast<Operation>(head.number<std::uint8_t>());
      const auto length = head.number<std::uint64_t>();
      if (operation == Operation::data_end) return finish();
      const std::uint64_t content = place + record_head_bytes;
      if (operation == Operation::chunk) {
        if (!read_chunk(content, std::min(length, file_.left(content)), length)) break;
      } else if (length > file_.left(content)) {
        break;
      } else {
        read_record(file_, operation, content, length);
      }
      place = content + length;
    }
    if (!recording_.is_full()) {
      recording_.remark(label_ + "cut short or damaged at byte " + std::to_string(place) + ", after " +
                        std::to_string(recording_.messages()) + " messages: the rest is not read");
    }
    return finish();
  }

 private:
  std::string finish() {
    if (without_channel_ > 0) {
      recording_.remark(label_ + std::to_string(without_channel_) +
                        " messages are left out, since the file does not say of which topic they are");
    }
    return profile_;
  }

  void read_record(FileBytes& bytes, Operation operation, std::uint64_t place, std::uint64_t length) {
    if (operation == Operation::message) return read_message(bytes, place, length);
    if (length > max_description_bytes) return;
    if (operation != Operation::header && operation != Operation::schema && operation != Operation::channel &&
        operation != Operation::metadata) {
      return;
    }
    FieldReader fields(bytes.view(place, length));
    if (operation == Operation::header) profile_ = fields.text();
    if (operation == Operation::schema) add_schema(fields);
    if (operation == Operation::channel) add_channel(fields);
    if (operation == Operation::metadata) add_metadata(fields);
  }

  void add_schema(FieldReader fields) {
    const auto id = fields.number<std::uint16_t>();
    Schema schema;
    schema.name = fields.text();
    schema.encoding = fields.text();
    schema.text = fields.text();
    if (fields.ok()) schemas_[id] = std::move(schema);
  }

  void add_channel(FieldReader fields) {
    const auto id = fields.number<std::uint16_t>();
    const auto schema_id = fields.number<std::uint16_t>();
    TopicDescription description;
    description.topic = fields.text();
    description.message_encoding = fields.text();
    if (!fields.ok() || channels_.contains(id)) return;
    if (const auto schema = schemas_.find(schema_id); schema_id != 0 && schema != schemas_.end()) {
      description.type = schema->second.name;
      description.schema_encoding = schema->second.encoding;
      description.definition = schema->second.text;
    }
    channels_.emplace(id, recording_.topic(description));
  }

  void add_metadata(FieldReader fields) {
    const std::string name(fields.text());
    FieldReader pairs(fields.text());
    while (!pairs.rest().empty()) {
      const std::string_view key = pairs.text();
      const std::string_view value = pairs.text();
      if (!pairs.ok()) return;
      // What rosbag2 says of itself there is longer than anybody reads.
      if (name != "rosbag2") recording_.add_metadata(key, value);
    }
  }

  void read_message(FileBytes& bytes, std::uint64_t place, std::uint64_t length) {
    FieldReader fields(bytes.view(place, std::min(length, message_head_bytes)));
    const auto id = fields.number<std::uint16_t>();
    fields.bytes(4);  // its number
    const auto time_ns = fields.number<std::uint64_t>();
    fields.bytes(8);  // when it was published
    const auto channel = channels_.find(id);
    if (!fields.ok() || channel == channels_.end()) {
      ++without_channel_;
    } else if (TopicStream* topic = channel->second) {
      const std::uint64_t data_bytes = std::min(length - message_head_bytes, max_unpacked_bytes);
      recording_.add(*topic, time_ns,
                     bytes.view(place + message_head_bytes, topic->is_decoded() ? data_bytes : 0));
    }
  }

  // False where the file ends in it.
  bool read_chunk(std::uint64_t place, std::uint64_t available, std::uint64_t length) {
    const std::string name = label_ + "the chunk at byte " + std::to_string(place - record_head_bytes);
    const auto head = chunk_head(file_.view(place, std::min(available, chunk_head_bytes)));
    const bool is_cut = available < length;
    if (!head) {
      if (!is_cut) recording_.remark(name + " is damaged, and is left out");
      return !is_cut;
    }
    const auto compression = compression_named(head->compression);
    if (!compression || *compression == Compression::bz2) {
      recording_.remark(name + " is compressed by \"" + config::excerpt(head->compression) +
                        "\", which is not read; lz4 and zstd are");
      return !is_cut;
    }
    const std::uint64_t packed_bytes = std::min(head->packed_bytes, available - head->packed_place);
    if (packed_bytes > max_unpacked_bytes) {
      recording_.remark(name + " is larger than 512 MiB, and is left out");
      return !is_cut;
    }
    recording_.note_compression(head->compression);
    const std::string_view packed = file_.view(place + head->packed_place, packed_bytes);
    const Unpacked unpacked = decompressor_.unpack(*compression, packed, head->unpacked_bytes);
    if (unpacked.fault.empty() && head->checksum != 0 && checksum_of(unpacked.bytes) != head->checksum) {
      recording_.remark(name + " does not have its checksum: bytes of it are wrong, and it is left out");
      return !is_cut;
    }
    const bool is_whole = scan_chunk(unpacked.bytes) && unpacked.fault.empty();
    if (!is_cut && !is_whole) {
      recording_.remark(name + " is damaged" + (unpacked.fault.empty() ? "" : " (" + unpacked.fault + ")") +
                        ": what is before the fault is read");
    }
    return !is_cut;
  }

  // Whether all of it was read.
  bool scan_chunk(std::string_view chunk) {
    FileBytes bytes(chunk);
    std::uint64_t place = 0;
    while (place < bytes.size() && !recording_.is_full()) {
      FieldReader head(bytes.view(place, record_head_bytes));
      const auto operation = static_cast<Operation>(head.number<std::uint8_t>());
      const auto length = head.number<std::uint64_t>();
      place += record_head_bytes;
      if (!head.ok() || length > bytes.left(place)) return false;
      read_record(bytes, operation, place, length);
      place += length;
    }
    return true;
  }

  FileBytes& file_;
  const std::string& label_;
  BagRecording& recording_;
  Decompressor decompressor_;
  std::string profile_;
  std::unordered_map<std::uint16_t, Schema> schemas_;
  std::unordered_map<std::uint16_t, TopicStream*> channels_;
  std::size_t without_channel_ = 0;
};

}  // namespace

McapScan scan_mcap(FileBytes& file, const std::string& label, BagRecording& recording) {
  if (file.view(0, mcap_magic.size()) != mcap_magic)
    return {"", "is an MCAP file of another version than 0, which is not read"};
  return {Scanner(file, label, recording).scan_file(), std::nullopt};
}

std::string mcap_format(std::string_view profile) {
  if (profile == "ros2") return "ROS 2 bag (MCAP";
  if (profile == "ros1") return "ROS 1 recording (MCAP";
  return "recording (MCAP";
}

}  // namespace wheelwright::import::ros
