// Where the files are that ship with the project: robots, routes, the configuration with every key.
#pragma once

#include <filesystem>

namespace wheelwright::config {

// Of an installed program ../share/wheelwright beside it; of one that was just built config/ in the source
// tree.
std::filesystem::path shipped_folder();

}  // namespace wheelwright::config
