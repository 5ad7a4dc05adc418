// An XML file with the places of its elements, attributes and comments in its text.
#pragma once

#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "tools/wheelwright/export/patch/patch.hpp"
#include "tools/wheelwright/export/patch/text_edits.hpp"

namespace wheelwright::tools {

class XmlFile {
 public:
  // Throws UsageError with file and row where the text is no XML with one root element.
  explicit XmlFile(const PatchedFile& file);
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  pugi::xml_node root() const { return root_; }
  std::string_view text() const { return text_; }

  // Every element below `top`, and `top` itself, in the order of the file.
  static void for_each(pugi::xml_node top, const std::function<void(pugi::xml_node)>& visit);

  // Ends with one line: file, row of the element, and what is wrong.
  [[noreturn]] void fail(pugi::xml_node element, const std::string& what) const;
  [[noreturn]] void fail(const std::string& what) const;  // of the file as a whole

  std::size_t row(pugi::xml_node element) const { return row_of(text_, start_of(element)); }

  // Of its '<'.
  std::size_t start_of(pugi::xml_node element) const { return offset_of(element.name()) - 1; }
  // Behind its name and attributes, where a further one belongs.
  std::size_t attributes_end(pugi::xml_node element) const;
  // Behind the '>' of its start tag. Fails for an element such as <dynamics/>.
  std::size_t content_begin(pugi::xml_node element) const;
  // Behind its end tag, of an element that holds nothing but text; nothing for others.
  std::optional<std::size_t> end_of_simple(pugi::xml_node element) const;

  // The bytes of a value. The attribute must be there once.
  Token value_of(pugi::xml_node element, const std::string& attribute) const;
  // The text between the tags, without blanks around it. Fails where there is none, or anything else.
  Token text_of(pugi::xml_node element) const;
  // Of our comment among those right before the element: what stands between its marks.
  std::optional<Token> remark_before(pugi::xml_node element) const;

 private:
  std::size_t offset_of(const char* in_buffer) const {
    return static_cast<std::size_t>(in_buffer - buffer_.data());
  }

  std::string name_;
  std::string text_;
  std::string buffer_;  // the same, as the parser leaves it: all names and values point into it
  pugi::xml_document document_;
  pugi::xml_node root_;
};

// As a message shows it: <joint name="left">.
std::string tag_text(pugi::xml_node element);

}  // namespace wheelwright::tools
