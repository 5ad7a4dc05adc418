#include "config/load/route_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;

namespace {

std::filesystem::path shipped(const std::string& name) {
  return std::filesystem::path(WHEELWRIGHT_SOURCE_DIR) / "config" / "routes" / name;
}

// The error without the name of the temporary folder.
std::string error_of(const std::string& text) {
  const auto path = test::temporary_folder() / "wheelwright_route.yaml";
  std::ofstream(path) << text;
  std::string what = "no error";
  try {
    config::load_route(path);
  } catch (const config::ConfigError& error) {
    what = std::string(error.what()).substr(path.parent_path().string().size() + 1);
  }
  std::filesystem::remove(path);
  return what;
}

const std::string head = "name: a\nspeed: 0.2\ntolerance: 0.02\n";

}  // namespace

TEST_CASE("Every shipped route loads, is closed, and stays on a small floor") {
  int routes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shipped(""))) {
    INFO(entry.path());
    const Route route = config::load_route(entry.path());
    CHECK(route.name == entry.path().stem().string());
    CHECK(is_closed(route));
    for (const auto& checkpoint : route.checkpoints) {
      CHECK(std::abs(checkpoint.x_m) <= 2.0);
      CHECK(std::abs(checkpoint.y_m) <= 1.5);
    }
    ++routes;
  }
  CHECK(routes >= 3);
}

TEST_CASE("The figure of eight has a checkpoint about every 0.2 m") {
  const Route route = config::load_route(shipped("figure_of_eight.yaml"));
  Checkpoint before;
  for (const auto& checkpoint : route.checkpoints) {
    CHECK_THAT(std::hypot(checkpoint.x_m - before.x_m, checkpoint.y_m - before.y_m), WithinAbs(0.195, 0.001));
    before = checkpoint;
  }
}

TEST_CASE("Every fault of a route file is refused with its place") {
  CHECK(error_of(head + "checkpoints: [[1, 0]]\n") == "no error");
  CHECK_THAT(error_of(head), ContainsSubstring("'checkpoints' is missing"));
  CHECK(error_of(head + "checkpoints: []\n") ==
        "wheelwright_route.yaml:4:14: 'checkpoints' is empty, but must hold at least one [x, y]");
  CHECK_THAT(error_of(head + "checkpoints: [[1, 0], [1, 0.0], [0, 0]]\n"),
             ContainsSubstring("holds [1, 0] twice in a row (number 1 and 2)"));
  CHECK_THAT(error_of(head + "checkpoints: [[0, 0]]\n"), ContainsSubstring("where the robot stands already"));
  CHECK_THAT(error_of(head + "checkpoints: [[1, 0, 0]]\n"), ContainsSubstring("rows of 2 numbers"));
  CHECK_THAT(error_of(head + "checkpoints: [[1, .nan]]\n"), ContainsSubstring("must be a number"));
  CHECK_THAT(error_of("name: a\nspeed: 0.6\ncheckpoints: [[1, 0]]\n"),
             ContainsSubstring("2:8: 'speed' is 0.6, but must be a number from 0.03 to 0.5 m/s"));
  CHECK_THAT(error_of("name: a\ntolerance: 2\ncheckpoints: [[1, 0]]\n"), ContainsSubstring("0.002 to 0.5 m"));
  CHECK_THAT(error_of(head + "checkpoint: [[1, 0]]\ncheckpoints: [[1, 0]]\n"),
             ContainsSubstring("did you mean 'checkpoints'?"));
}
