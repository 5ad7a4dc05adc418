// Rows that programs print as records: JSON, Python dicts.
#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

TEST_CASE("Lines that are Python dicts are read as JSON is") {
  const import::Recording recording = read_text(
      "{'t': 0.5, 'enc': (1, 2), 'ok': True, 'note': None, 'mode': 'it\\'s', 'v': np.float64(-1e-05)}\n"
      "{'t': 0.6, 'enc': (3, 4), 'ok': False, 'note': nan, 'mode': 'b', 'v': np.float64(0.2)}\n");
  const import::Stream& table = recording.streams.at(0);
  CHECK(values(table, "t") == Values{0.5, 0.6});
  CHECK(values(table, "enc[1]") == Values{2, 4});
  CHECK(values(table, "ok") == Values{1, 0});
  CHECK(values(table, "v") == Values{-1e-5, 0.2});
  CHECK(std::isnan(values(table, "note").at(0)));
}

TEST_CASE("An array of objects is a table, on one line and on many, and what stands beside it is metadata") {
  for (const std::string& blank : {std::string(), std::string("\n  ")}) {
    const import::Recording recording =
        read_text("{\"wheel_base_m\": 0.3, \"robot\": \"Rover\", \"rows\": [" + blank + "{\"t\": 0.1," +
                  blank + "\"enc\": {\"left\": 1}}," + blank + "{\"t\": 0.2, \"enc\": {\"left\": 5}}]}");
    CHECK(values(recording.streams.at(0), "t") == Values{0.1, 0.2});
    CHECK(values(recording.streams.at(0), "enc.left") == Values{1, 5});
    using Pairs = std::vector<std::pair<std::string, std::string>>;
    CHECK(recording.metadata == Pairs{{"wheel_base_m", "0.3"}, {"robot", "Rover"}});
  }
}

TEST_CASE("Arrays of numbers are columns, and arrays of arrays are rows") {
  const auto columns = read_text("{\"t\": [0.1, 0.2, 0.3], \"n\": [1, null, 3]}");
  CHECK(values(columns.streams.at(0), "t") == Values{0.1, 0.2, 0.3});
  CHECK(values(columns.streams.at(0), "n").at(2) == 3.0);
  const auto rows = read_text("[[0.1, 1], [0.2, 5], [0.3, 9]]");
  CHECK(values(rows.streams.at(0), "2") == Values{1, 5, 9});
}
