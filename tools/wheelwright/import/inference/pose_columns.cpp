#include "tools/wheelwright/import/inference/pose_columns.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "tools/wheelwright/import/conversion/counts.hpp"

namespace wheelwright::import {
namespace {

constexpr double sure_explained = 0.9;

struct Path {
  std::vector<double> x, y, theta;  // in counts, and radians as far as the base is known
};

// Odometry at the base that makes `heading` turn as the wheels do; in counts.
Path dead_reckoned(const std::vector<double>& left, const std::vector<double>& right,
                   double radians_per_count) {
  Path path;
  double x = 0.0, y = 0.0, theta = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double dl = i == 0 ? 0.0 : left[i] - left[i - 1];
    const double dr = i == 0 ? 0.0 : right[i] - right[i - 1];
    if (std::isfinite(dl) && std::isfinite(dr)) {
      const double middle = theta + 0.5 * radians_per_count * (dr - dl);
      x += 0.5 * (dl + dr) * std::cos(middle);
      y += 0.5 * (dl + dr) * std::sin(middle);
      theta += radians_per_count * (dr - dl);
    }
    path.x.push_back(x);
    path.y.push_back(y);
    path.theta.push_back(theta);
  }
  return path;
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
  line.factors = normal.ldlt().solve(right);
  const double rest = squares - 2.0 * line.factors.dot(right) + line.factors.dot(normal * line.factors);
  line.explained = 1.0 - rest / variance;
  return line;
}

}  // namespace

void find_pose_columns(const Stream& stream, const std::vector<const Channel*>& unused, Mapping& mapping,
                       std::vector<std::string>& findings) {
  const WheelMapping& wheels = *mapping.wheels;
  if (wheels.kind != WheelKind::counts || !wheels.right || wheels.body_motion) return;
  const Channel* left = stream.find(wheels.left.channel);
  const Channel* right = stream.find(wheels.right->channel);
  if (left == nullptr || right == nullptr) return;
  std::vector<double> counts[2] = {left->values, right->values};
  std::vector<double> difference;
  for (auto& side : counts) {
    if (const auto bits = wrapped_bits(side)) unwrap(side, *bits);
  }
  for (std::size_t i = 0; i < counts[0].size(); ++i) difference.push_back(counts[1][i] - counts[0][i]);

  const Channel* heading = nullptr;
  double radians_per_count = 0.0;
  for (const Channel* channel : unused) {
    std::vector<double> values = channel->values;
    const Line line = regress(values, {&difference});
    if (line.explained > sure_explained && line.factors[0] > 0.0 && heading == nullptr) {
      heading = channel;
      radians_per_count = line.factors[0];
    }
  }
  if (heading == nullptr) return;
  // Degrees turn by more than a radian can for a count of the same wheels: both are tried.
  for (const double unit : {1.0, std::acos(-1.0) / 180.0}) {
    const Path path = dead_reckoned(counts[0], counts[1], unit * radians_per_count);
    std::vector<const Channel*> places;
    for (const Channel* channel : unused) {
      if (channel != heading && regress(channel->values, {&path.x, &path.y}).explained > sure_explained)
        places.push_back(channel);
    }
    if (places.size() != 2) continue;
    ReferenceMapping reference;
    reference.x = ChannelName{stream.name, places[0]->name};
    reference.y = ChannelName{stream.name, places[1]->name};
    reference.theta = ChannelName{stream.name, heading->name};
    if (unit != 1.0) reference.angle_unit = "deg";
    mapping.reference = reference;
    findings.push_back("the reference is x, y and heading in columns " + places[0]->name + ", " +
                       places[1]->name + " and " + heading->name + ": they go as the counts do");
    return;
  }
}

}  // namespace wheelwright::import
