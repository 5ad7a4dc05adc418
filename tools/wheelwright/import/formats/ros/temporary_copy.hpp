// A file behind zstd, unpacked to the folder for temporary files, where it stays as long as this lives.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace wheelwright::import::ros {

class TemporaryCopy {
 public:
  // Or why it cannot be unpacked. What a stream that was cut short gives is kept, and fault() says so.
  static tl::expected<TemporaryCopy, std::string> unpack(const std::filesystem::path& packed);
  TemporaryCopy(TemporaryCopy&& other) noexcept;
  TemporaryCopy& operator=(TemporaryCopy&&) = delete;
  ~TemporaryCopy();

  const std::filesystem::path& path() const { return path_; }
  const std::string& fault() const { return fault_; }

 private:
  explicit TemporaryCopy(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
  std::string fault_;
};

}  // namespace wheelwright::import::ros
