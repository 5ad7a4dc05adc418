// What a YAML text may cost: it is looked through before a tree is made of it, since a few lines of aliases
// can stand for more values than any machine holds, and the tree of a megabyte takes a hundred of them.
#pragma once

#include <yaml-cpp/exceptions.h>

#include <string>

namespace wheelwright::config {

inline constexpr int max_yaml_levels = 64;
inline constexpr int max_yaml_values = 500'000;  // keys included, aliases as what they stand for

// It is YAML, but not what a file may hold.
class YamlRefused : public YAML::Exception {
 public:
  using YAML::Exception::Exception;
};

// Throws YamlRefused at the place where the text exceeds the bounds or begins a second document, and another
// YAML::Exception where it is no YAML.
void check_yaml_bounds(const std::string& text);

}  // namespace wheelwright::config
