#include <cmath>
#include <random>

#include "model/gap/fit/fit_problem.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/counted_run.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

TEST_CASE("Of all noises, the one that a model leaves makes its runs likeliest") {
  std::mt19937 random(3);
  std::normal_distribution<double> step_m(0.0, 2e-4);
  WheelPair drifted_m;
  const TrialModel robot = test::counted_robot();
  FitProblem problem({test::counted_run(robot, 2000, test::steps_to_and_fro,
                                        [&](double, const WheelPair&) {
                                          drifted_m.left += step_m(random);
                                          drifted_m.right += step_m(random);
                                          return drifted_m;
                                        })},
                     {test::counted_metres_per_tick}, serial_for);
  const auto log_likelihood = [&](const NoiseModel& noise) {
    problem.set_noise(noise);
    return problem.log_likelihood(problem.residuals(robot));
  };
  const NoiseModel own = problem.noise_left_by(robot);
  CHECK_THAT(own.channel[0].walk_per_sqrt_s, WithinRel(2e-4 / std::sqrt(test::counted_period_s), 0.2));
  const double likeliest = log_likelihood(own);
  for (const double times : {0.7, 1.4}) {
    NoiseModel other = own;
    for (TravelNoise& channel : other.channel) channel.walk_per_sqrt_s *= times;
    CHECK(log_likelihood(other) < likeliest - 10.0);
  }
}
