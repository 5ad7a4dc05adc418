#include "tools/wheelwright/import/inference/pose_columns.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "model/statistics/dense_solve.hpp"
#include "tools/wheelwright/import/conversion/counts.hpp"
#include "tools/wheelwright/import/conversion/value_range.hpp"
#include "tools/wheelwright/import/inference/placed_columns.hpp"
#include "tools/wheelwright/import/inference/quaternion_columns.hpp"

namespace wheelwright::import {
namespace {

constexpr double pose_explained = 0.9;
constexpr double hole_s = 10.0;  // between runs

// Rows of one run. Files that were read together each start wherever the robot was put.
struct Rows {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<Rows> runs_of(const std::vector<double>& t_s) {
  std::vector<Rows> runs{{0, t_s.size()}};
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    const double step_s = t_s[i] - t_s[i - 1];
    if (!(step_s < 0.0 || step_s > hole_s)) continue;
    runs.back().end = i;
    runs.push_back({i, t_s.size()});
  }
  return runs;
}

double mean(const std::vector<double>& values, const Rows& rows) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    if (!std::isfinite(values[i])) continue;
    sum += values[i];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

// About the mean of each run.
std::vector<double> centred(std::vector<double> values, const std::vector<Rows>& runs) {
  for (const Rows& rows : runs) {
    const double middle = mean(values, rows);
    for (std::size_t i = rows.begin; i < rows.end; ++i) values[i] -= middle;
  }
  return values;
}

struct Counts {
  std::vector<double> left, right, difference;
};

struct Path {
  std::vector<double> x, y;  // in counts, about the mean of each run
};

// By the counts, with a heading that turns as the wheels do and agrees with `heading` on average.
Path dead_reckoned(const Counts& counts, const std::vector<double>& heading_rad, double radians_per_count,
                   const std::vector<Rows>& runs) {
  Path path{std::vector<double>(counts.left.size()), std::vector<double>(counts.left.size())};
  for (const Rows& rows : runs) {
    const double offset_rad = mean(heading_rad, rows) - radians_per_count * mean(counts.difference, rows);
    double x = 0.0, y = 0.0;
    for (std::size_t i = rows.begin; i < rows.end; ++i) {
      const double forward =
          i == rows.begin
              ? 0.0
              : 0.5 * (counts.left[i] - counts.left[i - 1] + counts.right[i] - counts.right[i - 1]);
      const double theta = offset_rad + radians_per_count * counts.difference[i];
      if (std::isfinite(forward) && std::isfinite(theta)) {
        x += forward * std::cos(theta);
        y += forward * std::sin(theta);
      }
      path.x[i] = x;
      path.y[i] = y;
    }
  }
  return {centred(std::move(path.x), runs), centred(std::move(path.y), runs)};
}

struct Line {
  double explained = 0.0;
  Eigen::VectorXd factors;
};

// `values` as a linear function of the inputs and a constant.
Line regress(const std::vector<double>& values, const std::vector<const std::vector<double>*>& inputs) {
  const auto size = static_cast<Eigen::Index>(inputs.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size + 1, size + 1);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size + 1);
  double sum = 0.0, squares = 0.0, count = 0.0;
  Eigen::VectorXd row(size + 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (Eigen::Index k = 0; k < size; ++k) row[k] = (*inputs[static_cast<std::size_t>(k)])[i];
    row[size] = 1.0;
    if (!std::isfinite(values[i]) || !row.allFinite()) continue;
    normal += row * row.transpose();
    right += values[i] * row;
    sum += values[i];
    squares += values[i] * values[i];
    count += 1.0;
  }
  Line line;
  const double variance = squares - sum * sum / count;
  if (count < 10.0 || !(variance > 0.0)) return line;
  line.factors = solve_symmetric(normal, right);
  const double rest = squares - 2.0 * line.factors.dot(right) + line.factors.dot(normal * line.factors);
  line.explained = 1.0 - rest / variance;
  return line;
}

std::vector<double> unwrapped(const Channel& counts) {
  std::vector<double> values = counts.values;
  if (const auto bits = wrapped_bits(values)) unwrap(values, *bits);
  return values;
}

struct Heading {
  const Channel* channel = nullptr;  // of a quaternion, z
  std::vector<double> values;        // without wraps
  double per_count = 0.0;            // of the right wheel less the left one; negative: it turns against them
};

// A heading in a range of one turn, of radians or degrees, as one that goes on.
std::vector<double> without_wraps(std::vector<double> values) {
  const double size = range_of(values).size();
  const double turn = size > 7.0 ? 360.0 : 2.0 * std::acos(-1.0);
  if (!(size <= 1.01 * turn)) return values;
  double added = 0.0;
  std::optional<double> last;
  for (double& value : values) {
    if (!std::isfinite(value)) continue;
    const double step = last ? value + added - *last : 0.0;
    if (std::abs(step) > 0.5 * turn) added -= std::copysign(turn, step);
    value += added;
    last = value;
  }
  return values;
}

Heading find_heading(const std::vector<const Channel*>& unused,
                     const std::optional<QuaternionColumns>& quaternion, const Counts& counts,
                     const std::vector<Rows>& runs) {
  const std::vector<double> difference = centred(counts.difference, runs);
  if (quaternion) {
    std::vector<double> values = without_wraps(quaternion->heading_rad);
    const Line line = regress(centred(values, runs), {&difference});
    if (line.explained > pose_explained) return {quaternion->z, std::move(values), line.factors[0]};
  }
  for (const Channel* channel : unused) {
    std::vector<double> values = without_wraps(channel->values);
    const Line line = regress(centred(values, runs), {&difference});
    if (line.explained > pose_explained) return {channel, std::move(values), line.factors[0]};
  }
  return {};
}

// A wheel that counts backwards against its command turns the other way.
void count_as_commanded(const Stream& stream, const CommandMapping& command, const std::vector<double>& t_s,
                        const std::vector<Rows>& runs, Counts& counts) {
  if (command.is_of_body() || !command.second) return;
  for (const auto& [name, side] :
       {std::pair{&command.first, &counts.left}, {&*command.second, &counts.right}}) {
    const Channel* channel = stream.find(name->channel);
    if (channel == nullptr) return;
    std::vector<double> asked(t_s.size());
    for (std::size_t i = 1; i < t_s.size(); ++i) {
      const double step = channel->values[i] * (t_s[i] - t_s[i - 1]);
      asked[i] = asked[i - 1] + (std::isfinite(step) ? step : 0.0);
    }
    asked = centred(std::move(asked), runs);
    const Line line = regress(centred(*side, runs), {&asked});
    if (line.explained <= pose_explained || line.factors[0] > 0.0) continue;
    for (double& count : *side) count = -count;
  }
}

struct Places {
  std::array<const Channel*, 2> column{};
  bool mirrored = false;  // the first turned towards the second goes against the heading
};

std::optional<Places> find_places(const std::vector<const Channel*>& unused, const Channel* heading,
                                  const Path& path, const std::vector<Rows>& runs) {
  Places places;
  std::array<Line, 2> lines;
  std::size_t found = 0;
  for (const Channel* channel : unused) {
    const Line line =
        channel == heading ? Line{} : regress(centred(channel->values, runs), {&path.x, &path.y});
    if (line.explained <= pose_explained) continue;
    if (found == 2) return std::nullopt;
    places.column.at(found) = channel;
    lines.at(found++) = line;
  }
  if (found < 2) return std::nullopt;
  const auto& [x, y] = lines;
  places.mirrored = x.factors[0] * y.factors[1] < x.factors[1] * y.factors[0];
  return places;
}

std::string in_words(const QuaternionColumns& parts) {
  return "the quaternion of columns " + parts.x->name + ", " + parts.y->name + ", " + parts.z->name +
         " and " + parts.w->name + " (x, y, z, w)";
}

void exchange_sides(Mapping& mapping) {
  std::swap(mapping.wheels->left, *mapping.wheels->right);
  CommandMapping& command = *mapping.command;
  if (!command.is_of_body() && command.second) std::swap(command.first, *command.second);
}

}  // namespace

void find_pose_columns(const Stream& stream, const std::vector<double>& t_s,
                       const std::vector<const Channel*>& all_unused, bool sides_are_known, Mapping& mapping,
                       std::vector<std::string>& findings) {
  const WheelMapping& wheels = *mapping.wheels;
  if (wheels.kind == WheelKind::speed || !wheels.right || wheels.body_motion) return;
  const Channel* left = stream.find(wheels.left.channel);
  const Channel* right = stream.find(wheels.right->channel);
  if (left == nullptr || right == nullptr) return;
  const std::vector<Rows> runs = runs_of(t_s);
  Counts counts{unwrapped(*left), unwrapped(*right), {}};
  for (const auto& [reversed, side] :
       {std::pair{wheels.left_reversed, &counts.left}, {wheels.right_reversed, &counts.right}}) {
    if (!reversed) continue;
    for (double& count : *side) count = -count;
  }
  count_as_commanded(stream, *mapping.command, t_s, runs, counts);
  for (std::size_t i = 0; i < counts.left.size(); ++i)
    counts.difference.push_back(counts.right[i] - counts.left[i]);
  auto quaternion = find_quaternion(stream, all_unused);
  const PlacedColumns columns = placed_columns(all_unused, quaternion);
  const std::vector<const Channel*>& unused = columns.unused;
  const Heading heading = find_heading(unused, quaternion, counts, runs);
  if (heading.channel == nullptr) return;
  const bool of_quaternion = quaternion && quaternion->has(heading.channel);
  const std::string column = of_quaternion ? in_words(*quaternion) : "column " + heading.channel->name;
  // Degrees turn by more than a radian can for a count of the same wheels: both are tried.
  for (const double unit : {1.0, std::acos(-1.0) / 180.0}) {
    if (of_quaternion && unit != 1.0) break;
    std::vector<double> heading_rad = heading.values;
    for (double& value : heading_rad) value *= unit;
    const Path path = dead_reckoned(counts, heading_rad, unit * heading.per_count, runs);
    auto places = find_places(unused, heading.channel, path, runs);
    if (!places) continue;
    const bool against = heading.per_count < 0.0;
    const bool clockwise = against && places->mirrored;
    if (against && !clockwise && sides_are_known) {
      findings.push_back(column + (of_quaternion ? " has" : " is") +
                         " a heading that falls where the wheels turn left, so that the sides or the heading "
                         "are the wrong way round; the reference is left out");
      return;
    }
    if (clockwise)
      findings.push_back("headings are clockwise: " + column +
                         " falls where the wheels turn left, and the places turn left with them");
    if (against && !clockwise) {
      exchange_sides(mapping);
      findings.push_back("the right wheel stands first: columns " + places->column[0]->name + ", " +
                         places->column[1]->name + " and " + heading.channel->name +
                         " turn left with the first wheel; or they are of a frame whose y points right, and "
                         "left and right are exchanged in all results");
    }
    if (places->mirrored && !clockwise) {
      std::swap(places->column[0], places->column[1]);
      findings.push_back(
          "y stands before x: in the order of the columns the robot would turn against its heading");
    }
    ReferenceMapping reference;
    reference.clockwise = clockwise;
    reference.x = ChannelName{stream.name, places->column[0]->name};
    reference.y = ChannelName{stream.name, places->column[1]->name};
    if (of_quaternion) {
      reference.qx = ChannelName{stream.name, quaternion->x->name};
      reference.qy = ChannelName{stream.name, quaternion->y->name};
      reference.qz = ChannelName{stream.name, quaternion->z->name};
      reference.qw = ChannelName{stream.name, quaternion->w->name};
    } else {
      reference.theta = ChannelName{stream.name, heading.channel->name};
      if (unit != 1.0) reference.angle_unit = "deg";
    }
    mapping.reference = reference;
    findings.push_back("the reference is " +
                       (of_quaternion ? "x and y in columns " + places->column[0]->name + " and " +
                                            places->column[1]->name + " and " + column
                                      : "x, y and heading in columns " + places->column[0]->name + ", " +
                                            places->column[1]->name + " and " + heading.channel->name) +
                       ": they go as the counts do");
    return;
  }
}

}  // namespace wheelwright::import
