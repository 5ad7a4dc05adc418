#include "tools/wheelwright/common/printable_stream.hpp"

#include <sstream>

#include "tests/support/catch.hpp"

using wheelwright::tools::PrintableStream;
using wheelwright::tools::put_escape_sequence;

TEST_CASE("What a command prints reaches its target with control characters escaped, in lines") {
  std::ostringstream target;
  PrintableStream out(target);
  out << "run \x1b[2J" << 1 << '\n' << "rest";
  CHECK(target.str() == "run \\x1b[2J1\n");
  out.flush();
  CHECK(target.str() == "run \\x1b[2J1\nrest");
}

TEST_CASE("A letter that is written byte by byte stays a letter") {
  std::ostringstream target;
  {
    PrintableStream out(target);
    out << '\xc3' << '\xbc';
  }
  CHECK(target.str() == "ü");
}

TEST_CASE("The program's own colours stay, in their place") {
  std::ostringstream target;
  {
    PrintableStream out(target);
    out << "a\x1b ";
    put_escape_sequence(out, "\033[32m");
    out << "ok\n";
  }
  CHECK(target.str() == "a\\x1b \033[32mok\n");
}

TEST_CASE("A target that takes nothing more is noticed") {
  std::ostringstream target;
  PrintableStream out(target);
  target.setstate(std::ios::badbit);
  out << "lost\n" << std::flush;
  CHECK_FALSE(out);
}
