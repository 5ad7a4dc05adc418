#include "tools/wheelwright/export/patch/yaml_numbers.hpp"

#include <algorithm>

#include "config/load/printable_text.hpp"
#include "config/load/yaml_bounds.hpp"
#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::string shown(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  std::string text;
  for (const YAML::Node& element : node)
    text += (text.empty() ? "" : ", ") + (element.IsScalar() ? element.Scalar() : std::string("..."));
  return "[" + text + "]";
}

// Whether the mapping has other keys of the same levels in one word, as "linear.x.max_jerk".
bool has_flat_sibling(const YAML::Node& mapping, const std::string& key) {
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos) return false;
  const std::string levels = key.substr(0, dot + 1);
  return std::ranges::any_of(mapping, [&](const auto& entry) {
    return entry.first.IsScalar() && entry.first.Scalar().starts_with(levels);
  });
}

}  // namespace

YamlNumbers::YamlNumbers(const PatchedFile& file) : name_(file.name), text_(file.text), edits_(text_) {
  try {
    config::check_yaml_bounds(text_);
    root_ = YAML::Load(text_);
  } catch (const YAML::Exception& error) {
    throw UsageError(name_ + ":" + std::to_string(error.mark.line + 1) + ": is broken YAML (" +
                     config::printable(error.msg) + "); mend it first");
  }
}

void YamlNumbers::fail(const YAML::Node& at, const std::string& what) const {
  throw UsageError(name_ + ":" + std::to_string(row(at)) + ": " + what);
}

void YamlNumbers::fail(const std::string& what) const {
  throw UsageError(name_ + ": " + what);
}

std::size_t YamlNumbers::row(const YAML::Node& node) const {
  return static_cast<std::size_t>(std::max(node.Mark().line, 0)) + 1;
}

YAML::Node YamlNumbers::child(const YAML::Node& mapping, const std::string& key) const {
  YAML::Node found(YAML::NodeType::Undefined);
  for (const auto& entry : mapping) {
    if (!entry.first.IsScalar() || entry.first.Scalar() != key) continue;
    if (found.IsDefined()) fail(entry.first, key + " is there twice; leave one of them");
    found.reset(entry.second);
  }
  return found;
}

// ROS takes "linear.x.max_velocity" as one key, too.
YamlNumbers::Place YamlNumbers::find(const YAML::Node& parameters, const std::string& key) const {
  Place place{parameters, key, child(parameters, key)};
  while (!place.value.IsDefined()) {
    const std::size_t dot = place.rest.find('.');
    if (dot == std::string::npos) return place;
    const YAML::Node below = child(place.mapping, place.rest.substr(0, dot));
    if (!below.IsDefined()) return place;
    if (!below.IsMap())
      fail(below, place.rest.substr(0, dot) + " holds no keys, but must hold " + place.rest);
    place.mapping.reset(below);
    place.rest = place.rest.substr(dot + 1);
    place.value.reset(child(below, place.rest));
  }
  return place;
}

std::size_t YamlNumbers::offset_of(const YAML::Node& scalar) const {
  const auto at = static_cast<std::size_t>(std::max(scalar.Mark().pos, 0));
  for (const std::size_t offset : {at, at + byte_order_mark.size()}) {
    if (!scalar.Scalar().empty() && std::string_view(text_).substr(offset).starts_with(scalar.Scalar()))
      return offset;
  }
  fail(scalar, "'" + config::excerpt(scalar.Scalar()) + "' is no plain number; write it without quotes");
}

// What stands there afterwards.
std::string YamlNumbers::set_scalar(const YAML::Node& scalar, const std::string& value, bool is_limit) {
  const std::size_t offset = offset_of(scalar);
  const std::string& before = scalar.Scalar();
  if (says_the_same(before, value) || (is_limit && is_tighter(before, value))) return before;
  edits_.replace(offset, before.size(), value);
  return value;
}

void YamlNumbers::set_value(const std::string& thing, const YAML::Node& node, const PlacedNumber& number) {
  const auto values = yaml_values(number);
  const bool is_list = values.size() > 1;
  if (is_list ? !node.IsSequence() || node.size() != values.size() : !node.IsScalar()) {
    fail(node, number.key + " must be " +
                   (is_list ? "a list of " + std::to_string(values.size()) + " numbers" : "one value"));
  }
  NumberChange change{thing + " " + number.key, row(node), shown(node), "", {}, number, {}};
  bool is_kept = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const YAML::Node scalar = is_list ? node[i] : node;
    if (!scalar.IsScalar()) fail(node, number.key + " must be a list of numbers");
    const bool is_known = std::ranges::find(number.unknown, i) == number.unknown.end();
    const std::string after = is_known ? set_scalar(scalar, values[i], number.is_limit) : scalar.Scalar();
    is_kept = is_kept || (is_known && !says_the_same(after, values[i]));
    change.after += (i == 0 ? "" : ", ") + after;
  }
  if (is_list) change.after = "[" + change.after + "]";
  if (is_kept) change.kept_within = yaml_line(number).value;
  if (!number.remark.empty()) {
    const std::size_t line = line_begin(text_, offset_of(is_list ? node[0] : node));
    remarks_[line].emplace_back(
        number.key, (is_kept ? "the robot reaches " + change.kept_within + ": " : "") + number.remark);
  }
  changes_.push_back(std::move(change));
}

void YamlNumbers::add(std::vector<Addition>& additions, const Place& place, const PlacedNumber& number) {
  YamlLine line = yaml_line(number);
  line.key = place.rest;
  line.is_flat = has_flat_sibling(place.mapping, place.rest);
  const auto same =
      std::ranges::find_if(additions, [&](const Addition& one) { return one.mapping.is(place.mapping); });
  if (same == additions.end()) {
    additions.push_back({place.mapping, {std::move(line)}});
  } else {
    same->lines.push_back(std::move(line));
  }
}

// Below the last number that is there, else before the mapping's first key.
void YamlNumbers::insert(const Addition& addition, std::size_t behind) {
  if (addition.mapping.size() == 0) fail(addition.mapping, "holds no keys yet; give it its own first");
  const YAML::Node first = addition.mapping.begin()->first;
  const std::size_t key = offset_of(first);
  const auto indent = indent_at(text_, key);
  if (addition.mapping.Style() == YAML::EmitterStyle::Flow || !indent) {
    fail(first, "is in a mapping in braces or in a list, to which " + addition.lines.front().key +
                    " is not added; write one key a line");
  }
  const std::string line_break = line_break_of(text_);
  const std::string lines = yaml_lines(addition.lines, *indent, "  ", line_break);
  const std::size_t at = behind == 0 ? line_begin(text_, key) : behind;
  const bool ends_the_file = at == text_.size() && !text_.ends_with('\n');
  edits_.insert(at, ends_the_file ? line_break + lines.substr(0, lines.size() - line_break.size()) : lines);
}

void YamlNumbers::set(const YAML::Node& parameters, const std::string& thing,
                      const std::vector<PlacedNumber>& numbers) {
  std::vector<Addition> additions;
  std::vector<std::pair<YAML::Node, std::size_t>> last_lines;
  for (const PlacedNumber& number : numbers) {
    const Place place = find(parameters, number.key);
    if (place.value.IsDefined()) {
      set_value(thing, place.value, number);
      if (place.value.IsScalar()) {
        const std::size_t end = text_.find('\n', offset_of(place.value));
        last_lines.emplace_back(place.mapping, end == std::string::npos ? text_.size() : end + 1);
      }
      continue;
    }
    add(additions, place, number);
    changes_.push_back({thing + " " + number.key,
                        row(place.mapping),
                        std::nullopt,
                        yaml_line(number).value,
                        {},
                        number,
                        {}});
  }
  for (const Addition& addition : additions) {
    std::size_t behind = 0;
    for (const auto& [mapping, end] : last_lines) {
      if (mapping.is(addition.mapping)) behind = end;
    }
    insert(addition, behind);
  }
}

void YamlNumbers::leave(const std::string& thing, const std::vector<PlacedNumber>& numbers,
                        const std::string& reason) {
  for (const PlacedNumber& number : numbers)
    changes_.push_back(
        {thing + " " + number.key, 0, std::nullopt, yaml_line(number).value, reason, number, {}});
}

// Our comment is the last of its line, behind one of the file's own.
void YamlNumbers::put_remarks(TextEdits& edits) const {
  for (const auto& [begin, remarks] : remarks_) {
    std::string remark;
    for (const auto& [key, text] : remarks) {
      remark += remark.empty() ? "" : "; ";
      remark += remarks.size() > 1 ? key + ": " + text : text;
    }
    const std::size_t end = line_end(text_, begin);
    const std::string_view line = std::string_view(text_).substr(begin, end - begin);
    const std::size_t mark = line.find(yaml_remark_mark);
    const std::size_t last = line.substr(0, mark).find_last_not_of(" \t");
    const std::size_t from = begin + (last == std::string_view::npos ? 0 : last + 1);
    edits.replace(from, end - from, "  " + std::string(yaml_remark_mark) + " " + remark);
  }
}

std::string YamlNumbers::text() const {
  TextEdits all = edits_;
  put_remarks(all);
  return all.apply();
}

}  // namespace wheelwright::tools
