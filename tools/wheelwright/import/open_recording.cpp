#include "tools/wheelwright/import/open_recording.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "config/load/text_file.hpp"
#include "tools/wheelwright/import/conversion/half_bridges.hpp"
#include "tools/wheelwright/import/conversion/stamp_columns.hpp"
#include "tools/wheelwright/import/formats/matlab/mat_file.hpp"
#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"
#include "tools/wheelwright/import/formats/text/text_recording.hpp"
#include "tools/wheelwright/import/formats/wpilog/wpilog.hpp"
#include "tools/wheelwright/import/unread_formats.hpp"

namespace wheelwright::import {
namespace {

using Failure = tl::unexpected<std::string>;
using std::filesystem::path;

constexpr std::size_t head_bytes = 4096;

// What a format looks like, and who reads it. A reader of whole files is given the bytes, one that picks what
// it needs from a large file is given the path; the other is null.
struct Format {
  bool (*is_so)(std::string_view head);
  ReadResult (*read_bytes)(std::string&& bytes, const std::string& name);
  ReadResult (*read_file)(const path& file);
};

ReadResult read_text(std::string&& bytes, const std::string& name) {
  auto recording = read_text_table(std::move(bytes), name);
  if (!recording) return recording;
  for (Stream& stream : recording->streams) {
    join_seconds_and_nanoseconds(stream);
    sum_steps_of_time(stream);
    if (join_half_bridges(stream))
      recording->remarks.emplace_back(
          "in1 to in4 are the inputs of a motor driver: joined to pwm_1 and pwm_2, forward less backward");
  }
  return recording;
}

// The first that fits is taken: text, which knows itself by what it has not, stands last.
constexpr std::array<Format, 7> formats{{
    {is_ros1_bag, nullptr, read_ros_file},
    {is_mcap, nullptr, read_ros_file},
    {is_sqlite, nullptr, read_ros_file},
    {is_zstd, nullptr, read_ros_file},
    {is_wpilog, [](std::string&& bytes, const std::string& name) { return read_wpilog(bytes, name); },
     nullptr},
    {is_mat_file, [](std::string&& bytes, const std::string& name) { return read_mat_file(bytes, name); },
     nullptr},
    {is_text, [](std::string&& bytes, const std::string& name) { return read_text(std::move(bytes), name); },
     nullptr},
}};

std::string read_head(const path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(head_bytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return head;
}

std::string why_unread(std::string_view head) {
  if (head.empty()) return "is empty";
  if (head.find_first_not_of('\0') == std::string_view::npos)
    return "begins with zero bytes only, as after a power cut: its contents were not written";
  const std::string known = describe_unread_format(head);
  if (!known.empty()) return "is " + known;
  return "is a binary file of a format that no reader knows; CSV, ROS bags, MATLAB files and WPILOG are read";
}

// Text knows itself by what it has not: what else is known comes before it.
const Format* find_format(std::string_view head) {
  if (head.empty()) return nullptr;
  const auto found =
      std::ranges::find_if(formats, [head](const Format& format) { return format.is_so(head); });
  const bool is_binary = found != formats.end() && found->is_so != is_text;
  if (!is_binary && !describe_unread_format(head).empty()) return nullptr;
  return found == formats.end() ? nullptr : &*found;
}

// What a pipe brings comes once: it is read before anybody asks what it is.
ReadResult open_checked(const path& file) {
  const bool is_regular = std::filesystem::is_regular_file(file);
  std::string head = is_regular ? read_head(file) : std::string();
  const Format* format = find_format(head);
  if (format != nullptr && format->read_file != nullptr) return format->read_file(file);
  const bool is_short = is_regular && std::filesystem::file_size(file) <= config::log_file.max_bytes;
  if (is_short && format == nullptr && !head.empty()) return Failure(file.string() + ": " + why_unread(head));
  auto bytes = config::read_text(file, config::log_file);
  if (!bytes) return Failure(bytes.error());
  head = bytes->substr(0, head_bytes);
  format = find_format(head);
  if (format == nullptr || format->read_bytes == nullptr)
    return Failure(file.string() + ": " + why_unread(head));
  return format->read_bytes(*std::move(bytes), file.string());
}

}  // namespace

ReadResult open_recording(const path& path) {
  try {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return read_bag_folder(path);
    return open_checked(path);
  } catch (const std::bad_alloc&) {
    return Failure(path.string() + ": is too large for the free memory of this machine; split the file");
  } catch (const std::filesystem::filesystem_error& error) {
    return Failure(path.string() + ": cannot be read: " + error.code().message());
  }
}

}  // namespace wheelwright::import
