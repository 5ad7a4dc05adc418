#include "config/load/route_file.hpp"

#include "config/load/one_line_text.hpp"
#include "config/load/text_format.hpp"

namespace wheelwright::config {
namespace {

constexpr std::size_t max_checkpoints = 10000;

void check(const YamlReader& file, const std::vector<Checkpoint>& checkpoints) {
  if (checkpoints.empty()) file.fail("checkpoints", "is empty, but must hold at least one [x, y]");
  if (checkpoints.size() > max_checkpoints) {
    file.fail("checkpoints", "holds " + std::to_string(checkpoints.size()) + " checkpoints, but at most " +
                                 std::to_string(max_checkpoints) + " are allowed");
  }
  for (std::size_t i = 1; i < checkpoints.size(); ++i) {
    const Checkpoint& here = checkpoints[i];
    if (here.x_m != checkpoints[i - 1].x_m || here.y_m != checkpoints[i - 1].y_m) continue;
    file.fail("checkpoints", "holds [" + plain_number(here.x_m) + ", " + plain_number(here.y_m) +
                                 "] twice in a row (number " + std::to_string(i) + " and " +
                                 std::to_string(i + 1) + "); keep one");
  }
  if (checkpoints.size() == 1 && checkpoints[0].x_m == 0.0 && checkpoints[0].y_m == 0.0) {
    file.fail("checkpoints", "holds only [0, 0], where the robot stands already; add a place to drive to");
  }
}

}  // namespace

Route load_route(const std::filesystem::path& path) {
  YamlReader file = YamlReader::load(path);
  return read_route(file);
}

Route read_route(YamlReader& file) {
  Route route;
  route.name = one_line_text(file, "name");
  route.speed_m_s = file.number("speed", {0.03, 0.5, "m/s"}, route.speed_m_s);
  route.tolerance_m = file.number("tolerance", {0.002, 0.5, "m"}, route.tolerance_m);
  for (const auto& row : file.rows("checkpoints", 2, {-100.0, 100.0, "m"})) {
    route.checkpoints.push_back({row[0], row[1]});
  }
  check(file, route.checkpoints);
  file.finish();
  return route;
}

}  // namespace wheelwright::config
