#include "model/identification/arx_fit.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/plant_run.hpp"

using namespace wheelwright;

namespace {

// Largest difference of any weight of a wheel that answers as the published plant to its own motor.
double distance_from_plant(const WheelResponse& response, const std::vector<double>& own,
                           const std::vector<double>& other) {
  double largest = 0.0;
  const auto& inputs = test::PublishedPlant::input_weights;
  const auto& outputs = test::PublishedPlant::output_weights;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double expected = i >= 1 && i <= inputs.size() ? inputs[i - 1] : 0.0;
    largest = std::max({largest, std::abs(own[i] - expected), std::abs(other[i])});
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    largest = std::max(largest, std::abs(response.from_own_past[i] - outputs[i]));
  }
  return largest;
}

double distance_from_plant(const LinearModel& model) {
  return std::max(distance_from_plant(model.left, model.left.from_left, model.left.from_right),
                  distance_from_plant(model.right, model.right.from_right, model.right.from_left));
}

}  // namespace

TEST_CASE("The published plant is recovered from 1000 noise-free rows") {
  const DriveLog log = test::plant_run({.rows = 1000});
  for (const ArxMethod method : {ArxMethod::equation_error, ArxMethod::free_run}) {
    const auto fit = fit_arx(std::span(&log, 1), {.order = 9, .method = method});
    REQUIRE(fit);
    CHECK(distance_from_plant(fit->model) < 1e-8);
    CHECK(fit->rows == 999);
    CHECK(fit->left.rank == 29);
    CHECK(fit->left.condition < 1e4);
    CHECK_THAT(fit->left.largest_pole, WithinAbs(0.78, 0.01));
  }
}
