// What a YAML text may cost: it is looked through before a tree is made of it, since a few lines of aliases
// can stand for more values than any machine holds, and the tree of a megabyte takes a hundred of them.
#pragma once

#include <yaml-cpp/exceptions.h>

#include <string>

namespace wheelwright::config {

inline constexpr int most_yaml_levels = 64;
inline constexpr int most_yaml_values = 500'000;  // keys included, aliases as what they stand for

class YamlTooLarge : public YAML::Exception {
 public:
  using YAML::Exception::Exception;
};

// Of the first document of a text. Throws YamlTooLarge at the place where it exceeds the bounds, and another
// YAML::Exception where it is no YAML.
void check_yaml_bounds(const std::string& text);

}  // namespace wheelwright::config
