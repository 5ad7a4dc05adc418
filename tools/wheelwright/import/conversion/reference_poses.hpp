// The poses of a reference as its file has them, in a right-handed frame.
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording/recording.hpp"

namespace wheelwright::import {

// Values of a stream, one for each of its rows.
struct StreamValues {
  const Stream* stream = nullptr;  // null where nothing is mapped
  std::vector<double> values;
};

struct ReferencePoses {
  StreamValues x;  // in the unit of the file; of degrees on the globe in metres east of the first fix
  StreamValues y;  // to the left of x, or north
  StreamValues heading_rad;  // counter-clockwise from x
  std::string remark;        // of poses that are lost and left out; empty where none is
};

// What one unit of x and y of ReferencePoses is in metres; 1 for pixels of unknown size.
double place_in_m(const ReferenceMapping& reference);

// By the columns of x and y, and of a heading or a quaternion: their frame and unit as the mapping states
// them, without the poses that the tracker lost (model/log/lost_poses.hpp). Fails with the name of a column
// that is not there, or there more than once.
tl::expected<ReferencePoses, ChannelName> reference_poses(std::span<const Recording> recordings,
                                                          const ReferenceMapping& reference);

}  // namespace wheelwright::import
