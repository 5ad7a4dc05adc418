// What is compared in the source paper's Table II, and what the paper published of it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "model/brain/mission.hpp"
#include "model/linear_model.hpp"

namespace wheelwright::tools {

struct PublishedRow {
  double mean_m;
  double standard_deviation_m;
};

struct Contender {
  PoseSource source;       // that the route is steered by
  ModelType model;         // that predicts; odometry asks it only how far the robot still goes when stopped
  std::string_view key;    // in JSON and files
  std::string_view title;  // in tables
  std::optional<PublishedRow> published;
};

// PAPER.md, Table II: 30 attempts each on a Roomba 560. The hybrid method is described there, but not
// measured.
inline constexpr std::array contenders{
    Contender{PoseSource::odometry, ModelType::fir, "odometry", "odometry", PublishedRow{0.068, 0.027}},
    Contender{PoseSource::fir, ModelType::fir, "fir", "moving average, sensor-less",
              PublishedRow{0.332, 0.095}},
    Contender{PoseSource::arma, ModelType::arma, "arma", "ARMA, sensor-less", PublishedRow{0.258, 0.021}},
    Contender{PoseSource::hybrid, ModelType::arma, "hybrid", "hybrid: ARMA and encoders", std::nullopt},
};

}  // namespace wheelwright::tools
