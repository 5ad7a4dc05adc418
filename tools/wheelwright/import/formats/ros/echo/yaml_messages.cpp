#include "tools/wheelwright/import/formats/ros/echo/yaml_messages.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "tools/wheelwright/import/formats/ros/messages/field_program.hpp"
#include "tools/wheelwright/import/formats/ros/messages/known_definitions.hpp"
#include "tools/wheelwright/import/formats/ros/messages/row_table.hpp"
#include "tools/wheelwright/import/formats/text/line_cursor.hpp"
#include "tools/wheelwright/import/formats/text/line_tally.hpp"
#include "tools/wheelwright/import/formats/text/number_text.hpp"

namespace wheelwright::import::ros {
namespace {

constexpr std::size_t longest_message = 1U << 20U;
constexpr std::size_t longest_path = 200;
constexpr int deepest_level = 16;

std::optional<double> number_in(const YAML::Node& node) {
  if (!node || !node.IsScalar()) return std::nullopt;
  const std::string& text = node.Scalar();
  if (text == "true" || text == "True") return 1.0;
  if (text == "false" || text == "False") return 0.0;
  return read_number(text, '.');
}

// Seconds, where the node is a time: ROS 1 prints "secs" and "nsecs", ROS 2 "sec" and "nanosec".
std::optional<double> time_in(const YAML::Node& map) {
  constexpr double nanosecond_s = 1e-9;
  if (map.size() != 2) return std::nullopt;
  const auto seconds = number_in(map["secs"] ? map["secs"] : map["sec"]);
  const auto fraction = number_in(map["nsecs"] ? map["nsecs"] : map["nanosec"]);
  if (!seconds || !fraction) return std::nullopt;
  return *seconds + nanosecond_s * *fraction;
}

// Puts the numbers of a message into the row of a table.
class MessageWalk {
 public:
  explicit MessageWalk(RowTable& table) : table_(table) {}

  void visit(const YAML::Node& node, const std::string& path, int level = 0) {
    if (level > deepest_level || path.size() > longest_path) return;
    if (const auto number = number_in(node)) return set(path, *number);
    if (node.IsMap()) visit_map(node, path, level);
    if (node.IsSequence()) visit_sequence(node, path, {}, level);
  }

 private:
  void visit_map(const YAML::Node& map, const std::string& path, int level) {
    if (const auto time_s = time_in(map)) return set(path, *time_s);
    const YAML::Node names = map["name"];
    for (const auto& member : map) {
      const std::string& key = member.first.Scalar();
      if (key.find("covariance") != std::string::npos && member.second.IsSequence()) continue;
      const std::string below = path.empty() ? key : path + "." + key;
      if (member.second.IsSequence()) {
        visit_sequence(member.second, below, names, level + 1);
      } else {
        visit(member.second, below, level + 1);
      }
    }
  }
  // `names`: of the elements, where as many texts stand beside them under "name".
  void visit_sequence(const YAML::Node& sequence, const std::string& path, const YAML::Node& names,
                      int level) {
    const bool are_named = names && names.IsSequence() && names.size() == sequence.size();
    if (sequence.size() > (are_named ? max_named_elements : max_numbers_in_array)) return;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      const std::string element = are_named ? names[i].Scalar() : std::to_string(i);
      visit(sequence[i], path + "[" + element + "]", level + 1);
    }
  }
  void set(const std::string& path, double value) {
    const auto [known, is_new] = channels_.try_emplace(path, no_channel);
    if (is_new) known->second = table_.add_channel(path);
    table_.set(known->second, value);
  }

  RowTable& table_;
  std::unordered_map<std::string, std::size_t> channels_;
};

// Null where the text is no message.
YAML::Node parse(std::string_view text) {
  if (text.size() > longest_message) return {};
  try {
    return YAML::Load(std::string(text));
  } catch (const YAML::Exception&) {
    return {};
  }
}

std::string type_of(const YAML::Node& message) {
  std::vector<std::string> fields;
  for (const auto& member : message) fields.push_back(member.first.Scalar());
  return std::string(type_with_fields(fields));
}

}  // namespace

std::optional<Stream> read_yaml_messages(std::string_view text, std::vector<std::string>& remarks) {
  NumberBudget budget;
  RowTable table(budget);
  MessageWalk walk(table);
  std::vector<std::size_t> places;
  LineTally unread;
  Stream stream;
  const auto take = [&](std::string_view message, std::size_t line) {
    if (trim(message).empty()) return;
    const YAML::Node node = parse(message);
    if (!node.IsMap()) return unread.add(line, message.substr(0, message.find('\n')));
    if (places.empty()) stream.type = type_of(node);
    walk.visit(node, "");
    table.commit_row(0.0);
    places.push_back(line);
  };
  LineCursor cursor(text);
  Line line;
  std::size_t begin = 0;
  std::size_t first_line = 1;
  while (cursor.next(line)) {
    if (trim(line.text) != "---") continue;
    take(text.substr(begin, static_cast<std::size_t>(line.text.data() - text.data()) - begin), first_line);
    begin = cursor.offset();
    first_line = line.number + 1;
  }
  take(text.substr(begin), first_line);  // cut short, or without a line behind it
  unread.say("no message in YAML, left out", remarks);
  if (table.rows() == 0 || table.channels() == 0) return std::nullopt;
  table.move_to(stream);
  stream.received_s.clear();
  places.resize(stream.rows);
  stream.places = std::move(places);
  return stream;
}

}  // namespace wheelwright::import::ros
