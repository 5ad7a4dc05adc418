// The text files of a folder, as one run: "commands.csv", "encoders.csv", "poses.csv".
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace wheelwright::import {

struct ListedFile {
  std::filesystem::path path;
  bool is_given = true;  // else it lies in a folder that is: it may hold notes, and no table
};

// The given paths, with the text files of each folder that holds no bag in its place, by name; of a run of
// the daemon its drive log alone. One line where such a folder has too many.
tl::expected<std::vector<ListedFile>, std::string> files_of_folders(
    const std::vector<std::filesystem::path>& paths);

}  // namespace wheelwright::import
