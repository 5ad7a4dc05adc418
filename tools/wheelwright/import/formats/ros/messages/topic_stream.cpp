#include "tools/wheelwright/import/formats/ros/messages/topic_stream.hpp"

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/ros/messages/known_definitions.hpp"

namespace wheelwright::import::ros {
namespace {

using config::excerpt;

constexpr std::size_t max_transforms = 500;
constexpr std::size_t longest_frame = 100;

double seconds_of(std::uint64_t time_ns) {
  constexpr std::uint64_t second = 1'000'000'000;
  const std::uint64_t whole_s = time_ns / second;
  return static_cast<double>(whole_s) + 1e-9 * static_cast<double>(time_ns % second);
}

std::string frame_name(std::string_view frame) {
  while (frame.starts_with('/')) frame.remove_prefix(1);
  return config::printable(frame, longest_frame);
}

tl::expected<MessageDefinition, std::string> definition_of(const TopicDescription& description) {
  const bool is_ros1 = description.message_encoding == "ros1";
  // A recorder that found no definition writes an empty one. Only this type has none that is right.
  const bool has_definition = !description.definition.empty() || description.type == "std_msgs/Empty";
  const std::string_view encoding = has_definition ? std::string_view(description.schema_encoding) : "";
  if (encoding == "ros1msg" || encoding == "ros2msg") {
    return parse_definition(description.type, description.definition,
                            encoding == "ros1msg" ? Dialect::ros1 : Dialect::ros2);
  }
  if (const auto known = is_ros1 ? std::nullopt : known_definition(description.type))
    return parse_definition(description.type, *known, Dialect::ros2);
  if (encoding.empty()) return tl::unexpected("the file has no definition of " + excerpt(description.type));
  return tl::unexpected("its definition is written in " + excerpt(encoding) + ", which is not read; " +
                        (is_ros1 ? "ros1msg" : "ros2msg") + " would be");
}

}  // namespace

TopicStream::TopicStream(const TopicDescription& description, NumberBudget& budget)
    : budget_(budget), type_(config::printable(short_type_name(description.type), 200)), table_(budget) {
  not_decoded_ = prepare(description);
}

// Why messages are not decoded; empty where they are.
std::string TopicStream::prepare(const TopicDescription& description) {
  const std::string& encoding = description.message_encoding;
  if (encoding == "json") {
    json_.emplace(table_);
    return "";
  }
  if (encoding != "ros1" && encoding != "cdr")
    return "its messages are encoded as \"" + excerpt(encoding) +
           "\", which is not read; ros1, cdr and json are";
  auto definition = definition_of(description);
  if (!definition) return definition.error();
  for (const MessageType& type : definition->types)
    table_.charge((1 + type.fields.size()) * sizeof(Field) / sizeof(double));
  auto decoder =
      MessageDecoder::make(*std::move(definition), encoding == "ros1" ? Wire::ros1 : Wire::cdr, table_);
  if (!decoder) return decoder.error();
  decoder_ = *std::move(decoder);
  return "";
}

void TopicStream::add(std::uint64_t time_ns, std::string_view message) {
  ++messages_;
  const double received_s = seconds_of(time_ns);
  if (!is_decoded()) return table_.commit_row(received_s);
  auto why = decode(received_s, message);
  if (why && faulty_++ == 0) first_fault_ = "message " + std::to_string(messages_) + " " + *why;
  if (!decoder_ || !decoder_->is_transform_list()) table_.commit_row(received_s);
}

std::optional<std::string> TopicStream::decode(double received_s, std::string_view message) {
  if (decoder_ && decoder_->is_cdr() && is_zstd(message)) {  // whose first byte is zero otherwise
    const Unpacked unpacked = decompressor_.unpack(Compression::zstd, message);
    if (!unpacked.fault.empty()) return "is compressed, and " + unpacked.fault;
    message = unpacked.bytes;
  }
  if (json_) return json_->decode(message);
  if (!decoder_->is_transform_list()) return decoder_->decode(message);
  return decoder_->decode_transforms(message, [&](std::string_view parent, std::string_view child) {
    RowTable& between = transforms_between(parent, child);
    if (&between == &table_) return table_.clear_row();
    between.take_row(table_);
    between.commit_row(received_s);
  });
}

// The table of a pair of frames; the topic's own where there are too many pairs.
RowTable& TopicStream::transforms_between(std::string_view parent, std::string_view child) {
  std::pair frames(frame_name(parent), frame_name(child));
  const auto known = transforms_.find(frames);
  if (known != transforms_.end()) return known->second;
  lacks_transforms_ = transforms_.size() >= max_transforms;
  return lacks_transforms_ ? table_ : transforms_.emplace(std::move(frames), budget_).first->second;
}

void TopicStream::finish(const std::string& stream_name, Recording& recording) {
  for (auto& [frames, table] : transforms_) {
    finish_table(table, stream_name + ":" + frames.first + "." + frames.second, "", recording);
  }
  if (faulty_ > 0 && faulty_ < messages_) {
    recording.remarks.push_back(stream_name + ": " + std::to_string(faulty_) + " of " +
                                std::to_string(messages_) +
                                " messages are damaged, and have no numbers; the first: " + first_fault_);
  }
  if (lacks_transforms_)
    recording.remarks.push_back(stream_name +
                                ": transforms between more than 500 pairs of frames are left out");
  if (!transforms_.empty()) return;
  finish_table(table_, stream_name, why_empty(), recording);
  if (!decoder_) return;
  for (const ConstantText& text : decoder_->texts()) {
    if (text.is_seen && text.is_constant && !text.first.empty())
      recording.metadata.emplace_back(stream_name + " " + text.name, config::printable(text.first));
  }
}

std::string TopicStream::why_empty() const {
  if (!is_decoded()) return not_decoded_;
  if (faulty_ > 0 && faulty_ == messages_) return first_fault_;
  const bool has_transforms = decoder_ && decoder_->is_transform_list();
  if (table_.channels() > 0 && !has_transforms) return "";
  if (messages_ == 0) return "it has no messages";
  return has_transforms ? "its messages hold no transforms" : "its messages hold no numbers";
}

void TopicStream::finish_table(RowTable& table, const std::string& name, std::string not_decoded,
                               Recording& recording) const {
  if (table.sort_by_time())
    recording.remarks.push_back(name + ": its messages were not recorded in order of time, and are sorted");
  if (table.lacks_channels()) {
    recording.remarks.push_back(name + ": has more than " + std::to_string(max_channels) +
                                " numbers in a message; the first are read");
  }
  Stream stream;
  stream.name = name;
  stream.type = type_;
  stream.not_decoded = std::move(not_decoded);
  table.move_to(stream);
  if (&table == &table_) stream.rows = messages_;
  if (!stream.not_decoded.empty()) stream.channels.clear();
  recording.streams.push_back(std::move(stream));
}

}  // namespace wheelwright::import::ros
