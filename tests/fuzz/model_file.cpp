// A model file: read, written, read again, and run.
#include <cmath>

#include "config/load/model_file.hpp"
#include "model/simulation/motion_predictor.hpp"
#include "tests/fuzz/fuzz_input.hpp"

using namespace wheelwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  RobotModel model;
  try {
    model = config::parse_model(fuzz::as_text(data, size), "fuzz.yaml");
  } catch (const config::ConfigError&) {
    return 0;
  }
  // What was accepted once is accepted again: the daemon reads what it wrote.
  config::parse_model(config::model_to_yaml(model), "written.yaml");
  return 0;
}
