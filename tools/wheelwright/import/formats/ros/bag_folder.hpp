// The files of a bag in a folder, in the order in which they were recorded.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace wheelwright::import::ros {

struct BagFolder {
  std::vector<std::filesystem::path> files;  // that are there
  std::vector<std::string> remarks;          // of those that are not
};

// By its metadata.yaml; without one, the parts "name_0.db3", "name_1.db3", ... of one bag. A failure says
// what is wrong with the folder, without its name.
tl::expected<BagFolder, std::string> list_bag_folder(const std::filesystem::path& folder);

}  // namespace wheelwright::import::ros
