// Numbers into the attributes or child elements of an XML element, with a comment before it.
#pragma once

#include <string>
#include <vector>

#include "tools/wheelwright/export/patch/xml_file.hpp"

namespace wheelwright::tools {

class XmlNumbers {
 public:
  explicit XmlNumbers(const XmlFile& file) : file_(file), edits_(file.text()) {}

  // Each as an attribute; their remarks are one comment before the element. `thing` names it: "joint left".
  void set_attributes(pugi::xml_node element, const std::string& thing,
                      const std::vector<PlacedNumber>& numbers);

  // Each as a child element, with its own comment; what is not there follows the last one that is.
  void set_children(pugi::xml_node element, const std::string& thing,
                    const std::vector<PlacedNumber>& numbers);

  // Each as a child of a new element `name`, which goes behind the child `after`, or else comes first.
  void add_element(pugi::xml_node parent, const std::string& name, const std::string& after,
                   const std::string& thing, const std::vector<PlacedNumber>& numbers);
  // The same, each as an attribute.
  void add_empty_element(pugi::xml_node parent, const std::string& name, const std::string& thing,
                         const std::vector<PlacedNumber>& numbers);

  // Numbers that this file has no place for.
  void leave(const std::string& thing, const std::vector<PlacedNumber>& numbers, const std::string& reason);

  std::string text() const { return edits_.apply(); }
  const std::vector<NumberChange>& changes() const { return changes_; }

 private:
  struct Margin {
    std::string line_break;  // and the blanks of the next line
    std::string step;        // more blanks for what is inside
  };

  void set_attribute(pugi::xml_node element, const std::string& thing, const PlacedNumber& number);
  void set_remark(pugi::xml_node element, const std::string& remarks);
  void note(const std::string& thing, const PlacedNumber& number, std::size_t row,
            std::optional<std::string> before, std::string after);
  Margin margin_in(pugi::xml_node parent) const;

  const XmlFile& file_;
  TextEdits edits_;
  std::vector<NumberChange> changes_;
};

}  // namespace wheelwright::tools
