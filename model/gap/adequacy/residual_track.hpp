// What a model leaves of one channel of one run, reading by reading, for the statistics of the predictive
// check.
#pragma once

#include <cstddef>
#include <vector>

#include "model/gap/fit/fit_problem.hpp"
#include "model/gap/fit/trial_model.hpp"

namespace wheelwright::gap {

// Of a free run, over which what a statistic finds adds up to its size.
constexpr double horizon_s = 10.0;

struct ResidualTrack {
  std::size_t run = 0;
  Channel channel = Channel::left;
  std::vector<std::size_t> period;  // grid time of each reading, in periods
  std::vector<double> time_s;       // since the start of the run
  std::vector<double> innovation;   // whitened error: standard normal where the model is adequate
  std::vector<double> error;        // free-run error, m or rad
  std::vector<char> discontinuity;  // 1 where the series begins, or something jumped

  bool of_wheel() const { return channel == Channel::left || channel == Channel::right; }
};

// One track for each channel of each run that has a dense series, under the noise model of the problem.
std::vector<ResidualTrack> residual_tracks(const FitProblem& problem, const TrialModel& model);

}  // namespace wheelwright::gap
