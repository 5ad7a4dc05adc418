#include "model/log/delay_kernel.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

std::vector<Pose> poses_of(auto pose_at, double period_s) {
  std::vector<Pose> poses;
  for (int k = 0; k < 500; ++k) poses.push_back(pose_at(period_s * k));
  return poses;
}

}  // namespace

TEST_CASE("A kernel has the mean and the width of its weights") {
  const DelayKernel kernel{-0.1, 0.1, {0.25, 0.5, 0.25}};
  CHECK_THAT(kernel.mean_s(), WithinAbs(0.0, 1e-12));
  CHECK_THAT(kernel.width_s(), WithinAbs(0.1 * std::sqrt(0.5), 1e-12));
  CHECK_THAT(kernel.rise_time_s(), WithinAbs(0.22, 1e-12));
  CHECK(DelayKernel{}.rise_time_s() == 0.0);
  CHECK(DelayKernel{}.mean_s() == 0.0);
  CHECK(DelayKernel{}.width_s() == 0.0);
}

TEST_CASE("The rise times of filters are those of their step responses") {
  const double time_constant_s = 0.2;
  DelayKernel low_pass{0.0, 0.01, {}};
  DelayKernel tracking{0.0, 0.01, {}};
  for (int j = 0; j < 400; ++j) {
    const double share = 0.01 * j / time_constant_s;
    low_pass.weights.push_back(0.05 * std::exp(-share));
    tracking.weights.push_back(0.05 * (2.0 - share) * std::exp(-share));
  }
  for (DelayKernel* kernel : {&low_pass, &tracking}) {
    const double sum = std::accumulate(kernel->weights.begin(), kernel->weights.end(), 0.0);
    for (double& weight : kernel->weights) weight /= sum;
  }
  CHECK_THAT(low_pass.rise_time_s(), WithinAbs(2.197 * time_constant_s, 0.03));  // 1 - e^(-x)
  CHECK_THAT(tracking.rise_time_s(), WithinAbs(0.73 * time_constant_s, 0.02));   // 1 - (1 - x) e^(-x)
}

TEST_CASE("A steady motion is shown late by the mean of the kernel") {
  const auto steady = [](double t_s) { return Pose{0.2 * t_s, -0.1 * t_s, 0.5 * t_s}; };
  const ReferenceResponse response{{0.03, 0.05, {0.2, 0.5, 0.3}}, {-0.02, 0.04, {0.5, 0.5}}};
  const auto shown = shown_by(response, poses_of(steady, 0.018), 0.018);
  for (const std::size_t k : {50UL, 300UL}) {
    const double t_s = 0.018 * static_cast<double>(k);
    CHECK_THAT(shown[k].x_m, WithinAbs(0.2 * (t_s - response.position.mean_s()), 1e-9));
    CHECK_THAT(shown[k].y_m, WithinAbs(-0.1 * (t_s - response.position.mean_s()), 1e-9));
    CHECK_THAT(shown[k].theta_rad, WithinAbs(0.5 * (t_s - response.heading.mean_s()), 1e-9));
  }
}

TEST_CASE("A circle is shown smaller by the kernel's response to its frequency") {
  const double rate_rad_s = 2.0;
  const auto circle = [&](double t_s) {
    return Pose{std::cos(rate_rad_s * t_s), std::sin(rate_rad_s * t_s), rate_rad_s * t_s};
  };
  // A mean of two poses that lie 2 d apart has the response cos(rate d).
  const DelayKernel two{0.0, 0.4, {0.5, 0.5}};
  const auto shown = shown_by({two, two}, poses_of(circle, 0.02), 0.02);
  CHECK_THAT(std::hypot(shown[200].x_m, shown[200].y_m), WithinAbs(std::cos(rate_rad_s * 0.2), 1e-9));
}

TEST_CASE("Poses on a grid and poses at any time are shown alike") {
  const double period_s = 0.02;
  const auto motion = [](double t_s) { return Pose{std::sin(t_s), std::cos(2.0 * t_s), 0.3 * t_s * t_s}; };
  const ReferenceResponse response{{-0.06, 0.04, {0.1, 0.4, 0.3, 0.2}}, {0.0, 0.02, {0.7, 0.3}}};
  const auto shown = shown_by(response, poses_of(motion, period_s), period_s);
  for (const std::size_t k : {20UL, 133UL, 400UL}) {
    const Pose pose = shown_at(response, period_s * static_cast<double>(k), motion);
    CHECK_THAT(shown[k].x_m, WithinAbs(pose.x_m, 1e-9));
    CHECK_THAT(shown[k].y_m, WithinAbs(pose.y_m, 1e-9));
    CHECK_THAT(shown[k].theta_rad, WithinAbs(pose.theta_rad, 1e-9));
  }
}

TEST_CASE("Where there is no kernel, poses are shown as they are") {
  const auto poses = poses_of([](double t_s) { return Pose{t_s, 2.0 * t_s, 3.0 * t_s}; }, 0.02);
  const auto shown = shown_by({}, poses, 0.02);
  for (std::size_t k = 0; k < poses.size(); ++k) CHECK(shown[k].x_m == poses[k].x_m);
}
