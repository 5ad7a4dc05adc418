#include "model/identification/filtered_run.hpp"

namespace wheelwright {
namespace {

// What the recursion adds from its own past.
double from_past(const WheelResponse& response, const PeriodSignal& signal, std::size_t period) {
  double sum = 0.0;
  for (std::size_t i = 0; i < response.from_own_past.size(); ++i) {
    sum += response.from_own_past[i] * signal.speed(period, i + 1);
  }
  return sum;
}

}  // namespace

PeriodSignal::PeriodSignal(std::size_t periods, std::size_t past, double period_s)
    : past_(past), period_s_(period_s), speed_(past + periods, 0.0), travel_(past + periods + 1, 0.0) {}

FilteredRun::FilteredRun(const TravelRun& run, const WheelResponse& response, const ArmaLayout& layout,
                         double period_s, bool with_sensitivities)
    : layout_(layout),
      left_command_(run.commands_m_s.size(), layout.order, period_s),
      right_command_(left_command_),
      output_(left_command_),
      filtered_left_(with_sensitivities ? left_command_ : PeriodSignal(0, 0, period_s)),
      filtered_right_(filtered_left_),
      filtered_output_(filtered_left_) {
  simulate(run, response);
  if (with_sensitivities) filter(run, response);
}

void FilteredRun::simulate(const TravelRun& run, const WheelResponse& response) {
  for (std::size_t k = 0; k < run.commands_m_s.size(); ++k) {
    left_command_.set(k, run.commands_m_s[k].left);
    right_command_.set(k, run.commands_m_s[k].right);
    double speed = from_past(response, output_, k);
    for (std::size_t i = layout_.delay; i <= layout_.order; ++i) {
      speed += response.from_left[i] * left_command_.speed(k, i) +
               response.from_right[i] * right_command_.speed(k, i);
    }
    output_.set(k, speed);
  }
}

void FilteredRun::filter(const TravelRun& run, const WheelResponse& response) {
  for (std::size_t k = 0; k < run.commands_m_s.size(); ++k) {
    filtered_left_.set(k, left_command_.speed(k, 0) + from_past(response, filtered_left_, k));
    filtered_right_.set(k, right_command_.speed(k, 0) + from_past(response, filtered_right_, k));
    filtered_output_.set(k, output_.speed(k, 0) + from_past(response, filtered_output_, k));
  }
}

void FilteredRun::speed_sensitivities(std::size_t period, Eigen::RowVectorXd& row) const {
  Eigen::Index column = 0;
  for (std::size_t i = layout_.delay; i <= layout_.order; ++i) {
    row[column++] = filtered_left_.speed(period, i);
    row[column++] = filtered_right_.speed(period, i);
  }
  for (std::size_t i = 1; i <= layout_.order; ++i) row[column++] = filtered_output_.speed(period, i);
}

void FilteredRun::travel_sensitivities(const TravelReading& reading, Eigen::RowVectorXd& row) const {
  Eigen::Index column = 0;
  for (std::size_t i = layout_.delay; i <= layout_.order; ++i) {
    row[column++] = filtered_left_.travel(reading.period, reading.share, i);
    row[column++] = filtered_right_.travel(reading.period, reading.share, i);
  }
  for (std::size_t i = 1; i <= layout_.order; ++i) {
    row[column++] = filtered_output_.travel(reading.period, reading.share, i);
  }
}

}  // namespace wheelwright
