// What stands in a cell, or before the words of a line.
#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

TEST_CASE("A count below zero that was written without a sign is below zero") {
  const Values read = values("t,n\n1,18446744073709551115\n2,18446744073709551615\n3,4\n", "n");
  CHECK(read == Values{-501.0, -1.0, 4.0});
}

TEST_CASE("Errors of a spreadsheet are missing numbers, and names above them stay names") {
  const Values read = values("t,n,ratio\n0,#REF!,#DIV/0!\n1,#VALUE!,#DIV/0!\n2,7,0.5\n3,8,0.5\n", "n");
  CHECK(std::isnan(read[0]));
  CHECK(std::isnan(read[1]));
  CHECK(read[3] == 8.0);
}

TEST_CASE("A unit behind each number is that of the column") {
  const import::Recording recording = read_text("Time,n\n0 sec,1\n0.05 sec,2\n0.1 sec,3\n0.15 sec,4\n");
  CHECK(values(recording.streams[0], "Time") == Values{0.0, 0.05, 0.1, 0.15});
  CHECK(unit(recording, "Time") == "sec");
}

TEST_CASE("A matrix of a script keeps its last column, and takes its names from the comment above") {
  const import::Recording recording =
      read_text("% t left right\ndata = [\n  0.0 1 2;\n  0.1 3 4;\n  0.2 5 6;\n  0.3 7 8;\n];\n");
  CHECK(values(recording.streams[0], "right") == Values{2.0, 4.0, 6.0, 8.0});
}

TEST_CASE("Lines of a journal have the time of day, past midnight and without the program's number") {
  const import::Recording recording = read_text(
      "May 03 23:59:59.500 robot drive[812]: L=1 R=2\nMay 04 00:00:00.500 robot drive[812]: L=3 R=4\n"
      "May 04 00:00:01.500 robot drive[812]: L=5 R=6\n");
  const Values stamps = values(recording.streams[0], "stamp");
  CHECK(stamps[1] - stamps[0] == Approx(1.0));
  CHECK(stamps[2] - stamps[1] == Approx(1.0));
  CHECK(values(recording.streams[0], "R") == Values{2.0, 4.0, 6.0});
  CHECK(recording.streams[0].channels.size() == 3);
}

TEST_CASE("Two labels that end in the same word are two names") {
  const import::Recording recording =
      read_text("Left count: 1  Right count: 2\nLeft count: 3  Right count: 4\n");
  CHECK(values(recording.streams[0], "Left count") == Values{1.0, 3.0});
  CHECK(values(recording.streams[0], "Right count") == Values{2.0, 4.0});
}

TEST_CASE("Colours of a terminal are no part of a line") {
  const import::Recording recording =
      read_text("\x1b[0;32mI (12) L: 1 R: 2\x1b[0m\n\x1b[0;32mI (22) L: 3 R: 4\x1b[0m\n");
  CHECK(values(recording.streams[0], "R") == Values{2.0, 4.0});
}

TEST_CASE("In letters and their numbers an E is the next letter, with a minus behind it as well") {
  const import::Recording recording = read_text("T12L100R90E-12F3\nT22L100R90E-13F4\nT32L100R91E14F5\n");
  CHECK(values(recording.streams[0], "R") == Values{90.0, 90.0, 91.0});
  CHECK(values(recording.streams[0], "E") == Values{-12.0, -13.0, 14.0});
}
