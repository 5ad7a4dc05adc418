// What a YAML text may cost: it is looked through before a tree is made of it, since a few lines of aliases
// can stand for more values than any machine holds, and the tree of a megabyte takes a hundred of them.
#pragma once

#include <string>

namespace wheelwright::config {

inline constexpr int most_yaml_levels = 64;
inline constexpr int most_yaml_values = 500'000;  // keys included, aliases as what they stand for

// Throws YAML::Exception, at its place, where the first document of the text is no YAML, or exceeds the
// bounds.
void check_yaml_bounds(const std::string& text);

}  // namespace wheelwright::config
