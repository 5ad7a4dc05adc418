#include "tools/wheelwright/import/open_recording.hpp"

#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"

namespace wheelwright::import {
namespace {

struct Format {
  bool (*is_of)(std::string_view head);
  ReadResult (*read)(const std::filesystem::path& path);
};
constexpr auto formats = std::to_array<Format>({
    {is_ros1_bag, read_ros_file},
    {is_mcap, read_ros_file},
    {is_sqlite, read_ros_file},
    {is_zstd, read_ros_file},
});

// Of a regular file: what is read from a pipe is gone.
std::string head_of(const std::filesystem::path& path) {
  constexpr std::streamsize longest = 512;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return "";
  std::string head(longest, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), longest);
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

}  // namespace

ReadResult open_recording(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return read_bag_folder(path);
  const std::string head = head_of(path);
  for (const Format& format : formats) {
    if (format.is_of(head)) return format.read(path);
  }
  return tl::unexpected(path.string() + ": no reader knows this format");
}

}  // namespace wheelwright::import
