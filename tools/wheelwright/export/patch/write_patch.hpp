// A patch, from the file that it is made of to the one that it is written to.
#pragma once

#include <functional>
#include <string>

#include "tools/wheelwright/common/commands.hpp"
#include "tools/wheelwright/export/patch/patch.hpp"

namespace wheelwright::tools {

struct PatchPaths {
  std::string model;
  std::string file;
  std::string output;  // in the file's own place where it is empty, and the file is kept as FILE.bak
};

// Throws UsageError where the output may not be written. Call it before any work.
void check_patch_output(const PatchPaths& paths);

// `patch` must find nothing to change in what it has made: that is tried before anything is written. Prints
// what became of each number, or the same as JSON.
ExitStatus write_patch(const PatchPaths& paths, const std::function<Patch(const PatchedFile&)>& patch,
                       bool json, Streams streams);

}  // namespace wheelwright::tools
