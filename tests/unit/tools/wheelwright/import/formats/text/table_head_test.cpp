// What stands above the rows of a table: names, units, metadata.
#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

using Names = std::vector<std::string>;

namespace {

Names names_of(const std::string& text) {
  return names(read_text(text).streams.at(0));
}

}  // namespace

TEST_CASE("Columns without a header row have their numbers for names") {
  const import::Recording recording = read_text("1,2,0.5\n2,3,0.6\n");
  CHECK(names(recording.streams[0]) == Names{"1", "2", "3"});
  CHECK_THAT(recording.format, ContainsSubstring("no header row"));
}

TEST_CASE("A header row may be a comment") {
  CHECK(names_of("#time;posL\n0:00:00.5;3\n0:00:00.6;4\n") == Names{"time", "posL"});
  CHECK(names_of("%time,field.x\n1678384520802112048,3\n1678384520852112048,4\n") ==
        Names{"time", "field.x"});
}

TEST_CASE("Comments and pairs above a table are metadata") {
  const import::Recording recording = read_text("# robot: Rover\nversion=3\n# hand-made\nt,v\n1,2\n2,3\n");
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  CHECK(recording.metadata == Pairs{{"robot", "Rover"}, {"version", "3"}, {"comment", "hand-made"}});
  CHECK(names(recording.streams[0]) == Names{"t", "v"});
}

TEST_CASE("A comment with a key is no header of a table without one") {
  CHECK(names_of("# note: a, b\n1,2\n2,3\n") == Names{"1", "2"});
}

TEST_CASE("Text above a table is left out with a remark") {
  CHECK(has_remark(read_text("Experiment 5\nt,v\n1,2\n2,3\n"),
                   "line 1: 'Experiment 5' above the table: left out"));
}

TEST_CASE("Units in brackets behind a name are its unit, other brackets stay") {
  const import::Recording recording =
      read_text("t [ms],speed (m/s),v (left),pose[0],v_mps\n1,2,3,4,5\n2,3,4,5,6\n");
  CHECK(names(recording.streams[0]) == Names{"t", "speed", "v (left)", "pose[0]", "v_mps"});
  CHECK(unit(recording, "t") == "ms");
  CHECK(unit(recording, "speed") == "m/s");
  CHECK(unit(recording, "v (left)").empty());
  CHECK(unit(recording, "v_mps").empty());
}

TEST_CASE("Names that differ in their units only keep them") {
  CHECK(names_of("speed (m/s),speed (rpm)\n1,2\n2,3\n") == Names{"speed (m/s)", "speed (rpm)"});
}

TEST_CASE("A row of units beneath the header is read as such") {
  const import::Recording recording = read_text("time,speed,mode\n(s),[m/s],-\n1,2,3\n2,3,4\n");
  CHECK(unit(recording, "time") == "s");
  CHECK(unit(recording, "speed") == "m/s");
  CHECK(recording.streams[0].rows == 2);
}

TEST_CASE("A column without a name that counts the rows is left out") {
  const import::Recording pandas = read_text(",t,v\n0,0.1,5\n1,0.2,6\n2,0.3,7\n");
  CHECK(names(pandas.streams[0]) == Names{"t", "v"});
  CHECK(has_remark(pandas, "counts the rows from 0"));
  CHECK(names_of("\"t\" \"v\" \"w\"\n\"1\" 0.1 5 6\n\"2\" 0.2 6 7\n") == Names{"t", "v", "w"});
}

TEST_CASE("Where a name is missing it is that of row names, or else the last one, and that is said") {
  CHECK(names_of("t,v\n1,0.1,5\n2,0.2,6\n3,0.3,7\n").back() == "v");
  const import::Recording recording = read_text("t,v\n0.02,5,12.4\n0.04,6,12.5\n0.06,7,12.4\n");
  const Names found = names(recording.streams[0]);
  REQUIRE(found.size() == 3);
  CHECK(found[0] == "t");
  CHECK(found[1] == "v");
  CHECK(std::ranges::any_of(recording.remarks, [](const std::string& remark) {
    return remark.find("2 names above 3 columns") != std::string::npos;
  }));
}

TEST_CASE("Numbers that pandas writes for names are no row") {
  const import::Recording recording = read_text(",0,1,2\n0,0.1,5,6\n1,0.2,6,7\n");
  CHECK(names(recording.streams[0]) == Names{"0", "1", "2"});
  CHECK(recording.streams[0].rows == 2);
}

TEST_CASE("Equal names are told apart") {
  CHECK(names_of("x,x,t\n1,2,3\n2,3,4\n") == Names{"x", "x.2", "t"});
  CHECK(names_of("left,left,right,right\npos,vel,pos,vel\n1,2,3,4\n2,3,4,5\n") ==
        Names{"left.pos", "left.vel", "right.pos", "right.vel"});
}

TEST_CASE("A table of one row is read") {
  CHECK(values("t,l,r\n0.1,2,3\n", "l") == Values{2.0});
}

TEST_CASE("A header without rows is refused") {
  CHECK_THAT(refusal_of("t,left,right\n"), ContainsSubstring("no rows of numbers"));
  CHECK_THAT(refusal_of("hello world\nthis is text\n"), ContainsSubstring("hello world"));
  CHECK_THAT(refusal_of("\n\n"), ContainsSubstring("holds nothing"));
}

TEST_CASE("A name too many is that of a note or a version, and one too few may be that of an index") {
  CHECK(names_of("t,v,Comment\n1,2\n2,3\n3,4\n") == Names{"t", "v"});
  CHECK(names_of("v=1,t,v,mark\n1,2\n2,3\n3,4\n") == Names{"t", "v"});
  CHECK(names_of("t,v\n0,0.5,2\n1,0.6,3\n2,0.7,4\n") == Names{"t", "v"});
}
