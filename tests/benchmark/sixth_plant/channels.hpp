#pragma once

#include <string>

namespace plants::sixth {

// What a log has of the robot.
enum class Channels { ticks, ticks_and_poses, ticks_and_poses_each_second, poses };

// As the answers say it.
inline std::string name_of(Channels channels) {
  switch (channels) {
    case Channels::ticks:
      return "ticks";
    case Channels::ticks_and_poses:
      return "ticks+poses";
    case Channels::ticks_and_poses_each_second:
      return "ticks+poses_each_second";
    case Channels::poses:
      break;
  }
  return "poses";
}

inline bool has_ticks(Channels channels) {
  return channels != Channels::poses;
}

inline bool has_poses(Channels channels) {
  return channels != Channels::ticks;
}

}  // namespace plants::sixth
