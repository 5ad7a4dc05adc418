#include "tools/wheelwright/gap/run_plots.hpp"

#include "model/prediction/free_run.hpp"
#include "model/prediction/open_loop_runs.hpp"
#include "tools/wheelwright/report/wheel_plots.hpp"

namespace wheelwright::tools {

std::vector<Plot> run_plots(const RobotModel& before, const std::optional<RobotModel>& after,
                            std::span<const DriveLog> runs) {
  std::vector<Plot> plots;
  for (const auto& run : runs) {
    const auto without = free_run(before, run);
    const auto with = after ? open_loop_runs(*after, run).front() : std::vector<PredictedMotion>{};
    std::vector<DrawnRun> drawn{{after ? "before" : "model", after ? Ink::other : Ink::accent, &without}};
    if (after) drawn.push_back({"after", Ink::accent, &with});
    if (run.has_ticks()) plots.push_back(travel_error_plot(run, drawn));
    if (has_headings(run)) plots.push_back(heading_error_plot(run, drawn));
    if (has_path(run)) plots.push_back(path_plot(run, drawn));
  }
  return plots;
}

}  // namespace wheelwright::tools
