#include "tools/wheelwright/common/output.hpp"

#include "tools/wheelwright/common/commands.hpp"

namespace wheelwright::tools {

void write(const config::OutputFile& file, const std::string& text) {
  if (const auto error = config::write_output(file, text)) throw UsageError(*error);
}

void write(const std::filesystem::path& path, const std::string& text) {
  write({path, config::OutputKind::any}, text);
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    throw UsageError(path.string() +
                     ": cannot be made: " + (error ? error.message() : "a file of that name is there"));
  }
}

}  // namespace wheelwright::tools
