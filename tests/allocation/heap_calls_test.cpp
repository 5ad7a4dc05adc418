#include "tests/allocation/heap_calls.hpp"

#include <Eigen/Dense>
#include <memory>
#include <thread>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright::test;

TEST_CASE("Whoever asks the heap is counted: new, Eigen and the C library, on that thread alone") {
  HeapCalls calls{0};
  std::vector<double> others(1000);
  std::uint64_t after_new = 0;
  std::uint64_t after_eigen = 0;
  {
    const CountedScope scope(calls);
    const auto number = std::make_unique<volatile int>(1);
    after_new = calls;
    Eigen::VectorXd vector(50);
    vector.setOnes();
    after_eigen = calls;
    others.at(0) = vector.sum();
  }
  CHECK(after_new == 1);
  CHECK(after_eigen == 2);
  CHECK(calls == 4);
  std::thread([&] { others.resize(2000); }).join();
  CHECK(calls == 4);
}
