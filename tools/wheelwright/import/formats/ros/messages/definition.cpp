#include "tools/wheelwright/import/formats/ros/messages/definition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <unordered_map>
#include <utility>

#include "config/load/ascii_text.hpp"
#include "config/load/printable_text.hpp"

namespace wheelwright::import::ros {
namespace {

using config::excerpt;
using Failure = tl::unexpected<std::string>;

constexpr std::size_t max_fields = 4000;  // of all types together
constexpr std::size_t longest_field_name = 200;
constexpr std::size_t longest_definition = 256U << 10U;
constexpr int deepest_nesting = 32;
constexpr std::string_view blanks = " \t\r";

std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return config::trim(line);
}

std::optional<FieldKind> primitive(std::string_view name, Dialect dialect) {
  static const std::unordered_map<std::string_view, FieldKind> both{
      {"bool", FieldKind::boolean},    {"int8", FieldKind::int8},          {"uint8", FieldKind::uint8},
      {"int16", FieldKind::int16},     {"uint16", FieldKind::uint16},      {"int32", FieldKind::int32},
      {"uint32", FieldKind::uint32},   {"int64", FieldKind::int64},        {"uint64", FieldKind::uint64},
      {"float32", FieldKind::float32}, {"float64", FieldKind::float64},    {"string", FieldKind::string},
      {"char", FieldKind::uint8},      {"wstring", FieldKind::wide_string}};
  const bool is_ros1 = dialect == Dialect::ros1;
  if (name == "byte") return is_ros1 ? FieldKind::int8 : FieldKind::uint8;
  if (name == "time") return is_ros1 ? FieldKind::ros1_time : FieldKind::ros2_time;
  if (name == "duration") return is_ros1 ? FieldKind::ros1_duration : FieldKind::ros2_time;
  const auto at = both.find(name);
  return at == both.end() ? std::nullopt : std::optional(at->second);
}

std::string_view last_part(std::string_view type) {
  return type.substr(type.rfind('/') + 1);  // of npos: all
}

std::string_view package_of(std::string_view type) {
  return type.substr(0, std::min(type.find('/'), type.size()));
}

// A field as its line has it; the type of a nested message is looked up when all types are known.
struct FieldLine {
  Field field;
  std::string type_name;
};

// The brackets of a type: "[]", "[<=8]", "[9]".
bool parse_brackets(std::string_view brackets, Field& field) {
  if (!brackets.starts_with('[') || !brackets.ends_with(']')) return false;
  const std::string_view inside = brackets.substr(1, brackets.size() - 2);
  if (inside.empty() || inside.starts_with("<=")) {
    field.arity = Arity::sequence;
    return true;
  }
  field.arity = Arity::fixed;
  const auto [end, error] = std::from_chars(inside.data(), inside.data() + inside.size(), field.count);
  return error == std::errc() && end == inside.data() + inside.size();
}

bool is_identifier(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

// A field, or nothing for a constant; a failure where the line is neither.
tl::expected<std::optional<FieldLine>, std::string> parse_line(std::string_view line, Dialect dialect) {
  const auto not_a_field = [&] {
    return Failure("its definition has \"" + excerpt(line) +
                   "\", which is no field: a type and a name belong there");
  };
  const auto type_end = line.find_first_of(blanks);
  if (type_end == std::string_view::npos) return not_a_field();
  const std::string_view type = line.substr(0, type_end);
  std::string_view rest = config::trim(line.substr(type_end));
  const auto name_end = std::min(rest.find_first_of(" \t=#"), rest.size());
  const std::string_view name = rest.substr(0, name_end);
  if (config::trim(rest.substr(name_end)).starts_with('='))
    return std::nullopt;  // a constant: not in messages
  if (!is_identifier(name) || name.size() > longest_field_name) return not_a_field();

  FieldLine result;
  result.field.name = name;
  const auto bracket = std::min(type.find('['), type.size());
  std::string_view base = type.substr(0, bracket);
  if (bracket < type.size() && !parse_brackets(type.substr(bracket), result.field)) return not_a_field();
  base = base.substr(0, base.find("<="));  // the bound of a string
  if (const auto kind = primitive(base, dialect)) {
    result.field.kind = *kind;
  } else {
    result.field.kind = FieldKind::message;
    result.type_name = base == "Header" ? "std_msgs/Header" : short_type_name(base);
  }
  return result;
}

class Parser {
 public:
  explicit Parser(Dialect dialect) : dialect_(dialect) {}

  std::optional<std::string> read(std::string_view type, std::string_view text) {
    begin_type(type);
    bool is_separated = false;
    while (!text.empty()) {
      const std::string_view line = take_line(text);
      if (line.starts_with("===")) {
        is_separated = true;
      } else if (is_separated && line.starts_with("MSG:")) {
        begin_type(config::trim(line.substr(4)));
        is_separated = false;
      } else if (is_separated && line.starts_with("IDL:")) {
        return "its definition is in part IDL, which is not read";
      } else if (line == "---") {
        return "its definition is that of a service or an action, whose messages are not read";
      } else if (!line.empty() && !line.starts_with('#')) {
        if (auto why = add_line(line)) return why;
      }
    }
    return std::nullopt;
  }

  tl::expected<MessageDefinition, std::string> finish() {
    if (auto why = resolve()) return Failure(*std::move(why));
    heights_.assign(types_.size(), 0);
    if (height_of(0, 1) > deepest_nesting)
      return Failure("its definition nests types more than " + std::to_string(deepest_nesting) +
                     " levels deep");
    return MessageDefinition{std::move(types_)};
  }

 private:
  void begin_type(std::string_view name) {
    by_name_.emplace(short_type_name(name), types_.size());  // of two alike the first holds
    types_.push_back({short_type_name(name), {}});
    lines_.emplace_back();
  }

  std::optional<std::string> add_line(std::string_view line) {
    auto parsed = parse_line(line, dialect_);
    if (!parsed) return parsed.error();
    if (!*parsed) return std::nullopt;
    if (++fields_ > max_fields)
      return "its definition has more than " + std::to_string(max_fields) + " fields";
    lines_.back().push_back(std::move(**parsed));
    return std::nullopt;
  }

  std::optional<std::string> resolve() {
    for (std::size_t type = 0; type < types_.size(); ++type) {
      for (FieldLine& line : lines_[type]) {
        if (line.field.kind == FieldKind::message) {
          if (auto why = resolve(types_[type].name, line)) return why;
        }
        types_[type].fields.push_back(std::move(line.field));
      }
      // A structure of CDR cannot be empty: ROS 2 puts a byte there.
      if (types_[type].fields.empty() && dialect_ == Dialect::ros2)
        types_[type].fields.push_back({"structure_needs_at_least_one_member", FieldKind::uint8});
    }
    return std::nullopt;
  }

  std::optional<std::string> resolve(std::string_view inside, FieldLine& line) {
    std::string& name = line.type_name;
    if (name.find('/') == std::string::npos) {
      const std::string beside = std::string(package_of(inside)) + "/" + name;
      name = by_name_.contains(beside) ? beside : only_type_called(name).value_or(beside);
    }
    if (dialect_ == Dialect::ros2 &&
        (name == "builtin_interfaces/Time" || name == "builtin_interfaces/Duration")) {
      line.field.kind = FieldKind::ros2_time;
      return std::nullopt;
    }
    const auto at = by_name_.find(name);
    if (at == by_name_.end()) return "its definition lacks that of " + excerpt(name);
    line.field.type = at->second;
    return std::nullopt;
  }

  std::optional<std::string> only_type_called(std::string_view name) const {
    std::optional<std::string> found;
    for (const MessageType& type : types_) {
      if (last_part(type.name) != name) continue;
      if (found) return std::nullopt;
      found = type.name;
    }
    return found;
  }

  // The levels below a type, or more than the deepest where it contains itself. Each type is looked at once.
  int height_of(std::size_t type, int depth) {
    constexpr int too_high = deepest_nesting + 1;
    constexpr int in_work = -1;
    if (depth > deepest_nesting || heights_[type] == in_work) return too_high;
    if (heights_[type] > 0) return heights_[type];
    heights_[type] = in_work;
    int height = 1;
    for (const Field& field : types_[type].fields) {
      if (field.kind != FieldKind::message) continue;
      height = std::max(height, std::min(1 + height_of(field.type, depth + 1), too_high));
    }
    return heights_[type] = height;
  }

  Dialect dialect_;
  std::vector<MessageType> types_;
  std::vector<std::vector<FieldLine>> lines_;
  std::unordered_map<std::string, std::size_t> by_name_;
  std::vector<int> heights_;
  std::size_t fields_ = 0;
};

}  // namespace

std::string short_type_name(std::string_view name) {
  const auto slash = name.find('/');
  if (slash == std::string_view::npos) return std::string(name);
  return std::string(name.substr(0, slash)) + "/" + std::string(last_part(name));
}

tl::expected<MessageDefinition, std::string> parse_definition(std::string_view type, std::string_view text,
                                                              Dialect dialect) {
  if (text.size() > longest_definition) return Failure("its definition is longer than 256 KiB");
  Parser parser(dialect);
  if (auto why = parser.read(type, text)) return Failure(*std::move(why));
  return parser.finish();
}

}  // namespace wheelwright::import::ros
