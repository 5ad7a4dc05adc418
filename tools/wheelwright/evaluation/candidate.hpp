// What is compared in the source paper's Table II, and what the paper published of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "model/brain/mission.hpp"

namespace wheelwright::tools {

struct PublishedRow {
  double mean_m;
  double standard_deviation_m;
};

// Which model predicts. The first two come of a calibration, the others of the gap workflow.
enum class Knowledge : std::uint8_t {
  fir,
  arma,
  refitted,  // the linear model of the drives that the gap workflow had, for comparison
  extended,  // the same with the effects that it found
};

constexpr bool is_by_gap_workflow(Knowledge knowledge) {
  return knowledge == Knowledge::refitted || knowledge == Knowledge::extended;
}

struct Candidate {
  PoseSource source;       // that the route is steered by
  Knowledge model;         // odometry asks it only how far the robot still goes when stopped
  std::string_view key;    // in JSON and files
  std::string_view title;  // in tables
  std::optional<PublishedRow> published;
};

// Table II of the source paper: 30 attempts each on a Roomba 560. The hybrid method is described there, but
// not measured.
inline constexpr std::array candidates{
    Candidate{PoseSource::odometry, Knowledge::fir, "odometry", "odometry", PublishedRow{0.068, 0.027}},
    Candidate{PoseSource::fir, Knowledge::fir, "fir", "moving average, sensor-less",
              PublishedRow{0.332, 0.095}},
    Candidate{PoseSource::arma, Knowledge::arma, "arma", "ARMA, sensor-less", PublishedRow{0.258, 0.021}},
    Candidate{PoseSource::hybrid, Knowledge::arma, "hybrid", "hybrid: ARMA and encoders", std::nullopt},
    Candidate{PoseSource::arma, Knowledge::refitted, "refitted", "ARMA of the gap's drives", std::nullopt},
    Candidate{PoseSource::arma, Knowledge::extended, "effects", "ARMA with effects", std::nullopt},
};

}  // namespace wheelwright::tools
