#include "tools/wheelwright/import/open_recording.hpp"

namespace wheelwright::import {

ReadResult open_recording(const std::filesystem::path& path) {
  return tl::unexpected(path.string() + ": no reader knows this format");
}

}  // namespace wheelwright::import
