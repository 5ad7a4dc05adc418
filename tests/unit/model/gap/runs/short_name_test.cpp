#include "model/gap/runs/short_name.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

std::vector<std::string> shortened(const std::vector<std::string_view>& names) {
  return gap::short_names(names);
}

}  // namespace

TEST_CASE("Names of runs are told apart without the folders that all of them share") {
  using Names = std::vector<std::string>;
  CHECK(shortened({"/data/run1.csv", "/data/run2.csv"}) == Names{"run1.csv", "run2.csv"});
  CHECK(shortened({"runs/10/drive_log.csv", "runs/11/drive_log.csv"}) ==
        Names{"10/drive_log.csv", "11/drive_log.csv"});
  CHECK(shortened({"run1.csv", "/data/run2.csv"}) == Names{"run1.csv", "/data/run2.csv"});
  CHECK(shortened({"bag", "bag (2)"}) == Names{"bag", "bag (2)"});
  CHECK(shortened({"/data/run1.csv", "/data/run1.csv"}) == Names{"run1.csv", "run1.csv"});
  CHECK(shortened({}).empty());
}

TEST_CASE("The name of a run alone keeps its last folder") {
  using Names = std::vector<std::string>;
  CHECK(shortened({"/robot/runs/10/drive_log.csv"}) == Names{"10/drive_log.csv"});
  CHECK(shortened({"data/run1.csv"}) == Names{"data/run1.csv"});
  CHECK(shortened({"run1.csv"}) == Names{"run1.csv"});
  CHECK(shortened({"/run1.csv"}) == Names{"/run1.csv"});
}
