// The free run of one wheel over one run, with the signals that its sensitivities are made of.
#pragma once

#include <cstddef>
#include <vector>

#include "model/identification/arma_layout.hpp"
#include "model/identification/travel_runs.hpp"
#include "model/simulation/linear_model.hpp"

namespace wheelwright {

// A signal that is constant over each period and zero before the run, as a speed and as its travel.
class PeriodSignal {
 public:
  // `past` is how far back one may look before the start of the run.
  PeriodSignal(std::size_t periods, std::size_t past, double period_s);

  void set(std::size_t period, double speed) {
    speed_[past_ + period] = speed;
    travel_[past_ + period + 1] = travel_[past_ + period] + period_s_ * speed;
  }

  // The speed of `lag` periods before; lag may reach `past` periods before the start.
  double speed(std::size_t period, std::size_t lag) const { return speed_[past_ + period - lag]; }

  // Travel from the start of the run to a moment within a period, the whole signal `lag` periods late.
  double travel(std::size_t period, double share, std::size_t lag) const {
    const std::size_t at = past_ + period - lag;
    return travel_[at] + share * period_s_ * speed_[at];
  }

 private:
  std::size_t past_;
  double period_s_;
  std::vector<double> speed_;
  std::vector<double> travel_;
};

class FilteredRun {
 public:
  // Simulates from rest. Without sensitivities only the travel is known after.
  FilteredRun(const TravelRun& run, const WheelResponse& response, const ArmaLayout& layout, double period_s,
              bool with_sensitivities);

  double travel_m(const TravelReading& reading) const {
    return output_.travel(reading.period, reading.share, 0);
  }

  double speed_m_s(std::size_t period) const { return output_.speed(period, 0); }

  // Derivative of the speed in a period after each unknown of the layout, into the head of `row`.
  void speed_sensitivities(std::size_t period, Eigen::RowVectorXd& row) const;

  // Derivative of the travel at a reading after each unknown of the layout, into the head of `row`.
  void travel_sensitivities(const TravelReading& reading, Eigen::RowVectorXd& row) const;

 private:
  void simulate(const TravelRun& run, const WheelResponse& response);
  void filter(const TravelRun& run, const WheelResponse& response);

  ArmaLayout layout_;
  PeriodSignal left_command_;  // as it came
  PeriodSignal right_command_;
  PeriodSignal output_;
  PeriodSignal filtered_left_;  // by 1/A
  PeriodSignal filtered_right_;
  PeriodSignal filtered_output_;
};

}  // namespace wheelwright
