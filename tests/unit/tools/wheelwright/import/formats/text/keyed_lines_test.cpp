// Lines that name what they hold, as programs write them to a serial monitor.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

using Names = std::vector<std::string>;

TEST_CASE("Lines with key letters make a stream for each key") {
  const import::Recording recording = read_text("M 1 2\nODOM 0.5 0.25 0.1\nM 3 4\nODOM 0.6 0.35 0.2\n");
  CHECK(values(stream(recording, "M"), "2") == Values{2.0, 4.0});
  CHECK(values(stream(recording, "ODOM"), "1") == Values{0.5, 0.6});
  CHECK(stream(recording, "ODOM").places == std::vector<std::size_t>{2, 4});
  CHECK_THAT(recording.format, ContainsSubstring("key"));
}

TEST_CASE("Names beside their numbers are channels") {
  CHECK(values("L:1 R:2\nL:3 R:4\n", "R") == Values{2.0, 4.0});
  CHECK(values("left=12, right=-13\nleft=14, right=-15\n", "right") == Values{-13.0, -15.0});
  CHECK(values("x1: 0.5 x2: 7\nx1: 0.6 x2: 8\n", "x2") == Values{7.0, 8.0});
}

TEST_CASE("A unit behind a number goes to its channel") {
  const import::Recording recording = read_text("v: 0.5 m/s, n: 3\nv: 0.6 m/s, n: 4\n");
  CHECK(unit(recording, "v") == "m/s");
  CHECK(names(recording.streams[0]) == Names{"v", "n"});
}

TEST_CASE("Rows of keys and commas are told from a table") {
  const import::Recording recording = read_text("E,1,2\nI,0.5,0.25,0.1\nE,3,4\nI,0.6,0.35,0.2\n");
  CHECK(values(stream(recording, "E"), "1") == Values{1.0, 3.0});
  CHECK(stream(recording, "I").channels.size() == 3);
}

TEST_CASE("A time before the key is a channel") {
  const import::Recording arrow = read_text("12:00:00.5 -> L:1 R:2\n12:00:00.6 -> L:3 R:4\n");
  CHECK(values(arrow.streams[0], "stamp")[0] == Approx(43200.5));
  CHECK(unit(arrow, "stamp") == "hms");
  const import::Recording number = read_text("0.5 M 1 2\n0.5 B 12.1\n0.6 M 3 4\n0.6 B 12.2\n");
  CHECK(values(stream(number, "M"), "stamp") == Values{0.5, 0.6});
  const import::Recording ros =
      read_text("[INFO] [1678.5] [driver]: L:1 R:2\n[INFO] [1678.6] [driver]: L:3 R:4\n");
  CHECK(values(stream(ros, "driver"), "stamp") == Values{1678.5, 1678.6});
}

TEST_CASE("Boot text and cut rows are left out and said") {
  const import::Recording recording =
      read_text("rst:0x1 (POWERON)\nready\nM 1 2\nM 3 4\nM 5\nM 7 8\n56 78\nM 9 10\n");
  CHECK(values(stream(recording, "M"), "1") == Values{1.0, 3.0, 7.0, 9.0});
  CHECK(has_remark(recording, "2 lines, the first is line 2: text without a word"));
  CHECK(has_remark(recording, "line 1: text, or a row that was cut"));
  CHECK(has_remark(recording, "('M 5')"));
}

TEST_CASE("A missing number keeps its place in the line") {
  const Values read = values("L:1 R:nan\nL:3 R:4\nL:nan R:6\n", "R");
  REQUIRE(read.size() == 3);
  CHECK(std::isnan(read[0]));
}

TEST_CASE("JSON lines give their numbers under flattened names") {
  const import::Recording recording = read_text(
      "{\"t\":0.5,\"p\":{\"x\":[1,2]},\"s\":\"a\"}\n{\"t\":0.6,\"p\":{\"x\":[3,null]},\"s\":\"b\"}\n{\"t\":0."
      "7,\"p\":\n");
  CHECK(names(recording.streams[0]) == Names{"t", "p.x[0]", "p.x[1]"});
  CHECK(values(recording.streams[0], "p.x[0]") == Values{1.0, 3.0});
  CHECK(has_remark(recording, "line 3: no object with numbers"));
}

TEST_CASE("Letters and numbers without anything between them are keys and their numbers") {
  const import::Recording recording = read_text("L12R13\nL14R-15\nL16R17\nL18R19\n");
  CHECK(values(stream(recording), "L") == Values{12.0, 14.0, 16.0, 18.0});
  CHECK(values(stream(recording), "R") == Values{13.0, -15.0, 17.0, 19.0});
  CHECK(values("T100L12E13\nT200L14E15\n", "E") == Values{13.0, 15.0});
  CHECK(values("V1.5e-3W2\nV1.5e-2W3\n", "V") == Values{1.5e-3, 1.5e-2});
  CHECK(values("M1S2 7\nM1S2 8\n", "M1S2") == Values{7.0, 8.0});
}
