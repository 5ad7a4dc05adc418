// Commands to be driven as they stand: a drive log, or the keys of one in YAML.
#pragma once

#include <filesystem>

#include "config/load/yaml_reader.hpp"
#include "model/brain/commanded_drive.hpp"

namespace wheelwright::config {

// The commands of a drive log of one run. Throws LogError for what is not as the format says, and ConfigError
// for a command faster than `largest_speed_m_s`.
CommandedDrive load_commands(const std::filesystem::path& path, double largest_speed_m_s);

// The same from a section with the keys name, duration_s and the lists t_s, left_m_s and right_m_s.
CommandedDrive read_commands(YamlReader& section, double largest_speed_m_s);

}  // namespace wheelwright::config
