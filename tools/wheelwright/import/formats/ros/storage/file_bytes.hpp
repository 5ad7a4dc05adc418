// The bytes of a file, one window at a time: a recording may be larger than the memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace wheelwright::import::ros {

class FileBytes {
 public:
  // A regular file, or one line that names it and says why it cannot be read.
  static tl::expected<FileBytes, std::string> open(const std::filesystem::path& path);
  // Bytes in memory, which must outlive this.
  explicit FileBytes(std::string_view bytes) : memory_(bytes), size_(bytes.size()) {}
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&&) = delete;
  ~FileBytes();

  std::uint64_t size() const { return size_; }
  std::uint64_t left(std::uint64_t offset) const { return offset < size_ ? size_ - offset : 0; }

  // The bytes from `offset`, valid until the next call: `count` of them, or as many as the file has and can
  // be read.
  std::string_view view(std::uint64_t offset, std::uint64_t count);

 private:
  FileBytes(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  void fill(std::uint64_t offset, std::uint64_t count);

  std::string_view memory_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::vector<char> window_;
  std::uint64_t window_offset_ = 0;
  std::uint64_t window_bytes_ = 0;
};

}  // namespace wheelwright::import::ros
