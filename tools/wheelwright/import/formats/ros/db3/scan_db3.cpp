#include "tools/wheelwright/import/formats/ros/db3/scan_db3.hpp"

#include <cstdint>
#include <map>
#include <unordered_map>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/ros/db3/database.hpp"

namespace wheelwright::import::ros {
namespace {

using Topics = std::unordered_map<std::int64_t, TopicStream*>;

struct Definition {
  std::string encoding;
  std::string text;
};

std::map<std::string, Definition, std::less<>> read_definitions(Database& database) {
  std::map<std::string, Definition, std::less<>> definitions;
  if (!database.has_table("message_definitions")) return definitions;
  Query rows =
      database.query("SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
  while (rows.next_row()) {
    Definition definition{std::string(rows.bytes(1)), std::string(rows.bytes(2))};
    // rosbag2 writes a row without a definition where it found none.
    if (definition.encoding.starts_with("ros2")) definitions.emplace(rows.bytes(0), std::move(definition));
  }
  return definitions;
}

Topics read_topics(Database& database, BagRecording& recording) {
  const auto definitions = read_definitions(database);
  Topics topics;
  Query rows = database.query("SELECT id, name, type, serialization_format FROM topics");
  while (rows.next_row()) {
    TopicDescription description{std::string(rows.bytes(1)), std::string(rows.bytes(2)),
                                 std::string(rows.bytes(3)), "", ""};
    if (const auto known = definitions.find(description.type); known != definitions.end()) {
      description.schema_encoding = known->second.encoding;
      description.definition = known->second.text;
    }
    topics.emplace(rows.integer(0), recording.topic(description));
  }
  return topics;
}

// Large messages that nobody decodes stay on the disk.
std::string message_query(const Topics& topics) {
  std::string decoded;
  for (const auto& [id, topic] : topics) {
    if (topic != nullptr && topic->is_decoded()) decoded += (decoded.empty() ? "" : ",") + std::to_string(id);
  }
  return "SELECT topic_id, timestamp, CASE WHEN topic_id IN (" + decoded + ") THEN data END FROM messages";
}

void read_messages(Database& database, const Topics& topics, const std::string& label,
                   BagRecording& recording) {
  Query rows = database.query(message_query(topics));
  std::size_t without_topic = 0;
  while (!recording.is_full() && rows.next_row()) {
    const auto topic = topics.find(rows.integer(0));
    if (topic == topics.end()) {
      ++without_topic;
    } else if (topic->second != nullptr) {
      recording.add(*topic->second, static_cast<std::uint64_t>(rows.integer(1)), rows.bytes(2));
    }
  }
  if (without_topic > 0) {
    recording.remark(label + std::to_string(without_topic) +
                     " messages are left out, since the file does not say of which topic they are");
  }
  if (!rows.has_ended() && !recording.is_full()) {
    recording.remark(label + "cut short or damaged after " + std::to_string(recording.messages()) +
                     " messages (" + config::excerpt(database.fault()) + "): the rest is not read");
  }
}

// A recorder that was killed may leave its last rows in a log beside the file, which a reader that writes
// nothing cannot put in.
void remark_log_beside(const std::filesystem::path& path, const std::string& label, BagRecording& recording) {
  std::error_code error;
  const std::filesystem::path log = path.string() + "-wal";
  const auto bytes = std::filesystem::file_size(log, error);
  if (error || bytes == 0) return;
  recording.remark(label + "its last messages may lie in " + config::excerpt(log.filename().string()) +
                   ", which is not read; open a copy of both with sqlite3 to bring them in");
}

}  // namespace

std::optional<std::string> scan_db3(const std::filesystem::path& path, const std::string& label,
                                    BagRecording& recording) {
  auto database = Database::open(path);
  if (!database) return database.error();
  if (!database->has_table("topics") || !database->has_table("messages"))
    return "is an SQLite file that lacks the tables \"topics\" and \"messages\" of a ROS 2 bag, or is "
           "damaged";
  remark_log_beside(path, label, recording);
  const Topics topics = read_topics(*database, recording);
  read_messages(*database, topics, label, recording);
  return std::nullopt;
}

}  // namespace wheelwright::import::ros
