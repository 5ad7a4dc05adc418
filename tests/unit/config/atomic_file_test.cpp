#include "config/load/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;

TEST_CASE("A file is replaced whole, and nothing is left beside it") {
  const auto folder = test::temporary_folder() / "replaced";
  std::filesystem::create_directory(folder);
  CHECK_FALSE(config::write_file_atomically(folder / "model.yaml", "one"));
  CHECK_FALSE(config::write_file_atomically(folder / "model.yaml", "two"));
  std::ifstream file(folder / "model.yaml");
  CHECK(std::string(std::istreambuf_iterator<char>(file), {}) == "two");
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 1);
}

TEST_CASE("A device or a pipe is written into and stays what it is") {
  const auto folder = test::temporary_folder();
  const auto pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  REQUIRE(reader >= 0);
  CHECK_FALSE(config::write_file_atomically(pipe, "text"));
  std::array<char, 8> read{};
  CHECK(::read(reader, read.data(), read.size()) == 4);
  ::close(reader);
  CHECK(std::filesystem::is_fifo(pipe));
}
