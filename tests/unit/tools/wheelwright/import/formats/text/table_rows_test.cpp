// The rows of a table: cells of every kind, and lines that are no rows.
#include <cmath>

#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

TEST_CASE("Words for a missing value are read as not-a-number") {
  const Values read = values("t,v\n0,NaN\n1,NULL\n2,N/A\n3,-\n4,\n5,inf\n6,nan\n7,2.5\n", "v");
  REQUIRE(read.size() == 8);
  for (std::size_t i = 0; i < 7; ++i) CHECK(std::isnan(read[i]));
  CHECK(read[7] == 2.5);
}

TEST_CASE("Truth values and hexadecimal counts are numbers") {
  CHECK(values("t,v\n0,true\n1,False\n2,0x1F\n", "v") == Values{1.0, 0.0, 31.0});
}

TEST_CASE("Thousands separators are read where they can be nothing else") {
  CHECK(values("t;n\n0;1,234.5\n1;2,234,567.25\n2;0.5\n", "n") == Values{1234.5, 2234567.25, 0.5});
  CHECK(values("t;n\n0;1.234,5\n1;2.234.567,25\n2;0,5\n", "n") == Values{1234.5, 2234567.25, 0.5});
}

TEST_CASE("Every number is read to its last bit") {
  CHECK(values("t,v\n0,0.1\n1,123456.789012\n2,7.605552673339844e-05\n3,-12345678901234567890\n", "v") ==
        Values{0.1, 123456.789012, 7.605552673339844e-05, -12345678901234567890.0});
}

TEST_CASE("The header row once more is left out") {
  const import::Recording recording = read_text("t,v\n0,1\nt,v\n1,2\n");
  CHECK(values(recording.streams[0], "t") == Values{0.0, 1.0});
  CHECK(has_remark(recording, "line 3: the header row once more"));
  CHECK(recording.streams[0].places == std::vector<std::size_t>{2, 4});
}

TEST_CASE("Rows of other width and text between rows are left out and counted") {
  const import::Recording recording =
      read_text("t,l,r\n0,1,2\n1,2\nreset\n2,3,4\n# note\n3,4\n4,5,6\n5,6,7\n");
  CHECK(values(recording.streams[0], "t") == Values{0.0, 2.0, 4.0, 5.0});
  CHECK(has_remark(recording, "2 lines, the first is line 3: not as many fields"));
  CHECK(has_remark(recording, "a comment between the rows"));
}

TEST_CASE("A cell that is no number is missing, and said") {
  const import::Recording recording = read_text("t,l,r\n0,1,2\n1,x2,3\n2,3,4\n");
  CHECK(std::isnan(values(recording.streams[0], "l")[1]));
  CHECK(has_remark(recording, "line 3: no number in column 'l'"));
}

TEST_CASE("A last row that was cut off is left out") {
  const import::Recording fewer = read_text("t,l,r\n0,1,2\n1,2,3\n2,3");
  CHECK(fewer.streams[0].rows == 2);
  CHECK(has_remark(fewer, "line 4: the last row is cut short"));
  CHECK(read_text("t,l\n0,1.25\n1,1.50\n2,1.").streams[0].rows == 2);
  CHECK(read_text("t,l\n0,1.25\n1,1.50\n2,1.5").streams[0].rows == 3);
}

TEST_CASE("Zero bytes that a power cut left are left out with the row that it cut") {
  const import::Recording recording = read_text(std::string("t,l\n0,1\n1,2\n2,") + std::string(40, '\0'));
  CHECK(recording.streams[0].rows == 2);
  CHECK(has_remark(recording, "40 zero bytes"));
}

TEST_CASE("Several tables in one file are several streams") {
  const import::Recording recording =
      read_text("t,l,r\n0,1,2\n1,2,3\n\nt,x\n0,5\n1,6\n2,7\nt,l,r\n2,3,4\n3,4,5\n");
  REQUIRE(recording.streams.size() == 2);
  CHECK(values(recording.streams[0], "l") == Values{1.0, 2.0, 3.0, 4.0});
  CHECK(values(recording.streams[1], "x") == Values{5.0, 6.0, 7.0});
}

TEST_CASE("Rows of another width in sequence are a table of their own") {
  const import::Recording recording =
      read_text("0,1,2\n1,2,3\n2,3,4\n3,4,5\n4,5,6\n5,6,7\n0,1\n1,2\n2,3\n3,4\n4,5\n");
  REQUIRE(recording.streams.size() == 2);
  CHECK(recording.streams[0].rows == 6);
  CHECK(recording.streams[1].rows == 5);
}

TEST_CASE("A column of labels parts the rows into streams") {
  const import::Recording recording =
      read_text("time,topic,x,y\n0.0,odom,1,2\n0.1,imu,3,\n0.2,odom,5,6\n0.3,imu,7,\n0.4,odom,8,9\n");
  REQUIRE(recording.streams.size() == 2);
  CHECK(values(stream(recording, "odom"), "x") == Values{1.0, 5.0, 8.0});
  CHECK(stream(recording, "imu").find("y") == nullptr);
  CHECK(stream(recording, "imu").places == std::vector<std::size_t>{3, 5});
  CHECK(has_remark(recording, "column 'topic' parts the rows into 2 streams"));
}

TEST_CASE("A state that stands for many rows does not part them") {
  std::string text = "t,state,v\n";
  for (int i = 0; i < 40; ++i)
    text += std::to_string(i) + (i < 20 ? ",STOP," : ",DRIVE,") + std::to_string(i) + "\n";
  const import::Recording recording = read_text(text);
  REQUIRE(recording.streams.size() == 1);
  CHECK(recording.streams[0].rows == 40);
  CHECK(has_remark(recording, "column 'state' holds text ('STOP', 'DRIVE'): left out"));
}

TEST_CASE("Columns without a value in any row are left out in one line, and no text") {
  std::string text = "t,ref_x,v,gyro_z\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(i) + ",," + std::to_string(2 * i) + ",\n";
  const import::Recording recording = read_text(text);
  REQUIRE(recording.streams.size() == 1);
  CHECK(recording.streams[0].channels.size() == 2);
  CHECK(has_remark(recording, "no value in any row of 'ref_x', 'gyro_z': left out"));
}

TEST_CASE("Lines without numbers in number columns and endless widths take no memory") {
  std::string text = "t,v\n0,1\n1,2\n2,3\n";
  text.append(1'000'000, ',');
  text += "\n3,4\n";
  const import::Recording recording = read_text(text);
  CHECK(recording.streams[0].channels.size() == 2);
  CHECK(recording.streams[0].find("v")->values.back() == 4.0);
}

TEST_CASE("Lists and tuples that were printed are rows") {
  for (const char* text :
       {"[0.5, 1, 2]\n[0.6, 2, 3]\n[0.7, 2, 3]\n", "(0.5, 1, 2)\n(0.6, 2, 3)\n(0.7, 2, 3)\n",
        "[0.5, 1, 2],\n[0.6, 2, 3],\n[0.7, 2, 3],\n"}) {
    CAPTURE(text);
    const import::Stream stream = read_text(text).streams.at(0);
    REQUIRE(stream.channels.size() == 3);
    CHECK(stream.channels[0].values == std::vector<double>{0.5, 0.6, 0.7});
    CHECK(stream.channels[2].values == std::vector<double>{2.0, 3.0, 3.0});
  }
}
