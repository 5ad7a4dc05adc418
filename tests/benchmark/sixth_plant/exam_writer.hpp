#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace plants::sixth {

struct ExamOptions {
  std::filesystem::path output = ".";
  std::uint64_t seed = 1;
  std::string matching = ".*";  // of the names of cases
  bool verbose = false;
};

// Writes the logs of the cases in folders that do not tell, and the answers; says each folder when it is
// done.
void write_exam(const ExamOptions& options);

}  // namespace plants::sixth
