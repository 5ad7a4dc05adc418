// The same table in the dialects in which programs write it.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

const Values times{0.0, 0.05, 0.1};
const Values speeds{-0.25, 1.5, 3e-5};

void check_table(const std::string& text, const std::string& format) {
  const import::Recording recording = read_text(text);
  REQUIRE(recording.streams.size() == 1);
  CHECK(values(recording.streams[0], "t") == times);
  CHECK(values(recording.streams[0], "v") == speeds);
  CHECK_THAT(recording.format, ContainsSubstring(format));
}

std::string as_utf16(const std::string& text, bool is_big_endian, bool has_mark) {
  std::string bytes = !has_mark ? "" : is_big_endian ? "\xfe\xff" : "\xff\xfe";
  for (const char character : text) {
    if (is_big_endian) bytes += '\0';
    bytes += character;
    if (!is_big_endian) bytes += '\0';
  }
  return bytes;
}

const std::string plain = "t,v\n0.000,-0.25\n0.050,1.5\n0.100,3e-5\n";

}  // namespace

TEST_CASE("A table is read whichever sign parts its fields") {
  check_table(plain, "',' between fields, header row");
  check_table("t;v\n0.000;-0.25\n0.050;1.5\n0.100;3e-5\n", "';' between fields");
  check_table("t\tv\n0.000\t-0.25\n0.050\t1.5\n0.100\t3e-5\n", "tabulators between fields");
  check_table("t v\n0.000  -0.25\n0.050   1.5\n  0.100 3e-5\n", "blanks between fields");
  check_table("t | v\n0.000 | -0.25\n0.050 | 1.5\n0.100 | 3e-5\n", "'|' between fields");
  check_table("| t | v |\n|---|---|\n| 0.000 | -0.25 |\n| 0.050 | 1.5 |\n| 0.100 | 3e-5 |\n",
              "'|' between fields");
}

TEST_CASE("A decimal comma is found beside every separator but the comma") {
  check_table("t;v\n0,000;-0,25\n0,050;1,5\n0,100;3e-5\n", "decimal comma");
  check_table("t\tv\n0,000\t-0,25\n0,050\t1,5\n0,100\t3e-5\n", "decimal comma");
  check_table("t v\n0,000 -0,25\n0,050 1,5\n0,100 3e-5\n", "decimal comma");
}

TEST_CASE("A line sep= names the separator, as Excel has it") {
  check_table("sep=;\r\nt;v\r\n0,000;-0,25\r\n0,050;1,5\r\n0,100;3e-5\r\n",
              "';' between fields, decimal comma");
}

TEST_CASE("Lines end at LF, CR and CR LF") {
  check_table("t,v\r\n0.000,-0.25\r\n0.050,1.5\r\n0.100,3e-5\r\n", "CSV");
  check_table("t,v\r0.000,-0.25\r0.050,1.5\r0.100,3e-5\r", "CSV");
  CHECK(read_text("t,v\r0,1\r1,2\r").streams[0].places == std::vector<std::size_t>{2, 3});
}

TEST_CASE("UTF-8 and UTF-16 are read with and without a byte order mark") {
  check_table("\xef\xbb\xbf" + plain, "UTF-8 with a byte order mark");
  check_table(as_utf16(plain, false, true), "UTF-16 LE");
  check_table(as_utf16(plain, true, true), "UTF-16 BE");
  check_table(as_utf16(plain, false, false), "UTF-16 LE");
  check_table(as_utf16(plain, true, false), "UTF-16 BE");
}

TEST_CASE("Names in Latin-1 become UTF-8") {
  const import::Recording recording = read_text(
      "Zeit;Gr\xf6\xdf"
      "e [\xb0]\n0;1\n1;2\n");
  CHECK(recording.streams[0].channels[1].name ==
        "Gr\xc3\xb6\xc3\x9f"
        "e");
  CHECK(recording.streams[0].channels[1].unit == "\xc2\xb0");
  CHECK_THAT(recording.format, ContainsSubstring("Latin-1"));
}

TEST_CASE("Quotes may stand around names, cells and whole rows") {
  check_table("\"t\",\"v\"\n0.000,-0.25\n0.050,1.5\n0.100,3e-5\n", "CSV");
  check_table("\"t\",\"v\"\n\"0.000\",\"-0.25\"\n\"0.050\",\"1.5\"\n\"0.100\",\"3e-5\"\n", "CSV");
  check_table("\"t, v\"\n\"0.000, -0.25\"\n\"0.050, 1.5\"\n\"0.100, 3e-5\"\n", "whole rows in quotes");
  CHECK(names(read_text("\"a \"\"b\"\", c\",d\n1,2\n2,3\n").streams[0]) ==
        std::vector<std::string>{"a \"b\", c", "d"});
}

TEST_CASE("A separator at the end of each row makes no column") {
  check_table("t,v,\n0.000,-0.25,\n0.050,1.5,\n0.100,3e-5,\n", "CSV");
  check_table("t,v\n0.000,-0.25,\n0.050,1.5,\n0.100,3e-5,\n", "CSV");
}

TEST_CASE("An empty last field in some rows is a missing value") {
  const Values last = values("t,v\n0,1\n1,\n2,\n3,\n4,5\n", "v");
  REQUIRE(last.size() == 5);
  CHECK(std::isnan(last[1]));
  CHECK(last[4] == 5.0);
}

TEST_CASE("Rows of two whole numbers are two columns, with a remark") {
  const import::Recording recording = read_text("12,7\n13,8\n14,11\n");
  CHECK(recording.streams[0].channels.size() == 2);
  CHECK(has_remark(recording, "could also be a decimal sign"));
}

TEST_CASE("Rows such as 1,05 under one name are numbers with a decimal comma") {
  const import::Recording recording = read_text("speed\n1,5\n2,25\n3,05\n4,0\n");
  CHECK(values(recording.streams[0], "speed") == Values{1.5, 2.25, 3.05, 4.0});
  CHECK(has_remark(recording, "decimal sign"));
}

TEST_CASE("A comma that parts fields and decimals is refused with the mend") {
  CHECK_THAT(refusal_of("t,v\n0,05,1,20\n0,10,1,25\n0,15,1,30\n"),
             ContainsSubstring("write ';' between the fields"));
}

TEST_CASE("Blanks and tabulators in turn part the columns of MRCLAM files") {
  const import::Recording recording = read_text(
      "# MRCLAM\n# Time [s]    forward velocity [m/s]    angular velocity[rad/s]\n"
      "1248444187.156 \t  0.086 \t -0.398\n1248444187.186 \t  0.086 \t -0.398\n");
  CHECK(names(recording.streams[0]) ==
        std::vector<std::string>{"Time", "forward velocity", "angular velocity"});
  CHECK(unit(recording, "angular velocity") == "rad/s");
  CHECK(recording.metadata.front().second == "MRCLAM");
}

TEST_CASE("TUM and EuRoC references are tables") {
  const import::Recording tum = read_text(
      "# timestamp tx ty tz qx qy qz qw\n1305031102.1758 1.3 0.6 1.6 0.6 0.6 -0.3 -0.3\n"
      "1305031102.2758 1.4 0.6 1.6 0.6 0.6 -0.3 -0.3\n");
  CHECK(names(tum.streams[0]) ==
        std::vector<std::string>{"timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"});
  const import::Recording euroc = read_text(
      "#timestamp [ns], p_RS_R_x [m], q_RS_w []\n1403636580838555648,4.6,0.5\n1403636580843555648,4.7,0.5\n");
  CHECK(names(euroc.streams[0]) == std::vector<std::string>{"timestamp", "p_RS_R_x", "q_RS_w"});
  CHECK(unit(euroc, "timestamp") == "ns");
  CHECK(values(euroc.streams[0], "timestamp")[0] == 1403636580838555648.0);
}

namespace {

// Rows of a serial monitor, with a stamp before each.
std::string stamped(const std::vector<std::string>& rows) {
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += "12:00:" + std::to_string(10 + k) + ".250 -> " + rows[k] + "\n";
  return text;
}

}  // namespace

TEST_CASE("A comma behind a stamp is a decimal sign where the rows show it, and a doubt where they do not") {
  const import::Recording zeros = read_text(stamped({"10,05", "10,50", "11,00", "11,25"}));
  CHECK(values(zeros.streams[0], "2") == Values{10.05, 10.5, 11.0, 11.25});
  const import::Recording carries = read_text(
      stamped({"9,55", "9,75", "9,95", "10,15", "10,35", "10,85", "11,25", "11,95", "12,15", "12,55"}));
  CHECK(values(carries.streams[0], "2").back() == 12.55);
  CHECK(has_remark(carries, "taken for the decimal sign"));
  const import::Recording mixed = read_text(stamped({"10", "10,5", "11", "11,5", "12", "12,5"}));
  CHECK(values(mixed.streams[0], "2") == Values{10.0, 10.5, 11.0, 11.5, 12.0, 12.5});
  const import::Recording open = read_text(stamped({"10,5", "11,6", "12,8", "13,9"}));
  CHECK(values(open.streams[0], "3") == Values{5.0, 6.0, 8.0, 9.0});
  CHECK(has_remark(open, "it could also be a decimal sign"));
  const import::Recording counters =
      read_text(stamped({"10,25", "11,26", "12,27", "12,28", "13,29", "14,31", "15,32", "16,30"}));
  CHECK(values(counters.streams[0], "3").back() == 30.0);
}
