#include "drivers/serial/port_list.hpp"

#include <algorithm>
#include <fstream>

namespace wheelwright::serial {
namespace {

namespace fs = std::filesystem;

bool starts_with_any(const std::string& name, std::initializer_list<const char*> prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const char* prefix) { return name.starts_with(prefix); });
}

// The kernel makes some /dev/ttyS* whether there is hardware or not; type 0 is none.
bool has_hardware(const fs::path& sys, const std::string& name) {
  if (!name.starts_with("ttyS")) return true;
  std::ifstream file(sys / "class/tty" / name / "type");
  int type = 0;
  return (file >> type) && type != 0;
}

}  // namespace

std::vector<std::string> serial_ports(const PortPlaces& places) {
  std::vector<std::string> ports;
  std::vector<std::string> named;  // devices that have a stable name
  std::error_code error;
  for (fs::directory_iterator at(places.dev / "serial/by-id", error), end; !error && at != end;
       at.increment(error)) {
    std::error_code dangling;
    const fs::path device = fs::canonical(at->path(), dangling);
    if (dangling) continue;
    named.push_back(device.filename().string());
    ports.push_back(at->path().string());
  }
  error.clear();
  for (fs::directory_iterator at(places.dev, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!starts_with_any(name, {"ttyUSB", "ttyACM", "ttyAMA", "ttyS"})) continue;
    if (std::find(named.begin(), named.end(), name) != named.end() || !has_hardware(places.sys, name))
      continue;
    ports.push_back(at->path().string());
  }
  std::sort(ports.begin(), ports.end());
  return ports;
}

bool brltty_is_installed(const PortPlaces& places) {
  std::error_code ignored;
  for (const char* const program : {"usr/bin/brltty", "bin/brltty", "sbin/brltty", "usr/sbin/brltty"}) {
    if (fs::exists(places.root / program, ignored)) return true;
  }
  return false;
}

std::string ports_that_are_there(const PortPlaces& places) {
  constexpr std::size_t max_ports = 8;
  const auto ports = serial_ports(places);
  std::string text = ports.empty() ? "this machine has no serial port; is the adapter plugged in?"
                                   : "the ports of this machine are ";
  for (std::size_t i = 0; i < std::min(ports.size(), max_ports); ++i) text += (i == 0 ? "" : ", ") + ports[i];
  if (ports.size() > max_ports) text += " and " + std::to_string(ports.size() - max_ports) + " more";
  if (brltty_is_installed(places))
    text +=
        "; brltty is installed, and takes CH340 adapters: remove it (apt-get remove brltty) and plug the "
        "adapter in again";
  return text;
}

}  // namespace wheelwright::serial
