#include "config/load/shipped_folder.hpp"

namespace wheelwright::config {

std::filesystem::path shipped_folder() {
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const auto installed = program.parent_path().parent_path() / "share/wheelwright";
  return std::filesystem::exists(installed, ignored) ? installed
                                                     : std::filesystem::path(WHEELWRIGHT_CONFIG_FOLDER);
}

}  // namespace wheelwright::config
