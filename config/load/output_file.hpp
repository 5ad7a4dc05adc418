// Files that programs write: whole or not at all, and never in the place of somebody else's.
//
// An output may be a new file, an empty one, or one of its own kind, as its content shows. It never replaces
// a file that the command reads, a symbolic link, a device, a pipe, a socket, a folder, or a file of another
// kind. Each refusal is one line with the path and what would be right.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace wheelwright::config {

// What an output holds. `any` is for a file in a folder that the program made itself.
enum class OutputKind {
  any,
  model,
  drive_log,
  pose_log,
  motion,      // of `wheelwright simulate`
  plain_csv,   // of `wheelwright export --csv`
  trajectory,  // TUM format
  mcap,
  page,
  gap,  // gap.json
  evaluation,
  status,
  lateness,
  truth,
  cable_faults,
  c_header,  // of `wheelwright export --to`, as the three below
  ros2_control,
  sdf,
  mujoco,
  ranges,  // of `wheelwright export --ranges`
};

struct OutputFile {
  std::filesystem::path path;
  OutputKind kind = OutputKind::any;
};

using InputFiles = std::vector<std::filesystem::path>;  // empty paths are left out

// True where `head`, the beginning of a file, shows that it is of this kind.
bool is_of_kind(OutputKind kind, std::string_view head);

// Why one of the outputs may not be written, or nothing where all may: call it before work starts. Two
// outputs may not be one file. Inputs are compared by device and inode, so that a hard link is found.
std::optional<std::string> check_outputs(std::span<const OutputFile> outputs, const InputFiles& inputs);

// For a command that fills a folder with files of fixed names: they may be replaced only where the folder
// holds `marker`, of the marker's kind, as the command itself leaves it. The folder need not exist.
std::optional<std::string> check_output_folder(const std::filesystem::path& folder, const OutputFile& marker,
                                               std::span<const std::string_view> names,
                                               const InputFiles& inputs);

// Writes beside the output, syncs, and renames into place. Mode and, where possible, owner of the file that
// was there are kept. After a failure, which is returned, that file is untouched.
std::optional<std::string> write_output(const OutputFile& output, std::string_view text);

// For an output that grows: creates it, or empties the one of its kind, and returns its descriptor.
tl::expected<int, std::string> open_output(const OutputFile& output, const InputFiles& inputs = {});

// All of `text` to a descriptor. False where that fails; errno says why.
bool write_all(int descriptor, std::string_view text);

}  // namespace wheelwright::config
