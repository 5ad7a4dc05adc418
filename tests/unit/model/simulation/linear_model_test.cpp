#include "model/simulation/linear_model.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"

using namespace wheelwright;

TEST_CASE("As impulse responses a recursive model drives as it did") {
  LinearModel model{ModelType::arma, 0.018, 0.25, {}, {}};
  model.left = {{0.0, 0.1, 0.06}, {0.0, 0.01, 0.0}, {1.1, -0.25}};
  model.right = {{0.0, 0.0, 0.02}, {0.05, 0.2, 0.0}, {0.8}};
  const LinearModel fir = as_fir(model);
  CHECK(fir.type == ModelType::fir);
  CHECK(fir.left.from_own_past.empty());
  CHECK(fir.wheel_base_m == model.wheel_base_m);
  CHECK_THAT(dc_gain(fir.left).from_left, WithinAbs(dc_gain(model.left).from_left, 1e-12));
  CHECK_THAT(dc_gain(fir.right).from_left, WithinAbs(dc_gain(model.right).from_left, 1e-12));
  LinearPredictor recursive(model);
  LinearPredictor response(fir);
  double off_m_s = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const WheelPair command{std::sin(0.05 * k), k % 90 < 45 ? 0.2 : -0.1};
    const WheelPair one = recursive.step(command);
    const WheelPair other = response.step(command);
    off_m_s = std::max({off_m_s, std::abs(one.left - other.left), std::abs(one.right - other.right)});
  }
  CHECK(off_m_s < 1e-4);
  CHECK(as_fir(fir).left.from_left == fir.left.from_left);
}

TEST_CASE("A tail that hardly decays is cut, and the gain stays") {
  LinearModel model{ModelType::arma, 0.018, 0.25, {}, {}};
  model.left = {{0.001}, {0.0}, {0.999}};
  model.right = {{0.0}, {0.5}, {0.5}};
  const LinearModel fir = as_fir(model);
  CHECK(fir.left.from_left.size() == 200);
  CHECK_THAT(dc_gain(fir.left).from_left, WithinAbs(1.0, 1e-12));
}
