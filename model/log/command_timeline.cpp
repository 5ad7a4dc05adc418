#include "model/log/command_timeline.hpp"

#include <algorithm>

namespace wheelwright {

CommandTimeline::CommandTimeline(const DriveLog& log) : log_(log) {
  distance_at_row_m_.reserve(log.samples.size());
  WheelPair total;
  for (std::size_t k = 0; k < log.samples.size(); ++k) {
    distance_at_row_m_.push_back(total);
    if (k + 1 == log.samples.size()) break;
    const double duration = log.samples[k + 1].t_s - log.samples[k].t_s;
    total.left += log.samples[k].command_m_s.left * duration;
    total.right += log.samples[k].command_m_s.right * duration;
  }
}

WheelPair CommandTimeline::distance_m(double t_s) const {
  const auto& rows = log_.samples;
  if (rows.empty() || t_s <= rows.front().t_s) return {};
  const auto after = std::upper_bound(rows.begin(), rows.end(), t_s,
                                      [](double t, const DriveSample& sample) { return t < sample.t_s; });
  const auto row = static_cast<std::size_t>(after - rows.begin()) - 1;
  const double into = t_s - rows[row].t_s;
  return {distance_at_row_m_[row].left + rows[row].command_m_s.left * into,
          distance_at_row_m_[row].right + rows[row].command_m_s.right * into};
}

WheelPair CommandTimeline::mean_m_s(double from_s, double to_s) const {
  const WheelPair from = distance_m(from_s);
  const WheelPair to = distance_m(to_s);
  return {(to.left - from.left) / (to_s - from_s), (to.right - from.right) / (to_s - from_s)};
}

}  // namespace wheelwright
