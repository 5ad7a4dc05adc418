#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

std::vector<ResidualTrack> residual_tracks(const FitProblem& problem, const TrialModel& model) {
  std::vector<ResidualTrack> tracks;
  std::vector<RunErrors> errors;
  errors.reserve(problem.runs().size());
  for (const GapRun& run : problem.runs()) errors.push_back(free_run_errors(model, run));
  const std::vector<double> innovations = problem.residuals(errors);
  const auto& indices = problem.indices();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto& index = indices[i];
    if (!index.channel) continue;
    const GapRun& run = problem.runs()[index.run];
    const Series& series = run[*index.channel];
    if (tracks.empty() || tracks.back().run != index.run || tracks.back().channel != *index.channel) {
      tracks.push_back({index.run, *index.channel, {}, {}, {}, {}, {}});
    }
    ResidualTrack& track = tracks.back();
    track.period.push_back(index.period);
    track.time_s.push_back(seconds_at(run, series.at[index.reading]));
    track.innovation.push_back(innovations[i]);
    track.error.push_back(errors[index.run].series[static_cast<std::size_t>(*index.channel)][index.reading]);
    const bool is_discontinuity = index.reading == 0 || series.restarts[index.reading] != 0;
    track.discontinuity.push_back(is_discontinuity ? char{1} : char{0});
  }
  return tracks;
}

}  // namespace wheelwright::gap
