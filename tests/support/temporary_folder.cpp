#include "tests/support/temporary_folder.hpp"

#include <stdlib.h>

#include <stdexcept>
#include <system_error>

namespace wheelwright::test {

TemporaryFolder::TemporaryFolder(const std::string& what) {
  std::string name = (std::filesystem::temp_directory_path() / ("wheelwright_" + what + "_XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be created");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

const std::filesystem::path& temporary_folder() {
  static const TemporaryFolder folder("test");
  return folder.path();
}

}  // namespace wheelwright::test
