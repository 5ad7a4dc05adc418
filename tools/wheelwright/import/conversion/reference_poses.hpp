// The poses of a reference as its file has them, in a right-handed frame.
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "tools/wheelwright/import/mapping/mapping.hpp"
#include "tools/wheelwright/import/recording.hpp"

namespace wheelwright::import {

// Values of a stream, one for each of its rows.
struct StreamValues {
  const Stream* stream = nullptr;  // null where nothing is mapped
  std::vector<double> values;
};

struct ReferencePoses {
  StreamValues x;            // in the unit of the file
  StreamValues y;            // to the left of x
  StreamValues heading_rad;  // counter-clockwise from x
  std::string remark;        // of poses that are lost and left out; empty where none is
};

// By the columns of x and y, and of a heading or a quaternion: their frame and unit as the mapping states
// them, without the poses that the tracker lost (model/log/lost_poses.hpp). Fails with the name of a column
// that is not there, or there more than once.
tl::expected<ReferencePoses, ChannelName> reference_poses(std::span<const Recording> recordings,
                                                          const ReferenceMapping& reference);

}  // namespace wheelwright::import
