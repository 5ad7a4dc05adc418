#include "config/load/atomic_file.hpp"

#include "config/load/output_file.hpp"

namespace wheelwright::config {

std::optional<std::string> write_file_atomically(const std::filesystem::path& path, const std::string& text) {
  return write_output({path, OutputKind::any}, text);
}

}  // namespace wheelwright::config
