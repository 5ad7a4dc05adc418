#include "model/identification/arma_accumulator.hpp"

#include "tests/allocation/heap_calls.hpp"
#include "tests/support/catch.hpp"

using namespace wheelwright;

TEST_CASE("A live ARMA fit takes its periods without the heap") {
  ArmaAccumulator accumulator({9, 0});
  test::HeapCalls calls{0};
  {
    const test::CountedScope scope(calls);
    for (int k = 0; k < 1000; ++k) {
      const double u = 0.01 * (k % 17);
      if (k == 500) accumulator.lose_past();
      accumulator.add({u, -u}, WheelPair{0.9 * u, -0.8 * u});
    }
  }
  CHECK(calls == 0);
  CHECK(accumulator.rows() == 991);
}
