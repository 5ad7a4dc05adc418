#include "tools/wheelwright/import/formats/ros/messages/json_decoder.hpp"

#include <nlohmann/json.hpp>

#include "tools/wheelwright/import/formats/ros/messages/field_program.hpp"

namespace wheelwright::import::ros {
namespace {

using nlohmann::json;

constexpr std::size_t longest_message = 1U << 20U;
constexpr std::size_t longest_path = 200;
constexpr int deepest_level = 16;
constexpr double nanosecond = 1e-9;

// Seconds, where the object is a time.
std::optional<double> time_in(const json& object) {
  if (object.size() != 2 || !object.contains("sec")) return std::nullopt;
  const auto fraction = object.contains("nsec") ? object.find("nsec") : object.find("nanosec");
  const json& seconds = object["sec"];
  if (fraction == object.end() || !fraction->is_number() || !seconds.is_number()) return std::nullopt;
  return seconds.get<double>() + nanosecond * fraction->get<double>();
}

}  // namespace

struct JsonDecoder::Walk {
  JsonDecoder& decoder;

  void visit(const json& value, const std::string& path, int level) {
    if (level > deepest_level || path.size() > longest_path) return;
    if (value.is_number()) return decoder.set(path, value.get<double>());
    if (value.is_boolean()) return decoder.set(path, value.get<bool>() ? 1.0 : 0.0);
    if (value.is_object()) return visit_object(value, path, level);
    if (value.is_array() && !value.empty()) visit_array(value, path, level);
  }
  void visit_object(const json& object, const std::string& path, int level) {
    if (const auto time_s = time_in(object)) return decoder.set(path, *time_s);
    for (const auto& [key, member] : object.items())
      visit(member, path.empty() ? key : path + "." + key, level + 1);
  }
  void visit_array(const json& array, const std::string& path, int level) {
    if (array.size() > (array.front().is_number() ? max_numbers_in_array : max_messages_in_array)) return;
    for (std::size_t i = 0; i < array.size(); ++i)
      visit(array[i], path + "[" + std::to_string(i) + "]", level + 1);
  }
};

std::optional<std::string> JsonDecoder::decode(std::string_view message) {
  if (message.size() > longest_message) return "is a JSON text of more than 1 MiB";
  const json value = json::parse(message, nullptr, false);
  if (value.is_discarded()) return "is not a JSON text";
  Walk{*this}.visit(value, "", 0);
  return std::nullopt;
}

void JsonDecoder::set(const std::string& path, double value) {
  const auto known = channels_.find(path);
  if (known != channels_.end()) return table_.set(known->second, value);
  const std::size_t channel = table_.add_channel(path);
  if (channel == no_channel) return;
  channels_.emplace(path, channel);
  table_.set(channel, value);
}

}  // namespace wheelwright::import::ros
