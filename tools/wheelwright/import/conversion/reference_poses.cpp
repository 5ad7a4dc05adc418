#include "tools/wheelwright/import/conversion/reference_poses.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "model/log/lost_poses.hpp"
#include "tools/wheelwright/import/conversion/drive_columns.hpp"
#include "tools/wheelwright/import/conversion/local_metres.hpp"
#include "tools/wheelwright/import/mapping/units.hpp"

namespace wheelwright::import {
namespace {

class PoseReader {
 public:
  PoseReader(std::span<const Recording> recordings, const ReferenceMapping& reference)
      : recordings_(recordings), reference_(reference) {}

  tl::expected<ReferencePoses, ChannelName> read() {
    poses_.x = column(reference_.x);
    poses_.y = column(reference_.y);
    if (reference_.theta) read_heading();
    if (reference_.qw && reference_.qz) read_quaternion();
    if (missing_) return tl::unexpected(*missing_);
    leave_out_lost();
    if (reference_.unit == geographic_unit) to_local_metres();
    put_frame_right();
    return std::move(poses_);
  }

 private:
  StreamValues column(const std::optional<ChannelName>& wanted) {
    if (!wanted) return {};
    const FoundChannel found = find_channel(recordings_, *wanted);
    if (found.channel == nullptr) {
      missing_ = *wanted;
      return {};
    }
    return {found.stream, found.channel->values};
  }

  void read_heading() {
    poses_.heading_rad = column(reference_.theta);
    const double unit_rad = in_si(angle_units(), reference_.angle_unit);
    for (double& theta : poses_.heading_rad.values) theta *= unit_rad;
    if (!reference_.roll) return;
    const StreamValues roll = column(reference_.roll);
    if (roll.stream != poses_.heading_rad.stream) return;
    for (std::size_t i = 0; i < roll.values.size(); ++i) {
      double& theta = poses_.heading_rad.values[i];
      if (std::cos(unit_rad * roll.values[i]) < 0.0) theta = std::numbers::pi - theta;
    }
  }

  void read_quaternion() {
    const StreamValues x = column(reference_.qx);
    const StreamValues y = column(reference_.qy);
    const StreamValues z = column(reference_.qz);
    const StreamValues w = column(reference_.qw);
    if (w.stream == nullptr || z.stream != w.stream) return;
    poses_.heading_rad = {w.stream, {}};
    for (std::size_t i = 0; i < w.values.size(); ++i) {
      const double qx = x.values.empty() ? 0.0 : x.values[i];
      const double qy = y.values.empty() ? 0.0 : y.values[i];
      const double qz = z.values[i];
      const double qw = w.values[i];
      poses_.heading_rad.values.push_back(
          std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz));
    }
  }

  void put_frame_right() {
    // On the globe a clockwise heading is that of a compass, from north.
    const bool is_compass = reference_.clockwise && reference_.unit == geographic_unit;
    const double offset_rad = std::numbers::pi / 180.0 * reference_.heading_offset_deg.value_or(0.0) +
                              (is_compass ? 0.5 * std::numbers::pi : 0.0);
    for (double& theta : poses_.heading_rad.values)
      theta = (reference_.clockwise ? -theta : theta) + offset_rad;
    if (!reference_.y_points_right) return;
    for (double& y : poses_.y.values) y = -y;
  }

  void leave_out_lost() {
    if (poses_.x.stream == nullptr || poses_.x.stream != poses_.y.stream) return;
    const auto lost = lost_stretches(poses_.x.values, poses_.y.values);
    if (lost.empty()) return;
    poses_.remark = in_words(lost, poses_.x.values);
    blank(lost, poses_.x.values);
    blank(lost, poses_.y.values);
    if (poses_.heading_rad.stream == poses_.x.stream) blank(lost, poses_.heading_rad.values);
  }

  // About the first fix, on the ellipsoid of WGS 84. A receiver without a fix says 0 for both.
  void to_local_metres() {
    Column& east = poses_.x.values;
    Column& north = poses_.y.values;
    if (poses_.x.stream != poses_.y.stream) return;
    const LocalMetres metres = local_metres(east, north);
    east = metres.east;
    north = metres.north;
    if (metres.without_fix > 0)
      poses_.remark += (poses_.remark.empty() ? "" : ", and ") + std::to_string(metres.without_fix) +
                       " rows hold latitude and longitude 0: no fix, left out";
  }

  std::span<const Recording> recordings_;
  const ReferenceMapping& reference_;
  ReferencePoses poses_;
  std::optional<ChannelName> missing_;
};

}  // namespace

double place_in_m(const ReferenceMapping& reference) {
  if (reference.unit == pixel_unit) return reference.metres_per_pixel.value_or(1.0);
  return reference.unit == geographic_unit ? 1.0 : in_si(distance_units(), reference.unit);
}

tl::expected<ReferencePoses, ChannelName> reference_poses(std::span<const Recording> recordings,
                                                          const ReferenceMapping& reference) {
  return PoseReader(recordings, reference).read();
}

}  // namespace wheelwright::import
