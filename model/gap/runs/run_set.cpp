#include "model/gap/runs/run_set.hpp"

#include <utility>

namespace wheelwright::gap {

void RunSet::add(GapRun run, const DriveLog& log) {
  runs.push_back(std::move(run));
  metres_per_tick.push_back(log.metres_per_tick.value_or(WheelPair{}));
  logs.push_back(log);
}

void RunSet::move_to(RunSet& other, std::size_t index) {
  const auto at = static_cast<std::ptrdiff_t>(index);
  other.add(std::move(runs[index]), logs[index]);
  runs.erase(runs.begin() + at);
  logs.erase(logs.begin() + at);
  metres_per_tick.erase(metres_per_tick.begin() + at);
}

}  // namespace wheelwright::gap
