// A robot with imperfections that were picked by chance, as the sealed file of the circle holds it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace wheelwright::tools {

// One imperfection, in physical terms and in those of the library.
struct Imperfection {
  std::string what;                  // with its size
  std::vector<std::string> effects;  // of the library: those under which it is rightly named
};

struct HiddenRobot {
  std::vector<Imperfection> imperfections;
  std::string robot_yaml;  // for roomba-sim; names its room relative to itself
  std::string room_yaml;
};

// All that can be hidden, and `nothing`.
std::vector<std::string> imperfection_names();

// The imperfections of these names, or where there are none, one to three that chance picks, on top of the
// robot file `base`. Sizes come from the seed; the same seed picks the same. With a slope comes friction,
// which holds the robot on it.
HiddenRobot pick_hidden_robot(std::uint64_t seed, const std::vector<std::string>& names,
                              const std::filesystem::path& base, const std::string& room_file);

}  // namespace wheelwright::tools
