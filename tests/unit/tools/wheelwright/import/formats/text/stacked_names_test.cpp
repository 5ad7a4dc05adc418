// Names in several rows above a table, as motion capture systems write them.
#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

namespace {

// With the numbers of the bodies in a row that would be one of the table but for its first word.
std::string motive() {
  std::string text =
      "Format Version,1.23,Take Name,Take 1,Capture Frame Rate,120.000000,Export Frame Rate,120.000000,"
      "Rotation Type,Quaternion,Length Units,Millimeters,Coordinate Space,Global\n"
      "\n"
      ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
      "Body,Marker,Marker,Marker\n"
      ",Name,Robot,Robot,Robot,Robot,Robot,Robot,Robot,Robot,Robot:1,Robot:1,Robot:1\n"
      ",ID,1,1,1,1,1,1,1,1,2,2,2\n"
      ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker "
      "Error,Position,Position,Position\n"
      "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z\n";
  for (int k = 0; k < 20; ++k)
    text += std::to_string(k) + "," + std::to_string(k / 120.0) +
            ",0.0,0.1,0.0,0.995,1.5,2.5,3.5,0.01,4.5,5.5,6.5\n";
  return text;
}

}  // namespace

TEST_CASE("Names of a motion capture system are joined up to the body that they belong to") {
  const import::Recording recording = read_text(motive());
  CHECK(names(recording.streams.at(0)) ==
        std::vector<std::string>{"Frame", "Time", "Robot.Rotation.X", "Robot.Rotation.Y", "Robot.Rotation.Z",
                                 "Robot.Rotation.W", "Robot.Position.X", "Robot.Position.Y",
                                 "Robot.Position.Z", "Robot.Mean Marker Error", "Robot:1.Position.X",
                                 "Robot:1.Position.Y", "Robot:1.Position.Z"});
  CHECK(values(recording.streams.at(0), "Robot.Position.Z") == Values(20, 3.5));
}

TEST_CASE("Pairs in one line above a table are metadata") {
  const import::Recording recording = read_text(motive());
  const auto has = [&](const std::string& key, const std::string& value) {
    return std::ranges::find(recording.metadata, std::pair(key, value)) != recording.metadata.end();
  };
  CHECK(has("Length Units", "Millimeters"));
  CHECK(has("Export Frame Rate", "120.000000"));
}
