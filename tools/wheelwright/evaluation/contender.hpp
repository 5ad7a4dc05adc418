// What is compared in the source paper's Table II, and what the paper published of it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace wheelwright::tools {

// What a route is steered by.
enum class Contender { odometry, fir, arma };

struct PublishedRow {
  double mean_m;
  double standard_deviation_m;
};

struct ContenderInfo {
  Contender contender;
  std::string_view key;    // in JSON and file names
  std::string_view title;  // in tables
  std::optional<PublishedRow> published;
};

// PAPER.md, Table II: 30 attempts each on a Roomba 560.
inline constexpr std::array contenders{
    ContenderInfo{Contender::odometry, "odometry", "odometry", PublishedRow{0.068, 0.027}},
    ContenderInfo{Contender::fir, "fir", "moving average, sensor-less", PublishedRow{0.332, 0.095}},
    ContenderInfo{Contender::arma, "arma", "ARMA, sensor-less", PublishedRow{0.258, 0.021}},
};

}  // namespace wheelwright::tools
