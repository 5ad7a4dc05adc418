#include "tools/wheelwright/import/formats/ros/bag_folder.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>
#include <utility>

#include "config/load/printable_text.hpp"
#include "config/load/text_file.hpp"
#include "config/load/yaml_bounds.hpp"

namespace wheelwright::import::ros {
namespace {

namespace fs = std::filesystem;
using Failure = tl::unexpected<std::string>;

constexpr std::string_view metadata_name = "metadata.yaml";

bool is_bag_name(const fs::path& name) {
  const std::string extension = (name.extension() == ".zstd" ? name.stem() : name).extension().string();
  return extension == ".db3" || extension == ".mcap" || extension == ".bag";
}

// "drive_12.db3" is part 12 of "drive"; without a number it is part -1.
struct Part {
  std::string stem;
  std::string extension;
  long number = -1;
  fs::path path;
};

Part part_of(const fs::path& path) {
  const std::string name = path.filename().string();
  const auto dot = std::min(name.find(".db3"), std::min(name.find(".mcap"), name.find(".bag")));
  Part part{name.substr(0, dot), name.substr(std::min(dot, name.size())), -1, path};
  const auto digits = part.stem.find_last_not_of("0123456789") + 1;  // of npos: 0
  if (digits == 0 || part.stem[digits - 1] != '_' || digits == part.stem.size()) return part;
  std::from_chars(part.stem.data() + digits, part.stem.data() + part.stem.size(), part.number);
  part.stem.resize(digits - 1);
  return part;
}

std::vector<fs::path> bags_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && is_bag_name(entry->path())) files.push_back(entry->path());
  }
  return files;
}

tl::expected<BagFolder, std::string> list_parts(const fs::path& folder) {
  std::vector<Part> parts;
  for (const fs::path& file : bags_in(folder)) parts.push_back(part_of(file));
  if (parts.empty())
    return Failure(
        "is a folder without a bag and without text: neither metadata.yaml nor .bag, .mcap, .db3, .csv, "
        ".txt");
  std::ranges::sort(parts, {},
                    [](const Part& part) { return std::tie(part.stem, part.extension, part.number); });
  BagFolder result;
  for (const Part& part : parts) {
    if (part.stem != parts.front().stem || part.extension != parts.front().extension) {
      return Failure("is a folder of several bags, " +
                     config::excerpt(parts.front().path.filename().string()) + " and " +
                     config::excerpt(part.path.filename().string()) + " among them; name one file");
    }
    result.files.push_back(part.path);
  }
  return result;
}

// Where a file of the list is: as named, or without the suffix that compression adds or takes off; old
// versions of rosbag2 put the folder before the name.
fs::path locate(const fs::path& folder, const std::string& listed) {
  const fs::path name = fs::path(listed).filename();
  std::error_code ignored;
  for (const fs::path& candidate :
       {folder / name, folder / (name.string() + ".zstd"), folder / name.stem()}) {
    if (fs::is_regular_file(candidate, ignored) && is_bag_name(candidate.filename())) return candidate;
  }
  return {};
}

tl::expected<std::vector<std::string>, std::string> listed_files(const fs::path& metadata) {
  const auto text = config::read_text(metadata, config::yaml_file);
  if (!text) return Failure(text.error());
  try {
    config::check_yaml_bounds(*text);
    const YAML::Node bag = YAML::Load(*text)["rosbag2_bagfile_information"];
    return bag["relative_file_paths"].as<std::vector<std::string>>();
  } catch (const YAML::Exception& error) {
    return Failure(std::string(metadata_name) + " lists no files of a bag (" + config::excerpt(error.what()) +
                   ")");
  }
}

}  // namespace

tl::expected<BagFolder, std::string> list_bag_folder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / metadata_name, ignored)) return list_parts(folder);
  const auto listed = listed_files(folder / metadata_name);
  // A bag that was not closed has a metadata.yaml without files, or half of one.
  if (!listed || listed->empty()) {
    auto parts = list_parts(folder);
    if (!parts) return Failure(listed ? parts.error() : listed.error());
    parts->remarks.push_back(listed ? "metadata.yaml lists no files; those in the folder are read"
                                    : listed.error());
    return parts;
  }
  BagFolder result;
  std::set<fs::path> seen;
  for (const std::string& name : *listed) {
    fs::path file = locate(folder, name);
    if (file.empty()) {
      result.remarks.push_back(config::excerpt(name) + ": metadata.yaml lists it, but it is not there");
    } else if (seen.insert(file).second) {
      result.files.push_back(std::move(file));
    }
  }
  if (result.files.empty()) return Failure("holds none of the files that its metadata.yaml lists");
  return result;
}

}  // namespace wheelwright::import::ros
