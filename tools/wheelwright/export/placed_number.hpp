// The numbers of a model with their places in a format: what a new file, a patch of an existing one, and a
// table of ranges are made from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/wheelwright/export/drive_figures.hpp"

namespace wheelwright::tools {

// The thing in a file that a number belongs to.
enum class Part {
  left_joint,
  right_joint,
  left_actuator,
  right_actuator,
  left_wheel,  // the body that turns on the joint
  right_wheel,
  drive_plugin,
  controller,
  smoother,
};

struct PlacedNumber {
  Part part = Part::left_joint;
  std::string key;  // an attribute, a child element, or the path of a YAML key: "linear.x.max_velocity"
  std::vector<Figure> figures;    // several are a list
  std::string unit;               // where those of a list differ: each, with commas between
  std::string remark;             // for a comment; empty for what the format itself demands
  std::string word;               // in the place of figures, as "true"
  std::optional<std::size_t> at;  // the one of a list that it is; the rest of the list stays
  std::vector<std::size_t>
      unknown;            // elements of a list that the model says nothing of: a file keeps its own
  bool is_limit = false;  // of the robot: a file may have a tighter one, which it keeps
};

struct ModelNumbers {
  std::vector<PlacedNumber> numbers;  // in the order of a new file
  std::vector<Unsaid> unsaid;
  std::string notes;  // what a new file says of the linear part
};

// A number of the model; one that the format itself demands; and a word that it demands.
PlacedNumber measured(Part part, const std::string& key, std::vector<Figure> figures, const std::string& unit,
                      const std::string& remark);
PlacedNumber constant(Part part, const std::string& key, double value, const std::string& unit);
// The one at `at` of a list, of which the rest stays as it is in a file.
PlacedNumber one_of_list(PlacedNumber number, std::size_t at);
// A limit of what the robot can do.
PlacedNumber limit(Part part, const std::string& key, std::vector<Figure> figures, const std::string& unit,
                   const std::string& remark);
PlacedNumber keyword(Part part, const std::string& key, const std::string& word);

// Its values as text, one for each element of a list.
std::vector<std::string> values_of(const PlacedNumber& number);

// "0.0066", "-7.6 7.6", or the word.
std::string value_text(const PlacedNumber& number);

// The remarks on those numbers that have one: "frictionloss: 95 % interval ...; ctrlrange: ...".
std::string remarks_on(const std::vector<PlacedNumber>& numbers);

// Those of one part, in order.
std::vector<PlacedNumber> numbers_of(const std::vector<PlacedNumber>& numbers, Part part);

}  // namespace wheelwright::tools
