#include "tools/wheelwright/import/formats/ros/bag_recording.hpp"

#include <algorithm>

#include "config/load/printable_text.hpp"

namespace wheelwright::import::ros {
namespace {

constexpr std::size_t max_topics = 2000;
constexpr std::size_t max_remarks = 100;
constexpr std::size_t max_metadata = 200;
constexpr std::size_t longest_name = 200;

}  // namespace

TopicStream* BagRecording::topic(const TopicDescription& description) {
  // Split files and restarted publishers describe a topic again, some with comments that differ.
  const std::string name = config::printable(description.topic, longest_name);
  const std::string type = config::printable(short_type_name(description.type), longest_name);
  const auto known = topics_.find(name + '\n' + type + '\n' + description.message_encoding);
  if (known != topics_.end()) return known->second.get();
  if (topics_.size() >= max_topics) {
    remark("has more than " + std::to_string(max_topics) + " topics; those described later are left out");
    return nullptr;
  }
  std::string stream_name = name;
  if (!stream_names_.insert(stream_name).second) {
    stream_name += " (" + type + ")";
    remark(name + ": has messages of several types, each a stream of its own");
  }
  auto stream = std::make_unique<TopicStream>(description, budget_);
  in_order_.emplace_back(stream_name, stream.get());
  return topics_.emplace(name + '\n' + type + '\n' + description.message_encoding, std::move(stream))
      .first->second.get();
}

void BagRecording::remark(std::string text) {
  if (std::ranges::find(recording_.remarks, text) != recording_.remarks.end()) return;
  if (recording_.remarks.size() < max_remarks) recording_.remarks.push_back(std::move(text));
}

void BagRecording::add_metadata(std::string_view key, std::string_view value) {
  if (recording_.metadata.size() < max_metadata)
    recording_.metadata.emplace_back(config::printable(key, longest_name), config::printable(value));
}

void BagRecording::note_compression(std::string_view name) {
  if (!name.empty() && name != "none") compressions_.emplace(name);
}

ReadResult BagRecording::finish(std::string_view format, std::size_t files) {
  if (is_full()) {
    return tl::unexpected(recording_.name + ": holds more than " + std::to_string(budget_.most / 1'000'000) +
                          " million numbers, which is all that is kept in memory; record fewer topics, or "
                          "split it (rosbag filter, ros2 bag convert)");
  }
  recording_.format = format;
  for (const std::string& compression : compressions_) recording_.format += ", " + compression;
  if (files > 1) recording_.format += ", " + std::to_string(files) + " files";
  recording_.format += ")";
  for (const auto& [name, stream] : in_order_) stream->finish(name, recording_);
  return std::move(recording_);
}

}  // namespace wheelwright::import::ros
