#include "model/gap/adequacy/dependence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/gap/adequacy/tail_probability.hpp"

namespace wheelwright::gap {
namespace {

constexpr std::size_t max_bins = 8;
constexpr std::size_t min_bins = 3;
constexpr std::size_t min_readings_per_bin = 20;
constexpr double horizon_s = 10.0;

struct Bin {
  double from = 0.0;
  double to = 0.0;
  double count = 0.0;
  double sum = 0.0;         // of innovations
  double error = 0.0;       // sum of increments of the free-run error
  double duration_s = 0.0;  // over which these came about
};

// Upper edges of bins of about equal count; equal values share a bin.
std::vector<double> edges_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t bins = std::min(max_bins, values.size() / min_readings_per_bin);
  std::vector<double> edges;
  for (std::size_t b = 1; b <= bins; ++b) {
    const double edge = values[b * values.size() / bins - 1];
    if (edges.empty() || edge > edges.back()) edges.push_back(edge);
  }
  return edges;
}

bool begins_anew(const ResidualTrack& track, std::size_t i) {
  return track.discontinuity[i] != 0;
}

std::size_t bin_of(double value, std::span<const double> edges) {
  const auto edge = std::ranges::lower_bound(edges, value);
  return std::min(static_cast<std::size_t>(edge - edges.begin()), edges.size() - 1);
}

std::vector<Bin> filled_bins(std::span<const ResidualTrack* const> tracks, const Covariate& covariate,
                             std::span<const double> edges) {
  std::vector<Bin> bins(edges.size());
  for (std::size_t b = 0; b < bins.size(); ++b) {
    bins[b].to = edges[b];
    bins[b].from = b == 0 ? edges[0] : edges[b - 1];
  }
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const ResidualTrack& track = *tracks[t];
    for (std::size_t i = 0; i < track.innovation.size(); ++i) {
      const double value = covariate.value[t][i];
      if (begins_anew(track, i) || !std::isfinite(value)) continue;
      Bin& bin = bins[bin_of(value, edges)];
      bin.from = std::min(bin.from, value);
      bin.count += 1.0;
      bin.sum += track.innovation[i];
      bin.error += track.error[i] - track.error[i - 1];
      bin.duration_s += track.time_s[i] - track.time_s[i - 1];
    }
  }
  std::erase_if(bins, [](const Bin& bin) { return bin.count == 0.0; });
  return bins;
}

const Bin& bin_at(const std::vector<Bin>& bins, double value) {
  const auto bin = std::ranges::lower_bound(bins, value, {}, &Bin::to);
  return bin == bins.end() ? bins.back() : *bin;
}

// Variance of sums over so many seconds against that of as many independent innovations, bin means taken out.
double variance_ratio(std::span<const ResidualTrack* const> tracks, const Covariate& covariate,
                      const std::vector<Bin>& bins, double block_s) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const ResidualTrack& track = *tracks[t];
    double sum = 0.0;
    double block_count = 0.0;
    double end_s = block_s;
    const auto close = [&] {
      squares += sum * sum;
      count += block_count;
      sum = block_count = 0.0;
    };
    for (std::size_t i = 0; i < track.innovation.size(); ++i) {
      if (track.time_s[i] >= end_s) {
        close();
        end_s = track.time_s[i] + block_s;
      }
      const double value = covariate.value[t][i];
      if (begins_anew(track, i) || !std::isfinite(value)) continue;
      const Bin& bin = bin_at(bins, value);
      sum += track.innovation[i] - bin.sum / bin.count;
      block_count += 1.0;
    }
    close();
  }
  return count > 0.0 ? squares / count : 1.0;
}

struct OverHorizon {
  double size = 0.0;
  double share = 0.0;
};

// Over windows of the horizon: what the bins' own rates add up to, beside the mean rate, and the whole change
// of the error.
OverHorizon over_horizon(std::span<const ResidualTrack* const> tracks, const Covariate& covariate,
                         const std::vector<Bin>& bins) {
  double error = 0.0;
  double duration_s = 0.0;
  for (const Bin& bin : bins) {
    error += bin.error;
    duration_s += bin.duration_s;
  }
  const double mean_rate = duration_s > 0.0 ? error / duration_s : 0.0;
  double squares = 0.0;
  double all_squares = 0.0;
  double windows = 0.0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const ResidualTrack& track = *tracks[t];
    double sum = 0.0;
    double change = 0.0;
    double from_s = 0.0;
    for (std::size_t i = 1; i < track.innovation.size(); ++i) {
      const double value = covariate.value[t][i];
      if (!begins_anew(track, i) && std::isfinite(value)) {
        const Bin& bin = bin_at(bins, value);
        const double rate = bin.duration_s > 0.0 ? bin.error / bin.duration_s : 0.0;
        sum += (rate - mean_rate) * (track.time_s[i] - track.time_s[i - 1]);
        change += track.error[i] - track.error[i - 1];
      }
      if (track.time_s[i] - from_s < horizon_s) continue;
      squares += sum * sum;
      all_squares += change * change;
      windows += 1.0;
      sum = change = 0.0;
      from_s = track.time_s[i];
    }
  }
  if (windows == 0.0 || all_squares == 0.0) return {};
  return {std::sqrt(squares / windows), std::min(1.0, squares / all_squares)};
}

}  // namespace

std::optional<Dependence> dependence(std::span<const ResidualTrack* const> tracks,
                                     const Covariate& covariate) {
  std::vector<double> values;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    for (std::size_t i = 0; i < tracks[t]->innovation.size(); ++i) {
      if (!begins_anew(*tracks[t], i) && std::isfinite(covariate.value[t][i]))
        values.push_back(covariate.value[t][i]);
    }
  }
  if (values.size() < min_bins * min_readings_per_bin) return std::nullopt;
  const auto edges = edges_of(std::move(values));
  const auto bins = filled_bins(tracks, covariate, edges);
  if (bins.size() < min_bins) return std::nullopt;

  double count = 0.0;
  double sum = 0.0;
  for (const Bin& bin : bins) {
    count += bin.count;
    sum += bin.sum;
  }
  const double mean = sum / count;
  double between = 0.0;
  Dependence found;
  double largest = -1.0;
  for (const Bin& bin : bins) {
    const double deviation = bin.sum / bin.count - mean;
    const double of_bin = bin.count * deviation * deviation;
    between += of_bin;
    if (bin.duration_s > 0.0) found.rates.emplace_back(0.5 * (bin.from + bin.to), bin.error / bin.duration_s);
    if (of_bin <= largest) continue;
    largest = of_bin;
    found.from = bin.from;
    found.to = bin.to;
    found.share_of_time = bin.count / count;
  }
  double ratio = 1.0;
  for (const double block_s : {2.0, 4.0, 8.0}) {
    ratio = std::max(ratio, variance_ratio(tracks, covariate, bins, block_s));
  }
  found.p_value = chi_squared_tail(between / ratio, static_cast<double>(bins.size() - 1));
  const OverHorizon over = over_horizon(tracks, covariate, bins);
  found.size = over.size;
  found.share = over.share;
  return found;
}

}  // namespace wheelwright::gap
