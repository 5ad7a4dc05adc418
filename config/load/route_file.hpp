// Routes as files: YAML with `name`, `speed` (m/s), `tolerance` (m) and `checkpoints`, a list of [x, y] in
// metres relative to the start pose (x forward, y left), visited in order. A closed route ends at [0, 0].
#pragma once

#include <filesystem>

#include "config/load/yaml_reader.hpp"
#include "model/route/route.hpp"

namespace wheelwright::config {

// Speed 0.03 to 0.5 m/s and tolerance 0.002 to 0.5 m, both with the defaults of Route where absent; at least
// one checkpoint, none equal to the one before. Throws ConfigError with file, line and column.
Route load_route(const std::filesystem::path& path);

// The same from a mapping that stands in another file.
Route read_route(YamlReader& file);

}  // namespace wheelwright::config
