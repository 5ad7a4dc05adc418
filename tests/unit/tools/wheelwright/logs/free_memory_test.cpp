#include "tools/wheelwright/logs/free_memory.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright::tools;

TEST_CASE("Logs that do not fit into memory are refused with what they take and what is free") {
  constexpr std::uint64_t gigabyte = 1'000'000'000;
  CHECK_FALSE(find_missing_memory(gigabyte, 8 * gigabyte));
  const auto missing = find_missing_memory(gigabyte, 2 * gigabyte);
  REQUIRE(missing);
  CHECK(*missing ==
        "logs of 1.0 GB take about 8.0 GB of memory, and 2.0 GB are free; give fewer or shorter runs");
}

TEST_CASE("This machine tells how much memory is free") {
  const auto free_bytes = free_memory_bytes();
  REQUIRE(free_bytes);
  CHECK(*free_bytes > 1'000'000);
}
