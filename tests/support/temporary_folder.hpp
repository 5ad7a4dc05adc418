// Folders that are gone when they are no longer needed.
#pragma once

#include <filesystem>
#include <string>

namespace wheelwright::test {

class TemporaryFolder {
 public:
  // `what` stands in the folder's name, for whoever finds it left over.
  explicit TemporaryFolder(const std::string& what);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// A folder of this process's own, since tests run side by side, each in a process. Gone when the process
// ends.
const std::filesystem::path& temporary_folder();

}  // namespace wheelwright::test
