// One recording from the messages of one bag, or of the files of a split bag one after another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/wheelwright/import/formats/ros/messages/topic_stream.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import::ros {

class BagRecording {
 public:
  // `name` stands for the bag in messages.
  explicit BagRecording(std::string name) { recording_.name = std::move(name); }

  // The stream for messages of a topic: the same for the same topic, type and encoding. Null beyond the most
  // topics that a bag may have.
  TopicStream* topic(const TopicDescription& description);
  void add(TopicStream& topic, std::uint64_t time_ns, std::string_view message) {
    topic.add(time_ns, message);
    ++messages_;
  }
  std::size_t messages() const { return messages_; }

  // Whether it holds as many numbers as it may. Reading on is of no use: finish() refuses it.
  bool is_full() const { return budget_.is_spent(); }

  void remark(std::string text);  // the same one only once
  void add_metadata(std::string_view key, std::string_view value);
  // What was used in it, for the name of its format: "zstd".
  void note_compression(std::string_view name);

  // `format` in words; the compressions are put behind it.
  ReadResult finish(std::string_view format, std::size_t files);

 private:
  Recording recording_;
  NumberBudget budget_;
  std::map<std::string, std::unique_ptr<TopicStream>> topics_;  // by all of the description
  std::vector<std::pair<std::string, TopicStream*>> in_order_;  // by name
  std::set<std::string> stream_names_;
  std::set<std::string> compressions_;
  std::size_t messages_ = 0;
};

}  // namespace wheelwright::import::ros
