// How late the sensor loop woke up during a run: figures, and a histogram over all wake-ups.
#pragma once

#include <string>

#include "daemon/recording/lateness_file.hpp"

namespace wheelwright::tools {

std::string lateness_section(const daemon::LatenessRecord& record);

// The bins of a record put together to four per octave, so that single boxes can be seen.
struct LatenessBox {
  double lower_edge_us = 0.0;
  double upper_edge_us = 0.0;
  std::uint64_t wake_ups = 0;
};
std::vector<LatenessBox> lateness_boxes(const daemon::LatenessRecord& record);

}  // namespace wheelwright::tools
