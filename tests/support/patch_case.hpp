// `wheelwright export MODEL --to FORMAT --patch FILE` as tests call it.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "config/load/model_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/wheelwright_command.hpp"

namespace wheelwright::test {

inline std::string file_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A folder with a model and a file to patch.
class PatchCase {
 public:
  PatchCase(const std::string& name, const RobotModel& model, const std::string& text)
      : folder_(temporary_folder() / name) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    config::save_model(model, folder_ / "model.yaml");
    write(text);
  }

  void write(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
  std::filesystem::path file() const { return folder_ / "robot"; }
  std::filesystem::path beside(const std::string& name) const { return folder_ / name; }
  std::string text() const { return file_text(file()); }

  Outcome run(const std::string& format, const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{
        "export", (folder_ / "model.yaml").string(), "--to", format, "--patch", file().string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return wheelwright_command(arguments);
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace wheelwright::test
