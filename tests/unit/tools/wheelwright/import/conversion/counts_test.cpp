#include "tools/wheelwright/import/conversion/counts.hpp"

#include <cmath>
#include <vector>

#include "tests/support/catch.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

using namespace wheelwright::import;

namespace {

// A counter of so many bits that goes by `step` at each of 400 rows, forth and then back.
std::vector<double> counter(int bits, double step, bool is_signed, double start = 0.0) {
  const double modulus = std::ldexp(1.0, bits);
  std::vector<double> counts;
  double count = start;
  for (int k = 0; k < 400; ++k) {
    double shown = std::fmod(std::fmod(count, modulus) + modulus, modulus);
    if (is_signed && shown >= modulus / 2) shown -= modulus;
    counts.push_back(shown);
    count += k < 250 ? step : -step;
  }
  return counts;
}

}  // namespace

TEST_CASE("A counter that wraps is known by its jumps and unwrapped at any width, with and without a sign") {
  for (const int bits : {8, 16, 32}) {
    for (const bool is_signed : {false, true}) {
      INFO(bits << " bits" << (is_signed ? ", signed" : ""));
      const double step = std::round(0.03 * std::ldexp(1.0, bits));
      auto counts = counter(bits, step, is_signed);
      REQUIRE(wrapped_bits(counts) == bits);
      CHECK(unwrap(counts, bits) > 2);
      CHECK(counts[250] - counts[0] == 250.0 * step);
      CHECK(counts[399] - counts[250] == -149.0 * step);
    }
  }
}

TEST_CASE("Counts that do not wrap are left alone, whatever their size") {
  CHECK_FALSE(wrapped_bits(counter(40, 17.0, false)));
  CHECK_FALSE(wrapped_bits(counter(40, 170.0, false)));  // beyond 2^15
  const std::vector<double> still(100, 65535.0);
  CHECK_FALSE(wrapped_bits(still));
  std::vector<double> speeds;
  for (int k = 0; k < 100; ++k) speeds.push_back(0.1 * k);
  CHECK_FALSE(wrapped_bits(speeds));
}

TEST_CASE("A wrap is unwrapped across rows without a count") {
  std::vector<double> counts = counter(16, 3000.0, true);
  for (std::size_t k = 3; k < counts.size(); k += 7) counts[k] = NAN;
  REQUIRE(wrapped_bits(counts) == 16);
  unwrap(counts, 16);
  CHECK(counts[250] - counts[0] == 250.0 * 3000.0);
}

TEST_CASE("Values that stand only where they changed are told from values that were measured more rarely") {
  std::vector<double> on_change, rare;
  double way = 0.0;
  double last = -1.0;
  for (int k = 0; k < 300; ++k) {
    way += k / 60 % 2 == 0 ? 0.0 : 0.4;
    const double count = std::floor(way);
    on_change.push_back(count == last ? nothing : count);
    last = count;
    rare.push_back(k % 4 == 0 ? count : nothing);
  }
  CHECK(is_log_on_change(on_change));
  CHECK_FALSE(is_log_on_change(rare));
  fill_down(on_change);
  CHECK(on_change.back() == std::floor(way));
}
