// Numbers whose digits stand in groups of three.
#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;

TEST_CASE("Commas within quotes are between thousands if they stand so in all numbers of the column") {
  const Values right{998, 999, 1001, 1234, 12345};
  CHECK(values("t,n\n0.1,998\n0.2,999\n0.3,\"1,001\"\n0.4,\"1,234\"\n0.5,\"12,345\"\n", "n") == right);
}

TEST_CASE("A comma before three figures is no sign between thousands if others of the column have two") {
  const import::Recording recording =
      read_text("t,n\n0.1,\"1,001\"\n0.2,\"1,23\"\n0.3,\"1,234\"\n0.4,\"1,235\"\n");
  const import::Channel* n = recording.streams.at(0).find("n");
  CHECK((n == nullptr || !std::isfinite(n->values.at(0))));
}

TEST_CASE("A point is between thousands beside a decimal comma, not where larger numbers have none") {
  CHECK(values("t;v;n\n0,1;0,5;998\n0,2;0,5;1.001\n0,3;0,6;1.002\n0,4;0,6;1.003\n", "n") ==
        Values{998, 1001, 1002, 1003});
  const auto mixed = read_text("t;v;n\n0,1;0,5;1998\n0,2;0,5;1.001\n0,3;0,6;1.002\n0,4;0,6;1.003\n");
  const import::Channel* n = mixed.streams.at(0).find("n");
  CHECK((n == nullptr || !std::isfinite(n->values.at(1))));
}

TEST_CASE("Apostrophes and blanks between groups of three figures are left out") {
  CHECK(values("t,n\n0.1,999\n0.2,1'001\n0.3,-12'345.5\n", "n") == Values{999, 1001, -12345.5});
  CHECK(values("t;n\n0,1;999\n0,2;1 001,5\n0,3;12 345,5\n", "n") == Values{999, 1001.5, 12345.5});
  CHECK(values("t;n\n0,1;999\n0,2;1\xc2\xa0"
               "001,5\n0,3;12\xc2\xa0"
               "345,5\n",
               "n") == Values{999, 1001.5, 12345.5});
}
