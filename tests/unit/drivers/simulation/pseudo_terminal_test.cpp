#include "drivers/simulation/pseudo_terminal.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright::simulation;

namespace {

// A program that has the terminal open.
class Client {
 public:
  explicit Client(const std::string& path)
      : descriptor_(open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {}
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { close(descriptor_); }

  std::string read() const {
    std::array<char, 256> bytes{};
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    return count > 0 ? std::string(bytes.data(), static_cast<std::size_t>(count)) : std::string();
  }
  bool write(const std::string& text) const {
    return ::write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  }
  void set_baud(speed_t speed) const {
    termios settings{};
    tcgetattr(descriptor_, &settings);
    cfsetspeed(&settings, speed);
    tcsetattr(descriptor_, TCSANOW, &settings);
  }

 private:
  int descriptor_;
};

void say(PseudoTerminal& terminal, const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  terminal.write(bytes);
}

}  // namespace

TEST_CASE("Bytes pass the terminal unchanged in both directions") {
  PseudoTerminal terminal;
  const Client client(terminal.path());
  say(terminal, "\r\n\x03\x11\x13\xff");
  CHECK(client.read() == "\r\n\x03\x11\x13\xff");
  REQUIRE(client.write("\x04\r\x1a"));
  std::array<std::uint8_t, 16> bytes{};
  CHECK(terminal.read(bytes) == 3);
  CHECK(bytes[1] == '\r');
}

TEST_CASE("Clients may come and go, and do not find what was sent before they came") {
  PseudoTerminal terminal;
  say(terminal, "nobody");
  {
    const Client first(terminal.path());
    say(terminal, "one");
    CHECK(first.read() == "one");
    say(terminal, "unread");
  }
  say(terminal, "nobody again");
  const Client second(terminal.path());
  CHECK(second.read().empty());
  say(terminal, "two");
  CHECK(second.read() == "two");
}

TEST_CASE("The terminal knows the speed that its client has set") {
  PseudoTerminal terminal;
  CHECK_FALSE(terminal.client_baud().has_value());
  const Client client(terminal.path());
  CHECK(terminal.client_baud() == 115200);
  client.set_baud(B19200);
  CHECK(terminal.client_baud() == 19200);
}

TEST_CASE("A link to a terminal that another process holds is left to it, and taken over once that is gone") {
  const auto link = wheelwright::test::temporary_folder() / "wheelwright_held_link_test";
  std::filesystem::remove(link);
  std::array<int, 2> ready{};
  std::array<int, 2> end{};
  REQUIRE(pipe(ready.data()) == 0);
  REQUIRE(pipe(end.data()) == 0);
  const pid_t other = fork();
  if (other == 0) {
    close(end[1]);
    const PseudoTerminal held;
    std::filesystem::create_symlink(held.path(), link);
    char byte = 0;
    const bool told = write(ready[1], &byte, 1) == 1 && read(end[0], &byte, 1) == 1;
    _exit(told ? 0 : 1);  // as if killed: the link stays behind
  }
  char byte = 0;
  REQUIRE(read(ready[0], &byte, 1) == 1);
  const auto target = std::filesystem::read_symlink(link);
  const std::string expected =
      "leads to " + target.string() + ", which process " + std::to_string(other) + " (";
  CHECK_THROWS_WITH(TerminalLink(link, "/dev/null"), ContainsSubstring(expected));
  CHECK(std::filesystem::read_symlink(link) == target);
  CHECK(write(end[1], &byte, 1) == 1);
  CHECK(waitpid(other, nullptr, 0) == other);
  CHECK_NOTHROW(TerminalLink(link, "/dev/null"));
  CHECK_FALSE(std::filesystem::is_symlink(link));
  for (const int descriptor : {ready[0], ready[1], end[0], end[1]}) close(descriptor);
}

TEST_CASE("A link to a terminal of the same process may be pointed elsewhere, one to a real device may not") {
  const auto link = wheelwright::test::temporary_folder() / "wheelwright_own_link_test";
  std::filesystem::remove(link);
  const PseudoTerminal own;
  std::filesystem::create_symlink(own.path(), link);
  CHECK_NOTHROW(TerminalLink(link, "/dev/null"));
  std::filesystem::create_symlink("/dev/null", link);
  CHECK_THROWS_WITH(TerminalLink(link, own.path()), ContainsSubstring("leads to /dev/null, which is there"));
  std::filesystem::remove(link);
}

TEST_CASE("A link points to the terminal, replaces one that a killed robot left, and goes away with it") {
  const auto link = wheelwright::test::temporary_folder() / "wheelwright_link_test";
  std::filesystem::remove(link);
  std::filesystem::create_symlink("/dev/pts/4711", link);
  {
    const TerminalLink made(link, "/dev/null");
    CHECK(std::filesystem::read_symlink(link) == "/dev/null");
  }
  CHECK_FALSE(std::filesystem::is_symlink(link));
  std::filesystem::create_symlink("/not/there/yet", link);
  CHECK_THROWS_WITH(TerminalLink(link, "/dev/null"), ContainsSubstring("is a link to /not/there/yet"));
  CHECK(std::filesystem::is_symlink(link));
  std::filesystem::remove(link);
  std::ofstream(link) << "precious";
  CHECK_THROWS_WITH(TerminalLink(link, "/dev/null"), ContainsSubstring("is in the way"));
  std::filesystem::remove(link);
}
