#include "model/gap/adequacy/residual_track.hpp"

namespace wheelwright::gap {

std::vector<ResidualTrack> residual_tracks(const Problem& problem, const TrialModel& model) {
  std::vector<ResidualTrack> tracks;
  std::vector<RunErrors> errors;
  errors.reserve(problem.runs().size());
  for (const GapRun& run : problem.runs()) errors.push_back(free_run_errors(model, run));
  const std::vector<double> innovations = problem.residuals(errors);
  const auto& places = problem.places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& place = places[i];
    if (!place.channel) continue;
    const GapRun& run = problem.runs()[place.run];
    const Series& series = run[*place.channel];
    if (tracks.empty() || tracks.back().run != place.run || tracks.back().channel != *place.channel) {
      tracks.push_back({place.run, *place.channel, {}, {}, {}, {}, {}});
    }
    ResidualTrack& track = tracks.back();
    track.period.push_back(place.period);
    track.time_s.push_back(seconds_at(run, series.at[place.reading]));
    track.innovation.push_back(innovations[i]);
    track.error.push_back(errors[place.run].series[static_cast<std::size_t>(*place.channel)][place.reading]);
    const bool is_discontinuity = place.reading == 0 || series.restarts[place.reading] != 0;
    track.discontinuity.push_back(is_discontinuity ? char{1} : char{0});
  }
  return tracks;
}

}  // namespace wheelwright::gap
