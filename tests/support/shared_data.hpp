// Files of others that lie beside the project, or where WHEELWRIGHT_DATA says.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/catch.hpp"

namespace wheelwright::test {

// A folder of them; nothing, and a visible word of it, on a machine without.
inline std::optional<std::filesystem::path> shared_data(const std::string& folder) {
  const char* given = std::getenv("WHEELWRIGHT_DATA");
  const auto data = given != nullptr
                        ? std::filesystem::path(given)
                        : std::filesystem::path(WHEELWRIGHT_SOURCE_DIR).parent_path() / "shared" / "data";
  if (std::filesystem::exists(data / folder)) return data / folder;
  WARN("SKIPPED: no " << folder << " at " << data << "; set WHEELWRIGHT_DATA");
  SUCCEED("SKIPPED");
  return std::nullopt;
}

}  // namespace wheelwright::test
