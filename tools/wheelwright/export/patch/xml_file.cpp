#include "tools/wheelwright/export/patch/xml_file.hpp"

#include <algorithm>
#include <cstring>

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/export/xml_text.hpp"

namespace wheelwright::tools {
namespace {

// Without conversions, so that each value has the length that it has in the file.
constexpr unsigned int parsed = pugi::parse_minimal | pugi::parse_comments;
constexpr int max_levels = 256;

std::string at_row(const std::string& name, std::string_view text, std::size_t offset,
                   const std::string& what) {
  return name + ":" + std::to_string(row_of(text, offset)) + ": " + what;
}

pugi::xml_node next_element(pugi::xml_node node) {
  while (node && node.type() != pugi::node_element) node = node.next_sibling();
  return node;
}

}  // namespace

XmlFile::XmlFile(const PatchedFile& file) : name_(file.name), text_(file.text), buffer_(file.text) {
  const pugi::xml_parse_result result =
      document_.load_buffer_inplace(buffer_.data(), buffer_.size(), parsed, pugi::encoding_utf8);
  if (!result) {
    const auto offset =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), text_.size());
    throw UsageError(
        at_row(name_, text_, offset,
               "is broken XML (" + config::printable(result.description()) + "); mend it first"));
  }
  root_ = next_element(document_.first_child());
  if (const auto second = next_element(root_.next_sibling())) {
    throw UsageError(at_row(name_, text_, start_of(second),
                            tag_text(second) + " is a second root element, but XML has one"));
  }
  int levels = 0;
  for (pugi::xml_node node = root_; node;) {  // looked through once, so that nothing later is too deep
    if (pugi::xml_node below = next_element(node.first_child())) {
      if (++levels > max_levels) fail(below, "is deeper than 256 levels, which no robot is");
      node = below;
      continue;
    }
    while (node && node != root_ && !next_element(node.next_sibling())) {
      node = node.parent();
      --levels;
    }
    node = node == root_ ? pugi::xml_node() : next_element(node.next_sibling());
  }
}

void XmlFile::for_each(pugi::xml_node top, const std::function<void(pugi::xml_node)>& visit) {
  visit(top);
  for (const pugi::xml_node child : top.children()) {
    if (child.type() == pugi::node_element) for_each(child, visit);
  }
}

void XmlFile::fail(pugi::xml_node element, const std::string& what) const {
  throw UsageError(at_row(name_, text_, start_of(element), tag_text(element) + " " + what));
}

void XmlFile::fail(const std::string& what) const {
  throw UsageError(name_ + ": " + what);
}

std::size_t XmlFile::attributes_end(pugi::xml_node element) const {
  const pugi::xml_attribute last = element.last_attribute();
  if (!last) return offset_of(element.name()) + std::strlen(element.name());
  return offset_of(last.value()) + std::strlen(last.value()) + 1;
}

std::size_t XmlFile::content_begin(pugi::xml_node element) const {
  const std::size_t end = text_.find('>', attributes_end(element));
  if (end == std::string::npos || text_[end - 1] == '/')
    fail(element, "is empty; give it its elements first");
  return end + 1;
}

std::optional<std::size_t> XmlFile::end_of_simple(pugi::xml_node element) const {
  const std::size_t start_end = text_.find('>', attributes_end(element));
  if (start_end == std::string::npos) return std::nullopt;
  if (text_[start_end - 1] == '/') return start_end + 1;
  for (const pugi::xml_node child : element.children()) {
    if (child.type() != pugi::node_pcdata) return std::nullopt;
  }
  const std::size_t end_tag = text_.find("</", start_end);
  if (end_tag == std::string::npos) return std::nullopt;
  return text_.find('>', end_tag) + 1;
}

Token XmlFile::value_of(pugi::xml_node element, const std::string& attribute) const {
  const auto found = std::ranges::count_if(element.attributes(),
                                           [&](pugi::xml_attribute one) { return attribute == one.name(); });
  if (found != 1) fail(element, "has " + attribute + " twice; leave one of them");
  const char* value = element.attribute(attribute.c_str()).value();
  const Token token{offset_of(value), std::strlen(value)};
  if (std::string_view(value).find("${") != std::string_view::npos)
    fail(element, "has an expression of xacro for " + attribute + "; patch the file that xacro makes of it");
  return token;
}

Token XmlFile::text_of(pugi::xml_node element) const {
  const pugi::xml_node only = element.first_child();
  if (!only || only.type() != pugi::node_pcdata || only.next_sibling())
    fail(element, "holds no number, or more than one; give it one");
  const char* value = only.value();
  const auto tokens = tokens_of(text_, offset_of(value), std::strlen(value));
  if (tokens.size() != 1) fail(element, "holds no number, or more than one; give it one");
  if (std::string_view(value).find("${") != std::string_view::npos)
    fail(element, "holds an expression of xacro; patch the file that xacro makes of it");
  return tokens.front();
}

std::optional<Token> XmlFile::remark_before(pugi::xml_node element) const {
  for (pugi::xml_node before = element.previous_sibling(); before.type() == pugi::node_comment;
       before = before.previous_sibling()) {
    const std::string_view comment = before.value();
    const std::size_t begin = comment.find_first_not_of(" \t\r\n");
    if (begin != std::string_view::npos && comment.substr(begin).starts_with(remark_mark))
      return Token{offset_of(before.value()), comment.size()};
  }
  return std::nullopt;
}

std::string tag_text(pugi::xml_node element) {
  std::string text = "<" + config::excerpt(element.name());
  if (const pugi::xml_attribute name = element.attribute("name"))
    text += " name=\"" + config::excerpt(name.value()) + "\"";
  return text + ">";
}

}  // namespace wheelwright::tools
