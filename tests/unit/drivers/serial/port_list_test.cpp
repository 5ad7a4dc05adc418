#include "drivers/serial/port_list.hpp"

#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using serial::PortPlaces;

namespace {

void touch(const std::filesystem::path& path, const std::string& text = "") {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

PortPlaces empty_places() {
  const auto folder = test::temporary_folder() / "ports";
  std::filesystem::remove_all(folder);
  for (const char* name : {"dev", "sys", "root"}) std::filesystem::create_directories(folder / name);
  return {folder / "dev", folder / "sys", folder / "root"};
}

}  // namespace

TEST_CASE("Ports are listed by their stable names, and without those that have no hardware") {
  const auto places = empty_places();
  CHECK(serial::serial_ports(places).empty());
  CHECK_THAT(serial::ports_that_are_there(places), ContainsSubstring("no serial port"));
  for (const char* name : {"ttyUSB0", "ttyACM1", "ttyS0", "ttyS1", "tty40", "null"}) touch(places.dev / name);
  touch(places.sys / "class/tty/ttyS0/type", "4\n");
  touch(places.sys / "class/tty/ttyS1/type", "0\n");
  std::filesystem::create_directories(places.dev / "serial/by-id");
  std::filesystem::create_symlink(places.dev / "ttyUSB0", places.dev / "serial/by-id/usb-FTDI");
  std::filesystem::create_symlink(places.dev / "ttyUSB9", places.dev / "serial/by-id/usb-gone");
  const auto ports = serial::serial_ports(places);
  REQUIRE(ports.size() == 3);
  CHECK(ports[0] == (places.dev / "serial/by-id/usb-FTDI").string());
  CHECK(ports[1] == (places.dev / "ttyACM1").string());
  CHECK(ports[2] == (places.dev / "ttyS0").string());
  CHECK_THAT(serial::ports_that_are_there(places),
             ContainsSubstring(ports[0] + ", " + ports[1] + ", " + ports[2]));
}

TEST_CASE("Where brltty is installed, it is named as a program that takes adapters away") {
  const auto places = empty_places();
  CHECK_THAT(serial::ports_that_are_there(places), !ContainsSubstring("brltty"));
  touch(places.root / "usr/bin/brltty");
  CHECK_THAT(serial::ports_that_are_there(places), ContainsSubstring("apt-get remove brltty"));
}
