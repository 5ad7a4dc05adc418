#include "daemon/recording/mcap/writer.hpp"

#include <zstd.h>

#include <algorithm>

#include "daemon/recording/mcap/bytes.hpp"
#include "daemon/recording/mcap/crc32.hpp"

namespace wheelwright::mcap {
namespace {

constexpr std::string_view magic = "\x89MCAP0\r\n";
constexpr int zstd_level = 1;                  // the fastest; JSON shrinks to a tenth all the same
constexpr std::size_t index_entry_bytes = 16;  // of a message: time and offset

enum Kind : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema_kind = 0x03,
  channel_kind = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics_kind = 0x0b,
  metadata_kind = 0x0c,
  metadata_index = 0x0d,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

std::string record(Kind kind, std::string_view content) {
  std::string text;
  put_record(text, kind, content);
  return text;
}

std::string text_map(const std::map<std::string, std::string>& map) {
  std::string entries;
  for (const auto& [key, value] : map) {
    put_text(entries, key);
    put_text(entries, value);
  }
  return entries;
}

std::string metadata_record(const std::map<std::string, std::string>& metadata) {
  std::string content;
  put_text(content, "wheelwright");
  put_text(content, text_map(metadata));
  return record(metadata_kind, content);
}

// Empty where the library refuses.
std::string compressed(const std::string& bytes) {
  std::string result(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), zstd_level);
  result.resize(ZSTD_isError(size) != 0 ? 0 : size);
  return result;
}

}  // namespace

void Writer::TimeSpan::include(std::uint64_t time_ns) {
  include(TimeSpan{time_ns, time_ns, false});
}

void Writer::TimeSpan::include(const TimeSpan& other) {
  if (other.empty) return;
  first_ns = empty ? other.first_ns : std::min(first_ns, other.first_ns);
  last_ns = empty ? other.last_ns : std::max(last_ns, other.last_ns);
  empty = false;
}

Writer::Writer(Sink sink, const std::map<std::string, std::string>& metadata, const WriterOptions& options)
    : sink_(std::move(sink)), options_(options) {
  std::string content;
  put_text(content, "");  // profile: none of the well-known ones
  put_text(content, "wheelwright");
  std::string head(magic);
  head += record(header, content);
  const std::string metadata_bytes = metadata_record(metadata);
  std::string index;
  put(index, static_cast<std::uint64_t>(head.size()));
  put(index, static_cast<std::uint64_t>(metadata_bytes.size()));
  put_text(index, "wheelwright");
  metadata_index_ = record(metadata_index, index);
  give(head + metadata_bytes);
}

std::uint16_t Writer::add_channel(const std::string& topic, const std::string& schema_name,
                                  const std::string& schema) {
  auto known = std::ranges::find(schemas_, schema_name, &Schema::name);
  if (known == schemas_.end()) {
    std::string content;
    put(content, static_cast<std::uint16_t>(schemas_.size() + 1));
    put_text(content, schema_name);
    put_text(content, "jsonschema");
    put_text(content, schema);
    known = schemas_.insert(schemas_.end(), {schema_name, record(schema_kind, content), {}});
  }
  Channel channel;
  channel.schema = static_cast<std::uint16_t>(known - schemas_.begin());
  const auto id = static_cast<std::uint16_t>(channels_.size());
  std::string content;
  put(content, id);
  put(content, static_cast<std::uint16_t>(channel.schema + 1));
  put_text(content, topic);
  put_text(content, "json");
  put_text(content, "");  // no metadata
  channel.record = record(channel_kind, content);
  channels_.push_back(std::move(channel));
  return id;
}

// What a message needs before it, in the open chunk unless an earlier one has it.
void Writer::declare(Channel& channel) {
  Schema& schema = schemas_[channel.schema];
  if (!schema.declared_in) open_chunk_ += schema.record;
  if (!schema.declared_in) schema.declared_in = chunk_number_;
  if (!channel.declared_in) open_chunk_ += channel.record;
  if (!channel.declared_in) channel.declared_in = chunk_number_;
}

void Writer::add(std::uint16_t id, std::uint64_t time_ns, std::string_view json) {
  Channel& channel = channels_[id];
  declare(channel);
  put(channel.index, time_ns);
  put(channel.index, static_cast<std::uint64_t>(open_chunk_.size()));
  constexpr std::uint64_t fixed_bytes = 2 + 4 + 8 + 8;
  put(open_chunk_, std::uint8_t{message});
  put(open_chunk_, fixed_bytes + json.size());
  put(open_chunk_, id);
  put(open_chunk_, channel.messages++);
  put(open_chunk_, time_ns);
  put(open_chunk_, time_ns);
  open_chunk_ += json;
  chunk_span_.include(time_ns);
  ++chunk_messages_;
  if (open_chunk_.size() >= options_.chunk_bytes) end_chunk();
}

bool Writer::give(std::string_view bytes) {
  if (!sink_(bytes)) return false;
  offset_ += bytes.size();
  crc_ = crc32(bytes, crc_);
  return true;
}

void Writer::end_chunk() {
  if (chunk_messages_ == 0) return;
  const std::string packed = options_.compress ? compressed(open_chunk_) : "";
  const Stored stored{packed.empty() ? "" : "zstd", packed.empty() ? open_chunk_ : packed};
  std::string block = chunk_record(stored);
  const std::string index = add_message_indexes(stored, block);
  const bool kept = give(block);
  if (kept) {
    chunk_indexes_ += index;
    file_span_.include(chunk_span_);
    ++chunks_;
  } else {
    lost_messages_ += chunk_messages_;
  }
  for (Channel& channel : channels_) {
    if (kept) channel.kept_messages += channel.index.size() / index_entry_bytes;
    channel.index.clear();
    // A reader that never sees this chunk has to hear of its channels in the next one.
    if (!kept && channel.declared_in == chunk_number_) channel.declared_in.reset();
  }
  for (Schema& schema : schemas_) {
    if (!kept && schema.declared_in == chunk_number_) schema.declared_in.reset();
  }
  open_chunk_.clear();
  chunk_span_ = {};
  chunk_messages_ = 0;
  ++chunk_number_;
}

std::string Writer::chunk_record(const Stored& stored) const {
  std::string content;
  content.reserve(stored.bytes.size() + 64);
  put(content, chunk_span_.first_ns);
  put(content, chunk_span_.last_ns);
  put(content, std::uint64_t{open_chunk_.size()});
  put(content, crc32(open_chunk_));
  put_text(content, stored.compression);
  put(content, std::uint64_t{stored.bytes.size()});
  content += stored.bytes;
  return record(chunk, content);
}

// Adds the message indexes to `block`, which holds the chunk so far. Returns the chunk's entry in the
// summary.
std::string Writer::add_message_indexes(const Stored& stored, std::string& block) const {
  const std::uint64_t chunk_length = block.size();
  std::string places;
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    if (channels_[id].index.empty()) continue;
    put(places, static_cast<std::uint16_t>(id));
    put(places, offset_ + block.size());
    std::string content;
    put(content, static_cast<std::uint16_t>(id));
    put_text(content, channels_[id].index);
    put_record(block, message_index, content);
  }
  std::string content;
  put(content, chunk_span_.first_ns);
  put(content, chunk_span_.last_ns);
  put(content, offset_);
  put(content, chunk_length);
  put_text(content, places);
  put(content, block.size() - chunk_length);
  put_text(content, stored.compression);
  put(content, std::uint64_t{stored.bytes.size()});
  put(content, std::uint64_t{open_chunk_.size()});
  return record(chunk_index, content);
}

std::string Writer::statistics() const {
  std::uint64_t messages = 0;
  std::string counts;
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    messages += channels_[id].kept_messages;
    put(counts, static_cast<std::uint16_t>(id));
    put(counts, channels_[id].kept_messages);
  }
  std::string content;
  put(content, messages);
  put(content, static_cast<std::uint16_t>(schemas_.size()));
  put(content, static_cast<std::uint32_t>(channels_.size()));
  put(content, std::uint32_t{0});  // attachments
  put(content, std::uint32_t{1});  // metadata
  put(content, chunks_);
  put(content, file_span_.first_ns);
  put(content, file_span_.last_ns);
  put_text(content, counts);
  return record(statistics_kind, content);
}

// Summary, summary offsets and footer, for a file in which they begin at `start`.
std::string Writer::summary(std::uint64_t start) const {
  std::string schemas;
  for (const Schema& schema : schemas_) schemas += schema.record;
  std::string channels;
  for (const Channel& channel : channels_) channels += channel.record;
  const std::pair<Kind, std::string> groups[] = {{schema_kind, schemas},
                                                 {channel_kind, channels},
                                                 {statistics_kind, statistics()},
                                                 {chunk_index, chunk_indexes_},
                                                 {metadata_index, metadata_index_}};
  std::string text;
  std::string offsets;
  for (const auto& [kind, records] : groups) {
    if (records.empty()) continue;
    std::string content;
    put(content, std::uint8_t{kind});
    put(content, start + text.size());
    put(content, std::uint64_t{records.size()});
    put_record(offsets, summary_offset, content);
    text += records;
  }
  const std::uint64_t offsets_start = start + text.size();
  text += offsets;
  constexpr std::uint64_t footer_bytes = 8 + 8 + 4;
  put(text, std::uint8_t{footer});
  put(text, footer_bytes);
  put(text, start);
  put(text, offsets_start);
  put(text, crc32(text));
  text += magic;
  return text;
}

bool Writer::finish() {
  end_chunk();
  std::string content;
  put(content, crc_);
  const std::string end = record(data_end, content);
  return give(end + summary(offset_ + end.size()));
}

}  // namespace wheelwright::mcap
