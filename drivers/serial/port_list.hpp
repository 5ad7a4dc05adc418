// The serial ports of this machine, for a message about one that is not there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wheelwright::serial {

// Where to look; tests look elsewhere.
struct PortPlaces {
  std::filesystem::path dev = "/dev";
  std::filesystem::path sys = "/sys";
  std::filesystem::path root = "/";
};

// By their stable names (/dev/serial/by-id) where they have one; without the /dev/ttyS* that have no
// hardware.
std::vector<std::string> serial_ports(const PortPlaces& places = {});

// brltty drives braille displays, and takes adapters with a CH340 chip for one.
bool brltty_is_installed(const PortPlaces& places = {});

// "there are /dev/ttyUSB0 and /dev/ttyS0", or what to do where there is none.
std::string ports_that_are_there(const PortPlaces& places = {});

}  // namespace wheelwright::serial
