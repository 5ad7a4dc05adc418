// The other YAML files: a route, the daemon's configuration, a simulated robot, a room. The first byte says
// which.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "config/load/daemon_config.hpp"
#include "config/load/route_file.hpp"
#include "config/load/simulation_config.hpp"
#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

namespace {

std::filesystem::path written(const std::string& text) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("wheelwright_fuzz_" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text = fuzz::as_text(data + 1, size - 1);
  try {
    switch (data[0]) {
      case 'd':
        // What the daemon writes of its configuration beside the logs is read again by replay.
        config::load_daemon_config(
            written(config::daemon_config_to_yaml(config::load_daemon_config(written(text)))));
        break;
      case 's':
        config::load_simulation_config(written(text));
        break;
      case 'r':
        config::load_room(written(text));
        break;
      default: {
        auto file = config::YamlReader::parse(text, "fuzz.yaml");
        config::read_route(file);
        file.finish();
      }
    }
  } catch (const config::ConfigError&) {
  }
  return 0;
}
