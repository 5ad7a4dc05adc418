#include "tools/wheelwright/export/placed_number.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace wheelwright::tools {

PlacedNumber measured(Part part, const std::string& key, std::vector<Figure> figures, const std::string& unit,
                      const std::string& remark) {
  PlacedNumber number;
  number.part = part;
  number.key = key;
  number.figures = std::move(figures);
  number.unit = unit;
  number.remark = remark;
  return number;
}

PlacedNumber constant(Part part, const std::string& key, double value, const std::string& unit) {
  return measured(part, key, {Figure{value, {}, ""}}, unit, "");
}

PlacedNumber limit(Part part, const std::string& key, std::vector<Figure> figures, const std::string& unit,
                   const std::string& remark) {
  PlacedNumber number = measured(part, key, std::move(figures), unit, remark);
  number.is_limit = true;
  return number;
}

PlacedNumber one_of_list(PlacedNumber number, std::size_t at) {
  number.at = at;
  return number;
}

PlacedNumber keyword(Part part, const std::string& key, const std::string& word) {
  PlacedNumber number = measured(part, key, {}, "", "");
  number.word = word;
  return number;
}

std::vector<std::string> values_of(const PlacedNumber& number) {
  if (!number.word.empty()) return {number.word};
  std::vector<std::string> values;
  std::ranges::transform(number.figures, std::back_inserter(values), value_of);
  return values;
}

std::string value_text(const PlacedNumber& number) {
  std::string text;
  for (const std::string& value : values_of(number)) text += (text.empty() ? "" : " ") + value;
  return text;
}

std::string remarks_on(const std::vector<PlacedNumber>& numbers) {
  std::string text;
  for (const PlacedNumber& number : numbers) {
    if (!number.remark.empty()) text += (text.empty() ? "" : "; ") + number.key + ": " + number.remark;
  }
  return text;
}

std::vector<PlacedNumber> numbers_of(const std::vector<PlacedNumber>& numbers, Part part) {
  std::vector<PlacedNumber> own;
  std::ranges::copy_if(numbers, std::back_inserter(own),
                       [part](const PlacedNumber& number) { return number.part == part; });
  return own;
}

}  // namespace wheelwright::tools
