#include "model/gap/adequacy/offset_over_heading.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/gap/adequacy/tail_probability.hpp"
#include "model/gap/noise/correlation_time.hpp"
#include "model/statistics/dense_solve.hpp"

namespace wheelwright::gap {
namespace {

constexpr Eigen::Index columns = 4;

using Row = Eigen::Matrix<double, columns, 1>;

Row harmonics(double heading_rad) {
  return {std::sin(heading_rad), std::cos(heading_rad), std::sin(2.0 * heading_rad),
          std::cos(2.0 * heading_rad)};
}

// The whitened columns of one track, one row per reading; empty where a heading is not known.
std::vector<Row> whitened(const FitProblem& problem, const ResidualTrack& track,
                          std::span<const double> heading) {
  std::vector<Row> rows(heading.size());
  for (Eigen::Index c = 0; c < columns; ++c) {
    std::vector<double> series(heading.size());
    for (std::size_t i = 0; i < heading.size(); ++i) {
      if (!std::isfinite(heading[i])) return {};
      series[i] = harmonics(heading[i])(c);
    }
    const auto column = problem.innovations(track.run, track.channel, series);
    if (!column) return {};
    for (std::size_t i = 0; i < heading.size(); ++i) rows[i](c) = column->values[i];
  }
  return rows;
}

// The robot has to have stood at headings all around: else a harmonic and a constant look alike.
bool turns_around(std::span<const std::vector<double>> heading) {
  constexpr std::size_t sectors = 12;
  constexpr std::ptrdiff_t min_sectors = 8;
  std::array<bool, sectors> visited{};
  for (const auto& of_run : heading) {
    for (const double value : of_run) {
      if (!std::isfinite(value)) continue;
      const double turns = value / (2.0 * std::numbers::pi);
      const auto sector =
          static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(sectors));
      visited.at(std::min(sector, sectors - 1)) = true;
    }
  }
  return std::ranges::count(visited, true) >= min_sectors;
}

// Of sums over 2 s of what the fitted offset leaves, against as many independent ones; at least 1.
double variance_ratio(std::span<const ResidualTrack* const> tracks, const std::vector<std::vector<Row>>& rows,
                      const Row& offset) {
  double sum_squares = 0.0;
  double all = 0.0;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    double sum = 0.0;
    double end_s = independent_after_s;
    for (std::size_t i = 0; i < rows[t].size(); ++i) {
      if (tracks[t]->time_s[i] >= end_s) {
        sum_squares += sum * sum;
        sum = 0.0;
        end_s = tracks[t]->time_s[i] + independent_after_s;
      }
      const double left = tracks[t]->innovation[i] - offset.dot(rows[t][i]);
      sum += left;
      all += left * left;
    }
    sum_squares += sum * sum;
  }
  return all > 0.0 ? std::max(1.0, sum_squares / all) : 1.0;
}

}  // namespace

std::optional<OffsetOverHeading> offset_over_heading(const FitProblem& problem,
                                                     std::span<const ResidualTrack* const> tracks,
                                                     std::span<const std::vector<double>> heading) {
  if (!turns_around(heading)) return std::nullopt;
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Row slope = Row::Zero();
  std::vector<std::vector<Row>> rows;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    rows.push_back(whitened(problem, *tracks[t], heading[t]));
    for (std::size_t i = 0; i < rows[t].size(); ++i) {
      information += rows[t][i] * rows[t][i].transpose();
      slope += tracks[t]->innovation[i] * rows[t][i];
    }
  }
  const auto solution = solve_positive(information, slope);
  if (!(information.trace() > 0.0) || !solution) return std::nullopt;
  const Row offset = *solution;
  OffsetOverHeading found;
  found.p_value =
      chi_squared_tail(slope.dot(offset) / variance_ratio(tracks, rows, offset), static_cast<int>(columns));
  const double first = std::hypot(offset(0), offset(1));
  const double second = std::hypot(offset(2), offset(3));
  found.size = std::max(first, second);
  found.harmonic = second > first ? 2 : 1;
  constexpr int points = 36;
  for (int i = 0; i <= points; ++i) {
    const double heading_rad = std::numbers::pi * (2.0 * i / points - 1.0);
    found.curve.emplace_back(heading_rad, offset.dot(harmonics(heading_rad)));
  }
  return found;
}

}  // namespace wheelwright::gap
