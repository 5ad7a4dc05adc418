#include "tools/wheelwright/import/formats/ros/bag1/scan_bag1.hpp"

#include <cstring>
#include <unordered_map>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/ros/storage/field_reader.hpp"

namespace wheelwright::import::ros {
namespace {

constexpr std::string_view magic = "#ROSBAG V2.0\n";
constexpr std::uint64_t length_bytes = 4;
constexpr std::uint64_t longest_header = 1U << 20U;
constexpr std::uint64_t max_record_bytes = max_unpacked_bytes;

enum class Operation : std::uint8_t { message = 2, bag_header = 3, chunk = 5, connection = 7 };

// The fields "name=value" of the header of a record, or of the data of a connection.
template <typename Handler>
bool for_each_field(std::string_view header, Handler handle) {
  FieldReader fields(header);
  while (!fields.rest().empty()) {
    const std::string_view field = fields.text();
    const auto equals = field.find('=');
    if (!fields.ok() || equals == std::string_view::npos) return false;
    handle(field.substr(0, equals), field.substr(equals + 1));
  }
  return true;
}

template <typename Number>
Number number_of(std::string_view value) {
  return FieldReader(value).number<Number>();
}

struct RecordHeader {
  std::uint8_t operation = 0;
  std::uint32_t connection = 0;
  std::uint64_t time_ns = 0;
  std::uint64_t index_place = 0;
  std::uint32_t unpacked_bytes = 0;
  std::string compression;
  std::string topic;
  bool is_encrypted = false;

  void set(std::string_view name, std::string_view value) {
    if (name == "op") operation = number_of<std::uint8_t>(value);
    if (name == "conn") connection = number_of<std::uint32_t>(value);
    if (name == "size") unpacked_bytes = number_of<std::uint32_t>(value);
    if (name == "index_pos") index_place = number_of<std::uint64_t>(value);
    if (name == "compression") compression = value;
    if (name == "topic") topic = value;
    if (name == "encryptor") is_encrypted = !value.empty();
    if (name == "time") {
      FieldReader time(value);
      const std::uint64_t seconds = time.number<std::uint32_t>();
      time_ns = seconds * 1'000'000'000 + time.number<std::uint32_t>();
    }
  }
};

struct Record {
  RecordHeader header;
  std::uint64_t data_place = 0;
  std::uint64_t data_bytes = 0;
};

// The record at a place; nothing where it is damaged or its header cut short.
std::optional<Record> record_at(FileBytes& bytes, std::uint64_t place) {
  const auto header_bytes = FieldReader(bytes.view(place, length_bytes)).number<std::uint32_t>();
  const std::uint64_t before_data = length_bytes + header_bytes + length_bytes;
  if (header_bytes > longest_header || bytes.left(place) < before_data) return std::nullopt;
  FieldReader fields(bytes.view(place + length_bytes, header_bytes + length_bytes));
  Record record;
  const bool is_header = for_each_field(fields.bytes(header_bytes),
                                        [&](auto name, auto value) { record.header.set(name, value); });
  record.data_bytes = fields.number<std::uint32_t>();
  record.data_place = place + before_data;
  return is_header && fields.ok() ? std::optional(std::move(record)) : std::nullopt;
}

class Scanner {
 public:
  Scanner(FileBytes& file, const std::string& label, BagRecording& recording)
      : file_(file), label_(label), recording_(recording) {}

  std::optional<std::string> scan_file() {
    std::uint64_t place = magic.size();
    while (place < file_.size() && !recording_.is_full()) {
      const auto record = record_at(file_, place);
      if (!record) {
        remark_end(place);
        return std::nullopt;
      }
      if (record->header.is_encrypted)
        return "is encrypted; decrypt it first (rosbag decompress, rosbag encrypt)";
      if (is(*record, Operation::chunk)) {
        place = read_chunk(*record, place);
        continue;
      }
      if (is(*record, Operation::bag_header)) is_closed_ = record->header.index_place > 0;
      if (file_.left(record->data_place) < record->data_bytes) {
        remark_end(place);
        return std::nullopt;
      }
      read_record(file_, *record);
      place = record->data_place + record->data_bytes;
    }
    finish();
    return std::nullopt;
  }

 private:
  static bool is(const Record& record, Operation operation) {
    return record.header.operation == static_cast<std::uint8_t>(operation);
  }

  // A connection or a message; others are of the index.
  void read_record(FileBytes& bytes, const Record& record) {
    if (is(record, Operation::connection)) {
      if (record.data_bytes <= longest_header)
        add_connection(record.header, bytes.view(record.data_place, record.data_bytes));
    } else if (is(record, Operation::message)) {
      const auto connection = connections_.find(record.header.connection);
      if (connection == connections_.end()) {
        ++without_connection_;
      } else if (TopicStream* topic = connection->second) {
        const std::uint64_t used = topic->is_decoded() ? std::min(record.data_bytes, max_record_bytes) : 0;
        recording_.add(*topic, record.header.time_ns, bytes.view(record.data_place, used));
      }
    }
  }

  void add_connection(const RecordHeader& header, std::string_view data) {
    if (connections_.contains(header.connection)) return;  // once more, in the index
    TopicDescription description{header.topic, "", "ros1", "ros1msg", ""};
    for_each_field(data, [&](auto name, auto value) {
      if (name == "type") description.type = value;
      if (name == "message_definition") description.definition = value;
    });
    connections_.emplace(header.connection, recording_.topic(description));
  }

  // Returns the place behind it.
  std::uint64_t read_chunk(const Record& record, std::uint64_t place) {
    const std::uint64_t left = file_.left(record.data_place);
    const auto compression = compression_named(record.header.compression);
    const bool is_open = record.data_bytes == 0 && record.header.unpacked_bytes == 0;
    if (is_open && compression == Compression::none) return record.data_place;  // its records follow
    const std::uint64_t bytes = is_open ? left : std::min(record.data_bytes, left);
    const std::uint64_t behind = record.data_place + bytes;
    const std::string name = "the chunk at byte " + std::to_string(place);
    if (!compression) {
      recording_.remark(label_ + name + " is compressed by \"" + config::excerpt(record.header.compression) +
                        "\", which is not read; none, bz2 and lz4 are");
      return behind;
    }
    if (bytes > max_unpacked_bytes) {
      recording_.remark(label_ + name + " is larger than 512 MiB, and is left out");
      return behind;
    }
    recording_.note_compression(record.header.compression);
    const std::string_view packed = file_.view(record.data_place, bytes);
    const Unpacked unpacked = is_open
                                  ? decompressor_.unpack(*compression, packed)
                                  : decompressor_.unpack(*compression, packed, record.header.unpacked_bytes);
    const bool is_whole = scan_chunk(unpacked.bytes) && unpacked.fault.empty();
    if (is_open || bytes < record.data_bytes) {
      remark_end(place);
    } else if (!is_whole) {
      recording_.remark(label_ + name + " is damaged" +
                        (unpacked.fault.empty() ? "" : " (" + unpacked.fault + ")") +
                        ": what is before the fault is read");
    }
    return behind;
  }

  // Whether all of it was read.
  bool scan_chunk(std::string_view chunk) {
    FileBytes bytes(chunk);
    std::uint64_t place = 0;
    while (place < bytes.size() && !recording_.is_full()) {
      const auto record = record_at(bytes, place);
      if (!record || bytes.left(record->data_place) < record->data_bytes) return false;
      read_record(bytes, *record);
      place = record->data_place + record->data_bytes;
    }
    return true;
  }

  void remark_end(std::uint64_t place) {
    recording_.remark(label_ + "cut short or damaged at byte " + std::to_string(place) + ", after " +
                      std::to_string(recording_.messages()) + " messages: the rest is not read");
    finish();
  }

  void finish() {
    if (!is_closed_) {
      recording_.remark(label_ + "the bag was not closed; it is read without its index");
      is_closed_ = true;
    }
    if (without_connection_ == 0) return;
    recording_.remark(label_ + std::to_string(without_connection_) +
                      " messages are left out, since the bag does not say of which topic they are");
    without_connection_ = 0;
  }

  FileBytes& file_;
  const std::string& label_;
  BagRecording& recording_;
  Decompressor decompressor_;
  std::unordered_map<std::uint32_t, TopicStream*> connections_;
  std::size_t without_connection_ = 0;
  bool is_closed_ = true;
};

}  // namespace

std::optional<std::string> scan_bag1(FileBytes& file, const std::string& label, BagRecording& recording) {
  const std::string head(file.view(0, magic.size()));
  if (head != magic) {
    return "is a ROS bag of a version before 2.0 (\"" + config::excerpt(head.substr(0, head.find('\n'))) +
           "\"), which is not read; rosbag fix makes one of 2.0";
  }
  return Scanner(file, label, recording).scan_file();
}

}  // namespace wheelwright::import::ros
