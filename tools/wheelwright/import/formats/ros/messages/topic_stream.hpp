// The messages of one topic, from their bytes to the streams of a recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/ros/messages/json_decoder.hpp"
#include "tools/wheelwright/import/formats/ros/messages/message_decoder.hpp"
#include "tools/wheelwright/import/formats/ros/messages/row_table.hpp"
#include "tools/wheelwright/import/formats/ros/storage/decompressor.hpp"

namespace wheelwright::import::ros {

// What a file says of a topic, in the words of MCAP (mcap.dev, "Well-known encodings").
struct TopicDescription {
  std::string topic;
  std::string type;
  std::string message_encoding;  // "ros1", "cdr", "json"
  std::string schema_encoding;   // "ros1msg", "ros2msg"; empty where there is no definition
  std::string definition;
};

class TopicStream {
 public:
  TopicStream(const TopicDescription& description, NumberBudget& budget);

  // Whether the bytes of its messages are used.
  bool is_decoded() const { return decoder_ != nullptr || json_.has_value(); }
  void add(std::uint64_t time_ns, std::string_view message);
  // Adds what was read, and what there is to say of it, to the recording.
  void finish(const std::string& stream_name, Recording& recording);

 private:
  std::string prepare(const TopicDescription& description);
  std::optional<std::string> decode(double received_s, std::string_view message);
  RowTable& transforms_between(std::string_view parent, std::string_view child);
  void finish_table(RowTable& table, const std::string& name, std::string not_decoded,
                    Recording& recording) const;
  std::string why_empty() const;

  NumberBudget& budget_;
  std::string type_;
  RowTable table_;
  std::unique_ptr<MessageDecoder> decoder_;
  std::optional<JsonDecoder> json_;
  std::string not_decoded_;
  Decompressor decompressor_;  // of messages that were compressed one by one
  std::map<std::pair<std::string, std::string>, RowTable> transforms_;  // by parent and child
  std::size_t messages_ = 0;
  std::size_t faulty_ = 0;
  std::string first_fault_;
  bool lacks_transforms_ = false;
};

}  // namespace wheelwright::import::ros
