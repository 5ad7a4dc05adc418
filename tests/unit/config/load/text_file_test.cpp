#include "config/load/text_file.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using config::FileKind;
using config::read_text;

namespace {

constexpr FileKind small_file{"a small file", 1U << 20U};

std::string refusal_of(const std::filesystem::path& path) {
  const auto text = read_text(path, small_file);
  return text ? "no refusal" : text.error();
}

// The ends of a pipe as a shell makes one for <(command).
struct Pipe {
  Pipe() { REQUIRE(::pipe(ends.data()) == 0); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends[0]);
    if (ends[1] >= 0) ::close(ends[1]);
  }
  void write_and_close(const std::string& text) {
    REQUIRE(::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    ends[1] = -1;
  }
  std::string path() const { return "/dev/fd/" + std::to_string(ends[0]); }

  std::array<int, 2> ends{};
};

}  // namespace

TEST_CASE("A file is read whole, and so is one in /proc that says that it is empty") {
  const test::TemporaryFolder folder("text_file");
  const std::string text("a\0b\n", 4);
  std::ofstream(folder.path() / "file", std::ios::binary) << text;
  CHECK(read_text(folder.path() / "file", small_file) == text);
  CHECK_THAT(read_text("/proc/self/status", small_file).value(), ContainsSubstring("Name:"));
}

TEST_CASE("A read error is an error and no short text") {
  CHECK(refusal_of("/proc/self/mem") ==
        "/proc/self/mem: cannot be read to its end: Input/output error after 0 bytes");
}

TEST_CASE("A file that is larger than its kind may be is refused by its name and the limit") {
  const test::TemporaryFolder folder("text_file");
  const auto file = folder.path() / "large";
  std::ofstream(file) << "x";
  std::filesystem::resize_file(file, 1U << 20U);
  CHECK(read_text(file, small_file).has_value());
  std::filesystem::resize_file(file, (1U << 20U) + 1);
  CHECK_THAT(refusal_of(file),
             ContainsSubstring(file.string() + ": is of 1.0 MiB, more than the 1 MiB that a "
                                               "small file may have"));
}

TEST_CASE("What is no file is refused by what it is, without being opened") {
  const test::TemporaryFolder folder("text_file");
  const auto pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const auto socket = folder.path() / "socket";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  socket.string().copy(address.sun_path, sizeof(address.sun_path) - 1);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  REQUIRE(::bind(descriptor, static_cast<const sockaddr*>(static_cast<const void*>(&address)),
                 sizeof(address)) == 0);

  CHECK_THAT(refusal_of("/dev/zero"), ContainsSubstring("/dev/zero: is a device"));
  CHECK_THAT(refusal_of(folder.path()), ContainsSubstring("is a folder"));
  CHECK_THAT(refusal_of(pipe), ContainsSubstring("is a named pipe"));
  CHECK_THAT(refusal_of(socket), ContainsSubstring("is a socket"));
  CHECK_THAT(refusal_of(folder.path() / "none"), ContainsSubstring("does the file exist?"));
  CHECK_THAT(refusal_of(folder.path() / std::string(300, 'n')), ContainsSubstring("File name too long"));
  ::close(descriptor);
}

TEST_CASE("A pipe that a shell made is read to its end, and refused once it has been read") {
  Pipe pipe;
  pipe.write_and_close("t,x\n");
  CHECK(read_text(pipe.path(), small_file) == "t,x\n");
  CHECK_THAT(refusal_of(pipe.path()), ContainsSubstring("is a pipe that holds nothing"));
}

TEST_CASE("A pipe is read no further than its kind of file may be long") {
  Pipe pipe;
  pipe.write_and_close(std::string(2000, 'x'));
  const auto text = read_text(pipe.path(), FileKind{"a tiny file", 1000});
  REQUIRE_FALSE(text.has_value());
  CHECK_THAT(text.error(), ContainsSubstring("is longer than"));
}
