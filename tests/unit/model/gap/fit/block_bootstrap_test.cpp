#include "model/gap/fit/block_bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

namespace {

constexpr std::size_t block_length = 100;

// Errors of variance 1 of which each holds on to `memory` of the one before.
std::vector<double> errors(std::size_t count, double memory, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> result;
  double last = normal(random);
  for (std::size_t i = 0; i < count; ++i) {
    last = memory * last + std::sqrt(1.0 - memory * memory) * normal(random);
    result.push_back(last);
  }
  return result;
}

// The mean of readings: residual = mean - reading.
struct Mean {
  double value = 0.0;
  std::vector<BlockSums> blocks;
};

Mean mean_of(const std::vector<double>& readings) {
  Mean mean;
  for (const double reading : readings) mean.value += reading / static_cast<double>(readings.size());
  for (std::size_t i = 0; i < readings.size(); i += block_length) {
    BlockSums block{Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Zero(1)};
    for (std::size_t k = i; k < i + block_length; ++k) {
      block.information(0, 0) += 1.0;
      block.gradient(0) += mean.value - readings[k];
    }
    mean.blocks.push_back(block);
  }
  return mean;
}

double deviation_of(const Eigen::MatrixXd& draws) {
  return std::sqrt(draws.row(0).squaredNorm() / static_cast<double>(draws.cols()));
}

}  // namespace

TEST_CASE("Of white errors the bootstrap finds the scatter of a mean, sigma by the root of n") {
  std::mt19937_64 random(1);
  const auto mean = mean_of(errors(20000, 0.0, random));
  const auto bootstrap = block_bootstrap(mean.blocks, 1000, 1);
  CHECK_THAT(bootstrap.white_deviations(0), WithinRel(1.0 / std::sqrt(20000.0), 1e-9));
  CHECK_THAT(deviation_of(bootstrap.deviations), WithinRel(1.0 / std::sqrt(20000.0), 0.15));
}

TEST_CASE("Of errors that hang together it finds as much more as theory says, where white ones would not") {
  // Variance of the mean of an AR(1) series: (1 + a) / (1 - a) times that of a white one.
  std::mt19937_64 random(2);
  const double memory = 0.9;
  const auto mean = mean_of(errors(40000, memory, random));
  const auto bootstrap = block_bootstrap(mean.blocks, 1000, 1);
  const double theory = std::sqrt((1.0 + memory) / (1.0 - memory) / 40000.0);
  CHECK_THAT(deviation_of(bootstrap.deviations), WithinRel(theory, 0.2));
  CHECK(bootstrap.white_deviations(0) < 0.3 * theory);
}

TEST_CASE("Its 95 % intervals hold the truth about 95 times of 100") {
  std::mt19937_64 random(3);
  int held = 0;
  constexpr int trials = 400;
  for (int trial = 0; trial < trials; ++trial) {
    const auto mean = mean_of(errors(40 * block_length, 0.8, random));
    const auto draws = block_bootstrap(mean.blocks, 400, 1).deviations;
    std::vector<double> sorted(draws.row(0).begin(), draws.row(0).end());
    std::ranges::sort(sorted);
    held += mean.value + sorted[9] < 0.0 && mean.value + sorted[390] > 0.0 ? 1 : 0;
  }
  CHECK(held > 0.91 * trials);
  CHECK(held < 0.98 * trials);
}

TEST_CASE("A parameter of which nothing is known stays where it is and spoils no other") {
  std::mt19937_64 random(4);
  auto mean = mean_of(errors(4000, 0.0, random));
  for (auto& block : mean.blocks) {
    block.information.conservativeResizeLike(Eigen::MatrixXd::Zero(2, 2));
    block.gradient.conservativeResizeLike(Eigen::VectorXd::Zero(2));
  }
  const auto bootstrap = block_bootstrap(mean.blocks, 200, 1);
  CHECK(bootstrap.deviations.row(1).cwiseAbs().maxCoeff() == 0.0);
  CHECK_THAT(deviation_of(bootstrap.deviations), WithinRel(1.0 / std::sqrt(4000.0), 0.3));
}

TEST_CASE("A parameter that a single block shows has a finite scatter in every draw") {
  std::mt19937_64 random(5);
  auto mean = mean_of(errors(4000, 0.0, random));
  for (std::size_t k = 0; k < mean.blocks.size(); ++k) {
    mean.blocks[k].information.conservativeResizeLike(Eigen::MatrixXd::Zero(2, 2));
    mean.blocks[k].gradient.conservativeResizeLike(Eigen::VectorXd::Zero(2));
  }
  mean.blocks[7].information(1, 1) = 4.0;
  mean.blocks[7].gradient(1) = 1.0;
  const auto bootstrap = block_bootstrap(mean.blocks, 500, 1);
  CHECK(bootstrap.deviations.allFinite());
  CHECK(bootstrap.deviations.row(1).cwiseAbs().maxCoeff() < 1.0);
}
