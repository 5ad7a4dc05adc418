// The paper's own identified model (Table I of the source paper): a reference plant for tests.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace wheelwright::test {

class PublishedPlant {
 public:
  static constexpr std::array<double, 9> input_weights{-0.0009, 0.0013,  -0.0004, 0.0178, 0.0769,
                                                       0.0725,  -0.0323, 0.014,   0.0012};
  static constexpr std::array<double, 9> output_weights{0.5395, -0.1391, 0.1447,  0.0971, 0.0403,
                                                        0.0225, -0.0195, -0.0148, -0.0361};

  // Speed over the coming period for the command in force over it.
  double step(double command) {
    for (std::size_t i = inputs_.size() - 1; i > 0; --i) inputs_[i] = inputs_[i - 1];
    inputs_[0] = command;
    double y = 0.0;
    for (std::size_t i = 0; i < input_weights.size(); ++i) y += input_weights[i] * inputs_[i + 1];
    for (std::size_t i = 0; i < output_weights.size(); ++i) y += output_weights[i] * outputs_[i];
    for (std::size_t i = outputs_.size() - 1; i > 0; --i) outputs_[i] = outputs_[i - 1];
    outputs_[0] = y;
    return y;
  }

  static std::vector<double> impulse_response(std::size_t length) {
    PublishedPlant plant;
    std::vector<double> response;
    for (std::size_t k = 0; k < length; ++k) response.push_back(plant.step(k == 0 ? 1.0 : 0.0));
    return response;
  }

  static double dc_gain() {
    double inputs = 0.0;
    double outputs = 0.0;
    for (const double weight : input_weights) inputs += weight;
    for (const double weight : output_weights) outputs += weight;
    return inputs / (1.0 - outputs);
  }

 private:
  std::array<double, 10> inputs_{};
  std::array<double, 9> outputs_{};
};

}  // namespace wheelwright::test
