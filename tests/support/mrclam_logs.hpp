// Where the runs of the MRCLAM data set are: beside the project, or where WHEELWRIGHT_DATA says.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "tests/support/catch.hpp"

namespace wheelwright::test {

// Nothing, and a visible word of it, on a machine without them.
inline std::optional<std::filesystem::path> mrclam_folder() {
  const char* given = std::getenv("WHEELWRIGHT_DATA");
  const auto data = given != nullptr
                        ? std::filesystem::path(given)
                        : std::filesystem::path(WHEELWRIGHT_SOURCE_DIR).parent_path() / "shared" / "data";
  if (std::filesystem::exists(data / "mrclam" / "Robot1_Odometry.dat")) return data / "mrclam";
  WARN("SKIPPED: no MRCLAM runs at " << data);
  SUCCEED("SKIPPED");
  return std::nullopt;
}

}  // namespace wheelwright::test
