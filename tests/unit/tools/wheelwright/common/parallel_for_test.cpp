// Work on all cores: each job once, nested work too, and nothing that was thrown is lost.
#include "tools/wheelwright/common/parallel_for.hpp"

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

TEST_CASE("Jobs that hand out further jobs are all done once, and done when the call returns") {
  constexpr std::size_t outer = 40;
  constexpr std::size_t inner = 25;
  const auto parallel_for = tools::parallel_for();
  std::vector<std::atomic<int>> done(outer * inner);
  parallel_for(outer, [&](std::size_t i) {
    parallel_for(inner, [&](std::size_t k) { ++done[i * inner + k]; });
    for (std::size_t k = 0; k < inner; ++k) {
      if (done[i * inner + k] != 1) throw std::logic_error("a call returned before its jobs were done");
    }
  });
  CHECK(std::accumulate(done.begin(), done.end(), 0) == outer * inner);
}

TEST_CASE("What a job throws, the call throws when the other jobs are done") {
  const auto parallel_for = tools::parallel_for();
  std::atomic<int> done = 0;
  const auto work = [&](std::size_t i) {
    if (i == 3) throw std::runtime_error("job 3");
    ++done;
  };
  CHECK_THROWS_WITH(parallel_for(20, work), "job 3");
  CHECK(done == 19);
  CHECK_THROWS_WITH(parallel_for(2, [&](std::size_t) { parallel_for(20, work); }), "job 3");
  CHECK_NOTHROW(parallel_for(20, [](std::size_t) {}));
}
