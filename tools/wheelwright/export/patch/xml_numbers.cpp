#include "tools/wheelwright/export/patch/xml_numbers.hpp"
#include "tools/wheelwright/export/xml_text.hpp"

#include <algorithm>

namespace wheelwright::tools {
namespace {

std::string remark_text(const std::string& remarks) {
  return " " + std::string(remark_mark) + " " + in_xml_comment(remarks) + " ";
}

std::string comment_of(const std::string& remarks) {
  return "<!--" + remark_text(remarks) + "-->";
}

std::string element_text(const PlacedNumber& number) {
  return "<" + number.key + ">" + value_text(number) + "</" + number.key + ">";
}

// A list as it stands in the file, with blanks of any kind between its elements.
bool says_the_same_list(std::string_view text, const Token& list, const PlacedNumber& number) {
  const auto tokens = tokens_of(text, list.offset, list.length);
  const auto values = values_of(number);
  return std::ranges::equal(tokens, values, [text](const Token& token, const std::string& value) {
    return says_the_same(text.substr(token.offset, token.length), value);
  });
}

// Of one number in a list whose sign is the file's: the wheels lie at y and -y.
std::string with_sign_of(std::string_view before, const PlacedNumber& number) {
  const std::string value = value_text(number);
  return number.part == Part::left_wheel || number.part == Part::right_wheel
             ? (before.starts_with('-') ? "-" : "") + value
             : value;
}

}  // namespace

void XmlNumbers::note(const std::string& thing, const PlacedNumber& number, std::size_t row,
                      std::optional<std::string> before, std::string after) {
  changes_.push_back({thing + " " + number.key, row, std::move(before), std::move(after), {}, number, {}});
}

void XmlNumbers::set_attribute(pugi::xml_node element, const std::string& thing, const PlacedNumber& number) {
  const std::string_view text = file_.text();
  const std::size_t row = file_.row(element);
  if (!element.attribute(number.key.c_str())) {
    edits_.insert(file_.attributes_end(element), attribute_text(number.key, value_text(number)));
    note(thing, number, row, std::nullopt, value_text(number));
    return;
  }
  Token place = file_.value_of(element, number.key);
  if (number.at) {
    const auto tokens = tokens_of(text, place.offset, place.length);
    if (*number.at >= tokens.size()) file_.fail(element, "has too few numbers for " + number.key);
    place = tokens[*number.at];
  }
  const std::string before(text.substr(place.offset, place.length));
  const std::string value = number.at ? with_sign_of(before, number) : value_text(number);
  const bool same = number.at ? says_the_same(before, value) : says_the_same_list(text, place, number);
  if (!same) edits_.replace(place.offset, place.length, value);
  note(thing, number, row, before, same ? before : value);
}

void XmlNumbers::set_remark(pugi::xml_node element, const std::string& remarks) {
  if (remarks.empty()) return;
  if (const auto there = file_.remark_before(element)) {
    edits_.replace(there->offset, there->length, remark_text(remarks));
    return;
  }
  const std::size_t start = file_.start_of(element);
  const auto indent = indent_at(file_.text(), start);
  edits_.insert(start, comment_of(remarks) + (indent ? line_break_of(file_.text()) + *indent : ""));
}

void XmlNumbers::set_attributes(pugi::xml_node element, const std::string& thing,
                                const std::vector<PlacedNumber>& numbers) {
  for (const PlacedNumber& number : numbers) set_attribute(element, thing, number);
  set_remark(element, remarks_on(numbers));
}

XmlNumbers::Margin XmlNumbers::margin_in(pugi::xml_node parent) const {
  const std::string_view text = file_.text();
  const auto outer = indent_at(text, file_.start_of(parent));
  pugi::xml_node child = parent.first_child();
  while (child && child.type() != pugi::node_element) child = child.next_sibling();
  const auto inner = child ? indent_at(text, file_.start_of(child)) : std::nullopt;
  if (!outer || (child && !inner)) return {};  // all in one line
  const std::string step =
      inner && inner->size() > outer->size() ? inner->substr(outer->size()) : std::string("  ");
  return {line_break_of(text) + *outer + step, step};
}

void XmlNumbers::set_children(pugi::xml_node element, const std::string& thing,
                              const std::vector<PlacedNumber>& numbers) {
  const std::string_view text = file_.text();
  std::optional<std::size_t> behind;
  for (const PlacedNumber& number : numbers) {
    if (const auto child = element.child(number.key.c_str())) behind = file_.end_of_simple(child);
  }
  const Margin margin = margin_in(element);
  for (const PlacedNumber& number : numbers) {
    const pugi::xml_node child = element.child(number.key.c_str());
    const std::string value = value_text(number);
    if (!child) {
      std::string added = number.remark.empty() ? "" : margin.line_break + comment_of(remarks_on({number}));
      edits_.insert(behind ? *behind : file_.content_begin(element),
                    added + margin.line_break + element_text(number));
      note(thing, number, file_.row(element), std::nullopt, value);
      continue;
    }
    if (child.next_sibling(number.key.c_str()))
      file_.fail(child.next_sibling(number.key.c_str()), "is there twice; leave one of them");
    const Token place = file_.text_of(child);
    const std::string before(text.substr(place.offset, place.length));
    const bool same = says_the_same(before, value);
    if (!same) edits_.replace(place.offset, place.length, value);
    note(thing, number, file_.row(child), before, same ? before : value);
    set_remark(child, remarks_on({number}));
  }
}

void XmlNumbers::add_element(pugi::xml_node parent, const std::string& name, const std::string& after,
                             const std::string& thing, const std::vector<PlacedNumber>& numbers) {
  const pugi::xml_node before = parent.child(after.c_str());
  const auto behind = before ? file_.end_of_simple(before) : std::nullopt;
  const Margin margin = margin_in(parent);
  const std::string inner = margin.line_break + margin.step;
  std::string text = margin.line_break + "<" + name + ">";
  for (const PlacedNumber& number : numbers) {
    if (!number.remark.empty()) text += inner + comment_of(remarks_on({number}));
    text += inner + element_text(number);
    note(thing, number, file_.row(parent), std::nullopt, value_text(number));
  }
  edits_.insert(behind ? *behind : file_.content_begin(parent), text + margin.line_break + "</" + name + ">");
}

void XmlNumbers::add_empty_element(pugi::xml_node parent, const std::string& name, const std::string& thing,
                                   const std::vector<PlacedNumber>& numbers) {
  const Margin margin = margin_in(parent);
  const std::string remarks = remarks_on(numbers);
  std::string text = remarks.empty() ? "" : margin.line_break + comment_of(remarks);
  text += margin.line_break + "<" + name;
  for (const PlacedNumber& number : numbers) {
    text += attribute_text(number.key, value_text(number));
    note(thing, number, file_.row(parent), std::nullopt, value_text(number));
  }
  edits_.insert(file_.content_begin(parent), text + "/>");
}

void XmlNumbers::leave(const std::string& thing, const std::vector<PlacedNumber>& numbers,
                       const std::string& reason) {
  for (const PlacedNumber& number : numbers)
    changes_.push_back({thing + " " + number.key, 0, std::nullopt, value_text(number), reason, number, {}});
}

}  // namespace wheelwright::tools
