#include "tools/wheelwright/import/unread_formats.hpp"

#include <array>
#include <cstddef>

namespace wheelwright::import {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::size_t offset = 0;
  std::string_view description;
};

constexpr std::array<Signature, 34> signatures{{
    {"\x1f\x8b"sv, 0, "compressed with gzip; decompress it (gunzip)"},
    {"1AY&SY"sv, 4, "compressed with bzip2; decompress it (bunzip2)"},
    {"\xfd\x37zXZ\0"sv, 0, "compressed with xz; decompress it (unxz)"},
    {"\x28\xb5\x2f\xfd"sv, 0, "compressed with zstd; decompress it (unzstd)"},
    {"\x04\x22\x4d\x18"sv, 0, "compressed with lz4; decompress it (unlz4)"},
    {"7z\xbc\xaf\x27\x1c"sv, 0, "a 7-Zip archive; unpack it"},
    {"Rar!\x1a\x07"sv, 0, "a RAR archive; unpack it"},
    {"ustar"sv, 257, "a tar archive; unpack it (tar -xf)"},
    {"\x89HDF\r\n\x1a\n"sv, 0, "an HDF5 file; export its arrays as CSV"},
    {"PAR1"sv, 0, "a Parquet file; export it as CSV"},
    {"ARROW1\0\0"sv, 0, "an Arrow (Feather) file; export it as CSV"},
    {"\x93NUMPY"sv, 0, "a NumPy array; export it as CSV (numpy.savetxt)"},
    {"\x80\x02"sv, 0, "a Python pickle; export it as CSV"},
    {"\x80\x03"sv, 0, "a Python pickle; export it as CSV"},
    {"\x80\x04"sv, 0, "a Python pickle; export it as CSV"},
    {"\x80\x05"sv, 0, "a Python pickle; export it as CSV"},
    {"RDX2\n"sv, 0, "an R data file; export it as CSV (write.csv)"},
    {"RDX3\n"sv, 0, "an R data file; export it as CSV (write.csv)"},
    {"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, 0, "an old Excel or Office file; export it as CSV"},
    {"ULog\x01\x12\x35"sv, 0, "a PX4 ULog; convert it with ulog2csv"},
    {"\xa3\x95\x80"sv, 0, "an ArduPilot DataFlash log; convert it with mavlogdump.py --format csv"},
    {"#ROSBAG V1"sv, 0, "a ROS bag of version 1; convert it with rosbag migrate (rosbag fix)"},
    {"SQLite format 3\0"sv, 0, "an SQLite database that is no ROS 2 bag"},
    {"\x89PNG\r\n"sv, 0, "a PNG image"},
    {"\xff\xd8\xff"sv, 0, "a JPEG image"},
    {"GIF89a"sv, 0, "a GIF image"},
    {"%PDF"sv, 0, "a PDF document"},
    {"RIFF"sv, 0, "a sound or video file"},
    {"ftyp"sv, 4, "a video file"},
    {"\x7f"
     "ELF"sv,
     0, "a program"},
    {"\xd4\xc3\xb2\xa1"sv, 0, "a network capture"},
    {"version https://git-lfs.github.com/"sv, 0,
     "a pointer of Git LFS, not the file itself; fetch it with git lfs pull"},
    {"<!DOCTYPE"sv, 0, "a web page, not the file itself; download the raw file"},
    {"<html"sv, 0, "a web page, not the file itself; download the raw file"},
}};

std::string describe_zip(std::string_view head) {
  const auto holds = [&](std::string_view name) { return head.find(name) != std::string_view::npos; };
  if (holds("xl/") || holds("[Content_Types].xml")) return "an Excel workbook; save its sheet as CSV";
  if (holds("opendocument.spreadsheet")) return "a LibreOffice sheet; save it as CSV";
  if (holds(".npy")) return "a NumPy archive; export its arrays as CSV (numpy.savetxt)";
  return "a zip archive; unpack it (unzip)";
}

}  // namespace

std::string describe_unread_format(std::string_view head) {
  if (head.starts_with("PK\x03\x04")) return describe_zip(head);
  for (const Signature& signature : signatures) {
    if (head.size() >= signature.offset && head.substr(signature.offset).starts_with(signature.bytes))
      return std::string(signature.description);
  }
  return {};
}

}  // namespace wheelwright::import
