// Files of any known format as drive logs, from their bytes to runs: open, find out what is what, convert.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "tools/wheelwright/import/conversion/convert.hpp"
#include "tools/wheelwright/import/inference/infer_mapping.hpp"
#include "tools/wheelwright/import/mapping/given_mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

struct ImportRequest {
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> reference;  // with a clock of its own
  GivenMapping given;
};

// Recordings that belong together, and what they were taken for.
struct Understood {
  std::string name;  // of the files, for messages
  std::vector<Recording> recordings;
  Inference inference;
  Mapping mapping;
};

// Fails, with one line, where a file cannot be read; throws config::ConfigError where what is given
// contradicts itself.
tl::expected<Understood, std::string> understand(const ImportRequest& request);

// The runs, or one line that says what has to be given, with the option.
tl::expected<Conversion, std::string> to_runs(const Understood& understood);

}  // namespace wheelwright::import
