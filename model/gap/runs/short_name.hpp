// Names of runs as a sentence has room for: without the folders that all of them share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/gap/runs/run.hpp"

namespace wheelwright::gap {

// Of names that are paths, in their order: "/data/a/run1.csv" and "/data/b/run1.csv" are "a/run1.csv" and
// "b/run1.csv". A name alone keeps its last folder: files of a daemon's runs have one name.
std::vector<std::string> short_names(std::span<const std::string_view> names);

// That of one of these runs.
std::string short_name(std::size_t run, std::span<const GapRun> runs);

}  // namespace wheelwright::gap
