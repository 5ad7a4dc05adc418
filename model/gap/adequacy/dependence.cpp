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
constexpr int min_visits = 3;
constexpr double break_s = 0.5;  // between two visits

struct Bin {
  double from = 0.0;
  double to = 0.0;
  double count = 0.0;
  double sum = 0.0;         // of innovations
  double error = 0.0;       // sum of increments of the free-run error
  double duration_s = 0.0;  // over which these came about
  int visits = 0;           // times when the covariate came into the bin
  double mean() const { return sum / count; }
};

// Readings in one bin without a longer break: what they have in common by chance, they have in common once.
struct Visit {
  double value = 0.0;  // of the covariate, somewhere in the bin
  double sum = 0.0;
  double count = 0.0;
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

bool is_discontinuity(const ResidualTrack& track, std::size_t i) {
  return track.discontinuity[i] != 0;
}

std::size_t bin_of(double value, std::span<const double> edges) {
  const auto edge = std::ranges::lower_bound(edges, value);
  return std::min(static_cast<std::size_t>(edge - edges.begin()), edges.size() - 1);
}

// Leaves out bins that the covariate seldom came to: there a dependence and a single event look alike.
std::vector<Bin> filled_bins(std::span<const ResidualTrack* const> tracks, const Covariate& covariate,
                             std::span<const double> edges, std::vector<Visit>& visits) {
  std::vector<Bin> bins(edges.size());
  for (std::size_t b = 0; b < bins.size(); ++b) {
    bins[b].to = edges[b];
    bins[b].from = b == 0 ? edges[0] : edges[b - 1];
  }
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const ResidualTrack& track = *tracks[t];
    std::vector<std::optional<double>> left_s(bins.size());
    std::vector<std::size_t> visit_of(bins.size());
    for (std::size_t i = 0; i < track.innovation.size(); ++i) {
      const double value = covariate.value[t][i];
      if (is_discontinuity(track, i) || !std::isfinite(value)) continue;
      const std::size_t b = bin_of(value, edges);
      Bin& bin = bins[b];
      if (!left_s[b] || track.time_s[i] - *left_s[b] > break_s) {
        ++bin.visits;
        visit_of[b] = visits.size();
        visits.push_back({value, 0.0, 0.0});
      }
      left_s[b] = track.time_s[i];
      bin.from = std::min(bin.from, value);
      bin.count += 1.0;
      const double sign = covariate.sign_at(t, i);
      bin.sum += sign * track.innovation[i];
      visits[visit_of[b]].sum += sign * track.innovation[i];
      visits[visit_of[b]].count += 1.0;
      bin.error += sign * (track.error[i] - track.error[i - 1]);
      bin.duration_s += track.time_s[i] - track.time_s[i - 1];
    }
  }
  std::erase_if(bins, [](const Bin& bin) { return bin.visits < min_visits; });
  return bins;
}

// Nothing for a value in a bin that was left out.
const Bin* bin_at(const std::vector<Bin>& bins, double value) {
  const auto bin = std::ranges::lower_bound(bins, value, {}, &Bin::to);
  return bin == bins.end() || value < bin->from ? nullptr : &*bin;
}

// Of the sums of visits about their bins' means, against that of as many independent innovations.
double variance_ratio_of_visits(const std::vector<Visit>& visits, const std::vector<Bin>& bins) {
  double sum_squares = 0.0;
  double count = 0.0;
  double kept = 0.0;
  for (const Visit& visit : visits) {
    const Bin* bin = bin_at(bins, visit.value);
    if (bin == nullptr) continue;
    const double sum = visit.sum - bin->mean() * visit.count;
    sum_squares += sum * sum;
    count += visit.count;
    kept += 1.0;
  }
  const double degrees = kept - static_cast<double>(bins.size());
  return count > 0.0 && degrees > 0.0 ? sum_squares / count * kept / degrees : 1.0;
}

// Variance of sums over so many seconds against that of as many independent innovations, bin means taken out.
double variance_ratio(std::span<const ResidualTrack* const> tracks, const Covariate& covariate,
                      const std::vector<Bin>& bins, double block_s) {
  double sum_squares = 0.0;
  double count = 0.0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const ResidualTrack& track = *tracks[t];
    double sum = 0.0;
    double block_count = 0.0;
    double end_s = block_s;
    const auto close = [&] {
      sum_squares += sum * sum;
      count += block_count;
      sum = block_count = 0.0;
    };
    for (std::size_t i = 0; i < track.innovation.size(); ++i) {
      if (track.time_s[i] >= end_s) {
        close();
        end_s = track.time_s[i] + block_s;
      }
      const double value = covariate.value[t][i];
      if (is_discontinuity(track, i) || !std::isfinite(value)) continue;
      const Bin* bin = bin_at(bins, value);
      if (bin == nullptr) continue;
      sum += covariate.sign_at(t, i) * track.innovation[i] - bin->mean();
      block_count += 1.0;
    }
    close();
  }
  return count > 0.0 ? sum_squares / count : 1.0;
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
  double sum_squares = 0.0;
  double all_sum_squares = 0.0;
  double windows = 0.0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const ResidualTrack& track = *tracks[t];
    double sum = 0.0;
    double change = 0.0;
    double from_s = 0.0;
    for (std::size_t i = 1; i < track.innovation.size(); ++i) {
      const double value = covariate.value[t][i];
      if (!is_discontinuity(track, i) && std::isfinite(value)) {
        const Bin* bin = bin_at(bins, value);
        const double rate =
            bin != nullptr && bin->duration_s > 0.0 ? bin->error / bin->duration_s : mean_rate;
        sum += covariate.sign_at(t, i) * (rate - mean_rate) * (track.time_s[i] - track.time_s[i - 1]);
        change += track.error[i] - track.error[i - 1];
      }
      if (track.time_s[i] - from_s < horizon_s) continue;
      sum_squares += sum * sum;
      all_sum_squares += change * change;
      windows += 1.0;
      sum = change = 0.0;
      from_s = track.time_s[i];
    }
  }
  if (windows == 0.0 || all_sum_squares == 0.0) return {};
  return {std::sqrt(sum_squares / windows), std::min(1.0, sum_squares / all_sum_squares)};
}

}  // namespace

std::optional<Dependence> dependence(std::span<const ResidualTrack* const> tracks,
                                     const Covariate& covariate) {
  std::vector<double> values;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    for (std::size_t i = 0; i < tracks[t]->innovation.size(); ++i) {
      if (!is_discontinuity(*tracks[t], i) && std::isfinite(covariate.value[t][i]))
        values.push_back(covariate.value[t][i]);
    }
  }
  if (values.size() < min_bins * min_readings_per_bin) return std::nullopt;
  const auto edges = edges_of(std::move(values));
  std::vector<Visit> visits;
  const auto bins = filled_bins(tracks, covariate, edges, visits);
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
    const double deviation = bin.mean() - mean;
    const double of_bin = bin.count * deviation * deviation;
    between += of_bin;
    if (bin.duration_s > 0.0) found.rates.emplace_back(0.5 * (bin.from + bin.to), bin.error / bin.duration_s);
    if (of_bin <= largest) continue;
    largest = of_bin;
    found.from = bin.from;
    found.to = bin.to;
    found.share_of_time = bin.count / count;
  }
  double ratio = std::max(1.0, variance_ratio_of_visits(visits, bins));
  for (const double block_s : {2.0, 4.0, 8.0}) {
    ratio = std::max(ratio, variance_ratio(tracks, covariate, bins, block_s));
  }
  found.p_value = chi_squared_tail(between / ratio, static_cast<int>(bins.size()) - 1);
  const OverHorizon over = over_horizon(tracks, covariate, bins);
  found.size = over.size;
  found.share = over.share;
  return found;
}

}  // namespace wheelwright::gap
