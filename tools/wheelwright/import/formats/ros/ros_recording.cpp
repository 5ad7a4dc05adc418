#include "tools/wheelwright/import/formats/ros/ros_recording.hpp"

#include "config/load/printable_text.hpp"
#include "tools/wheelwright/import/formats/ros/bag1/scan_bag1.hpp"
#include "tools/wheelwright/import/formats/ros/bag_folder.hpp"
#include "tools/wheelwright/import/formats/ros/bag_recording.hpp"
#include "tools/wheelwright/import/formats/ros/db3/scan_db3.hpp"
#include "tools/wheelwright/import/formats/ros/mcap/scan_mcap.hpp"
#include "tools/wheelwright/import/formats/ros/storage/file_bytes.hpp"
#include "tools/wheelwright/import/formats/ros/temporary_copy.hpp"

namespace wheelwright::import {
namespace {

using ros::BagRecording;
using ros::FileBytes;

constexpr std::uint64_t head_bytes = 16;

// The name of the format, or why the file cannot be read.
using Scan = tl::expected<std::string, std::string>;

Scan scan_bytes(FileBytes& file, const std::string& label, BagRecording& recording) {
  if (is_ros1_bag(file.view(0, head_bytes))) {
    if (auto why = ros::scan_bag1(file, label, recording)) return tl::unexpected(*std::move(why));
    return std::string(ros::bag1_format);
  }
  ros::McapScan scan = ros::scan_mcap(file, label, recording);
  if (scan.refusal) return tl::unexpected(*std::move(scan.refusal));
  return ros::mcap_format(scan.profile);
}

// A file of any kind, by its first bytes.
Scan scan_file(const std::filesystem::path& path, const std::string& label, BagRecording& recording) {
  auto file = FileBytes::open(path);
  if (!file) return tl::unexpected(file.error().substr(path.string().size() + 2));
  const std::string head(file->view(0, head_bytes));
  if (is_sqlite(head)) {
    if (auto why = ros::scan_db3(path, label, recording)) return tl::unexpected(*std::move(why));
    return std::string(ros::db3_format);
  }
  if (is_ros1_bag(head) || is_mcap(head)) return scan_bytes(*file, label, recording);
  return tl::unexpected(std::string("is neither an MCAP file nor an SQLite file nor a bag of ROS 1"));
}

Scan scan_unpacked(const std::filesystem::path& path, const std::string& label, BagRecording& recording) {
  const auto copy = ros::TemporaryCopy::unpack(path);
  if (!copy) return tl::unexpected(copy.error().substr(path.string().size() + 2));
  recording.note_compression("zstd");
  if (!copy->fault().empty()) recording.remark(label + copy->fault());
  return scan_file(copy->path(), label, recording);
}

Scan scan_packed_or_not(const std::filesystem::path& path, const std::string& label,
                        BagRecording& recording) {
  auto file = FileBytes::open(path);
  if (file && is_zstd(file->view(0, head_bytes))) return scan_unpacked(path, label, recording);
  return scan_file(path, label, recording);
}

ReadResult finish(const Scan& scan, const std::string& name, BagRecording& recording) {
  if (!scan) return tl::unexpected(name + ": " + scan.error());
  return recording.finish(*scan, 1);
}

}  // namespace

bool is_ros1_bag(std::string_view head) {
  return head.starts_with("#ROSBAG V") || head.starts_with("#ROSRECORD V");
}

bool is_mcap(std::string_view head) {
  return head.starts_with("\x89MCAP");
}

bool is_sqlite(std::string_view head) {
  return head.starts_with(std::string_view("SQLite format 3\0", 16));
}

bool is_zstd(std::string_view head) {
  return ros::is_zstd(head);
}

ReadResult read_ros_file(const std::filesystem::path& path) {
  BagRecording recording(path.string());
  return finish(scan_packed_or_not(path, "", recording), path.string(), recording);
}

ReadResult read_ros_bytes(std::string_view bytes, const std::string& name) {
  FileBytes file(bytes);
  BagRecording recording(name);
  return finish(scan_bytes(file, "", recording), name, recording);
}

ReadResult read_bag_folder(const std::filesystem::path& path) {
  const auto folder = ros::list_bag_folder(path);
  if (!folder) return tl::unexpected(path.string() + ": " + folder.error());
  BagRecording recording(path.string());
  for (const std::string& remark : folder->remarks) recording.remark(remark);
  std::string format;
  std::size_t read = 0;
  for (const std::filesystem::path& file : folder->files) {
    const std::string name = config::excerpt(file.filename().string());
    const Scan scan = scan_packed_or_not(file, folder->files.size() > 1 ? name + ": " : "", recording);
    if (scan) {
      format = *scan;
      ++read;
    } else if (folder->files.size() == 1) {
      return tl::unexpected(file.string() + ": " + scan.error());
    } else {
      recording.remark(name + ": " + scan.error() + "; it is left out");
    }
  }
  if (read == 0)
    return tl::unexpected(path.string() +
                          ": none of its files can be read: " + folder->files.front().filename().string() +
                          " and the others are damaged or of another format");
  return recording.finish(format, folder->files.size());
}

}  // namespace wheelwright::import
