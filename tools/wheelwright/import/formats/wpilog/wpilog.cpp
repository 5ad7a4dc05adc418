#include "tools/wheelwright/import/formats/wpilog/wpilog.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/little_endian.hpp"

namespace wheelwright::import {
namespace {

constexpr std::string_view magic = "WPILOG";
constexpr std::size_t header_bytes = 12;
constexpr std::size_t max_array = 4096;
constexpr std::size_t max_entries = 10'000;
constexpr std::size_t max_padding = 20'000'000;  // values that stand for none
constexpr std::size_t max_remarks = 30;

enum class Control : std::uint8_t { start = 0, finish = 1, set_metadata = 2 };

struct ValueType {
  std::string_view name;
  std::size_t bytes = 0;
  double (*read)(std::string_view bytes) = nullptr;
};

constexpr std::array<ValueType, 4> value_types{{
    {"double", 8, [](std::string_view bytes) { return double_of(little_endian(bytes)); }},
    {"float", 4, [](std::string_view bytes) { return float_of(little_endian(bytes)); }},
    {"int64", 8,
     [](std::string_view bytes) {
       return static_cast<double>(static_cast<std::int64_t>(little_endian(bytes)));
     }},
    {"boolean", 1, [](std::string_view bytes) { return bytes.front() != '\0' ? 1.0 : 0.0; }},
}};

const ValueType* find_type(std::string_view name) {
  for (const ValueType& type : value_types) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

struct Entry {
  Stream stream;  // its first channel is the timestamp where it is decoded
  const ValueType* type = nullptr;
  bool is_array = false;
  std::size_t wrong_sizes = 0;
  std::size_t first_wrong = 0;  // byte offset
  std::size_t too_long = 0;     // arrays for which the others would have to be filled up too far
};

struct Record {
  std::uint64_t entry = 0;
  std::int64_t timestamp_us = 0;
  std::string_view payload;
  std::size_t offset = 0;
};

class Reader {
 public:
  Reader(std::string_view bytes, std::string name) : bytes_(bytes) { recording_.name = std::move(name); }

  ReadResult read() {
    if (bytes_.size() < header_bytes) return fail("cut short within its header of 12 bytes");
    const auto major = static_cast<std::uint8_t>(bytes_[7]);
    const auto minor = static_cast<std::uint8_t>(bytes_[6]);
    if (major != 1) {
      return fail("WPILOG of version " + std::to_string(major) + "." + std::to_string(minor) +
                  "; only version 1 is known");
    }
    const std::uint64_t extra = little_endian(bytes_.substr(8, 4));
    if (extra > bytes_.size() - header_bytes) return fail("cut short within its extra header");
    if (extra > 0)
      recording_.metadata.emplace_back("header", std::string(bytes_.substr(header_bytes, extra)));
    at_ = header_bytes + extra;
    while (const auto record = next_record()) take(*record);
    return finish();
  }

 private:
  tl::unexpected<std::string> fail(const std::string& what) const {
    return tl::unexpected<std::string>(recording_.name + ": " + what);
  }

  void remark(std::string text) {
    if (recording_.remarks.size() < max_remarks) recording_.remarks.push_back(std::move(text));
  }

  // Two bits for the length of the entry's number, two for that of the size, three for that of the timestamp.
  std::optional<Record> next_record() {
    if (at_ == bytes_.size()) return std::nullopt;
    const auto lengths = static_cast<std::uint8_t>(bytes_[at_]);
    const std::size_t entry_bytes = (lengths & 3U) + 1U;
    const std::size_t size_bytes = ((lengths >> 2U) & 3U) + 1U;
    const std::size_t time_bytes = ((lengths >> 4U) & 7U) + 1U;
    const std::size_t head = 1 + entry_bytes + size_bytes + time_bytes;
    if (head > bytes_.size() - at_) return cut();
    const std::uint64_t size = little_endian(bytes_.substr(at_ + 1 + entry_bytes, size_bytes));
    if (size > bytes_.size() - at_ - head) return cut();
    Record record;
    record.offset = at_;
    record.entry = little_endian(bytes_.substr(at_ + 1, entry_bytes));
    record.timestamp_us = static_cast<std::int64_t>(
        little_endian(bytes_.substr(at_ + 1 + entry_bytes + size_bytes, time_bytes)));
    record.payload = bytes_.substr(at_ + head, size);
    at_ += head + size;
    ++records_;
    return record;
  }

  std::nullopt_t cut() {
    remark("byte " + std::to_string(at_) + ": cut short after " + std::to_string(records_) +
           " records: the rest cannot be read");
    return std::nullopt;
  }

  void take(const Record& record) {
    if (record.entry == 0) {
      take_control(record);
      return;
    }
    const auto found = running_.find(record.entry);
    if (found == running_.end()) {
      if (strays_++ == 0) first_stray_ = record.offset;
      return;
    }
    Entry& entry = entries_[found->second];
    ++entry.stream.rows;
    if (entry.type != nullptr) take_values(record, entry);
  }

  // Shorter arrays are filled up, which must not take memory without bound: what would take too much is left
  // out, and takes nothing.
  bool take_padding(std::size_t count, Entry& entry) {
    const std::size_t places = entry.stream.channels.size() - 1;
    const std::size_t rows_before = entry.stream.rows - 1;
    const std::size_t more = count < places ? places - count : (count - places) * rows_before;
    if (more > max_padding - padding_) {
      ++entry.too_long;
      return false;
    }
    padding_ += more;
    return true;
  }

  void take_values(const Record& record, Entry& entry) {
    const std::size_t size = entry.type->bytes;
    const std::size_t count = record.payload.size() / size;
    const bool fits =
        count * size == record.payload.size() && (entry.is_array ? count <= max_array : count == 1);
    if (!fits && entry.wrong_sizes++ == 0) entry.first_wrong = record.offset;
    if (!fits || !take_padding(count, entry)) {
      --entry.stream.rows;
      return;
    }
    auto& channels = entry.stream.channels;
    const std::size_t rows_before = entry.stream.rows - 1;
    while (channels.size() < count + 1) {
      const std::string place = "[" + std::to_string(channels.size() - 1) + "]";
      channels.push_back(
          {place, {}, std::vector<double>(rows_before, std::numeric_limits<double>::quiet_NaN())});
    }
    channels[0].values.push_back(static_cast<double>(record.timestamp_us));
    for (std::size_t i = 1; i < channels.size(); ++i) {
      const bool is_there = i <= count;
      channels[i].values.push_back(is_there ? entry.type->read(record.payload.substr((i - 1) * size, size))
                                            : std::numeric_limits<double>::quiet_NaN());
    }
  }

  void take_control(const Record& record) {
    const std::string_view payload = record.payload;
    if (payload.size() < 5) {
      remark("byte " + std::to_string(record.offset) + ": a control record of " +
             std::to_string(payload.size()) + " bytes, left out");
      return;
    }
    const std::uint64_t entry = little_endian(payload.substr(1, 4));
    switch (static_cast<Control>(payload.front())) {
      case Control::start:
        start(record, entry);
        break;
      case Control::finish:
        running_.erase(entry);
        break;
      case Control::set_metadata:
        set_metadata(payload.substr(5), entry);
        break;
      default:
        remark("byte " + std::to_string(record.offset) + ": a control record of unknown kind, left out");
    }
  }

  // Text behind its length in four bytes.
  static std::optional<std::string> take_text(std::string_view& payload) {
    if (payload.size() < 4) return std::nullopt;
    const std::uint64_t length = little_endian(payload.substr(0, 4));
    if (length > payload.size() - 4) return std::nullopt;
    std::string text(payload.substr(4, length));
    payload.remove_prefix(4 + length);
    return text;
  }

  // An entry that was finished goes on where one of its name and type starts.
  void start(const Record& record, std::uint64_t number) {
    std::string_view rest = record.payload.substr(5);
    const auto name = take_text(rest);
    const auto type = take_text(rest);
    const auto metadata = take_text(rest);
    if (!name || !type || !metadata) {
      remark("byte " + std::to_string(record.offset) + ": a start record whose texts are cut, left out");
      return;
    }
    if (!metadata->empty() && metadata_bytes_ < max_metadata_bytes) {
      metadata_bytes_ += metadata->size();
      recording_.metadata.emplace_back(*name, *metadata);
    }
    const auto known = numbers_.find({*name, *type});
    if (known != numbers_.end()) {
      running_[number] = known->second;
    } else if (entries_.size() < max_entries) {
      numbers_[{*name, *type}] = entries_.size();
      running_[number] = entries_.size();
      entries_.push_back(make_entry(*name, *type));
    } else {
      remark("byte " + std::to_string(record.offset) + ": more than " + std::to_string(max_entries) +
             " entries: the further ones are left out");
    }
  }

  static Entry make_entry(const std::string& name, const std::string& type) {
    Entry entry;
    entry.stream.name = name;
    entry.stream.type = type;
    entry.is_array = type.ends_with("[]");
    entry.type = find_type(std::string_view(type).substr(0, type.size() - (entry.is_array ? 2 : 0)));
    if (entry.type == nullptr) {
      entry.stream.not_decoded = "values of type '" + config::excerpt(type) + "' are not read";
    } else {
      entry.stream.channels.push_back({"timestamp", "us", {}});
      if (!entry.is_array) entry.stream.channels.push_back({"value", {}, {}});
    }
    return entry;
  }

  void set_metadata(std::string_view rest, std::uint64_t number) {
    const auto found = running_.find(number);
    const auto text = take_text(rest);
    if (found == running_.end() || !text || metadata_bytes_ >= max_metadata_bytes) return;
    metadata_bytes_ += text->size();
    recording_.metadata.emplace_back(entries_[found->second].stream.name, *text);
  }

  ReadResult finish() {
    if (strays_ > 0) {
      remark(std::to_string(strays_) + " records of entries that were not started, the first at byte " +
             std::to_string(first_stray_) + ": left out");
    }
    for (Entry& entry : entries_) {
      if (entry.wrong_sizes > 0) {
        remark("'" + config::excerpt(entry.stream.name) + "': " + std::to_string(entry.wrong_sizes) +
               " records whose size is none of '" + config::excerpt(entry.stream.type) +
               "', the first at byte " + std::to_string(entry.first_wrong) + ": left out");
      }
      if (entry.too_long > 0) {
        remark("'" + config::excerpt(entry.stream.name) + "': " + std::to_string(entry.too_long) +
               " arrays of another length than those before, for which there is no memory: left out");
      }
      if (entry.stream.rows > 0) recording_.streams.push_back(std::move(entry.stream));
    }
    if (recording_.streams.empty()) return fail("holds no records of values");
    recording_.format =
        "WPILOG (FRC data log), version 1." + std::to_string(static_cast<unsigned char>(bytes_[6]));
    return std::move(recording_);
  }

  static constexpr std::size_t max_metadata_bytes = 1U << 20U;

  std::string_view bytes_;
  Recording recording_;
  std::size_t at_ = 0;
  std::size_t records_ = 0;
  std::vector<Entry> entries_;
  std::map<std::uint64_t, std::size_t> running_;
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
  std::size_t metadata_bytes_ = 0;
  std::size_t padding_ = 0;
  std::size_t strays_ = 0;
  std::size_t first_stray_ = 0;
};

}  // namespace

bool is_wpilog(std::string_view head) {
  return head.starts_with(magic);
}

ReadResult read_wpilog(std::string_view bytes, std::string name) {
  return Reader(bytes, std::move(name)).read();
}

}  // namespace wheelwright::import
