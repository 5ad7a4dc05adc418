// Times and dates that were written for people.
#include "tests/unit/tools/wheelwright/import/formats/text/read_text.hpp"
#include "tools/wheelwright/import/formats/text/time_text.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
using import::DateOrder;
using import::TimeForm;

namespace {

double seconds(const std::string& text, DateOrder order = DateOrder::month_first) {
  const auto time = import::read_time(text, order);
  INFO(text);
  REQUIRE(time);
  return time->seconds;
}

constexpr double noon = 1709640000.0;  // of 5 March 2024

}  // namespace

TEST_CASE("A time of day is read in hours, minutes and seconds") {
  CHECK(seconds("0:00:01.25") == Approx(1.25));
  CHECK(seconds("1:02:03,5") == Approx(3723.5));
  CHECK(seconds("02:03.5") == Approx(123.5));
  CHECK(seconds("06:57:06 PM") == Approx(68226.0));
  CHECK(seconds("12:00:01 am") == Approx(1.0));
  CHECK(seconds("1 days 00:00:01.5") == Approx(86401.5));
}

TEST_CASE("Dates are read in the ways that people write them") {
  CHECK(seconds("2024-03-05T12:00:00Z") == noon);
  CHECK(seconds("2024-03-05 12:00:00.250") == noon + 0.25);
  CHECK(seconds("2024/03/05 13:00:00+01:00") == noon);
  CHECK(seconds("2024-03-05T07:00:00-0500") == noon);
  CHECK(seconds("5.3.2024 12:00:00") == noon);
  CHECK(seconds("05-Mar-2024 12:00:00") == noon);
  CHECK(seconds("3/5/2024 12:00:00 PM") == noon);
  CHECK(seconds("5/3/2024 12:00", DateOrder::day_first) == noon);
  CHECK(import::read_time("2024-03-05", DateOrder::day_first)->form == TimeForm::date);
}

TEST_CASE("What is no time is not read as one") {
  for (const char* text :
       {"1.5", "12:61:00", "25", "2024-13-05", "2024-02-30", "1:2:3:4", "12:00:00x", "-1:00:00"})
    CHECK_FALSE(import::read_time(text, DateOrder::day_first));
}

TEST_CASE("Columns of times have seconds, and say of which kind") {
  const import::Recording clock = read_text("time;v\n0:00:00.5;1\n0:00:00.6;2\n");
  CHECK(values(clock.streams[0], "time") == Values{0.5, 0.6});
  CHECK(unit(clock, "time") == "hms");
  const import::Recording iso = read_text("stamp,v\n2024-03-05T12:00:00Z,1\n2024-03-05T12:00:00.5Z,2\n");
  CHECK(values(iso.streams[0], "stamp") == Values{noon, noon + 0.5});
  CHECK(unit(iso, "stamp") == "iso");
}

TEST_CASE("A date and its time in two columns are one channel") {
  const import::Recording recording =
      read_text("Date,Time,v\n05/03/2024,12:00:00,1\n05/03/2024,12:00:01,2\n25/03/2024,12:00:02,2\n");
  CHECK(values(recording.streams[0], "Date Time")[1] == noon + 1.0);
  CHECK(unit(recording, "Date Time") == "iso");
  CHECK(names(recording.streams[0]) == std::vector<std::string>{"Date Time", "v"});
}

TEST_CASE("The order of day and month is taken from a number above 12") {
  CHECK(import::order_shown_by("25/03/2024") == DateOrder::day_first);
  CHECK(import::order_shown_by("03/25/2024 12:00") == DateOrder::month_first);
  CHECK(import::order_shown_by("03/05/2024") == std::nullopt);
}

TEST_CASE("The stamp of a serial monitor before each row is a channel") {
  const import::Recording recording = read_text(
      "12:00:00.100 -> boot\n12:00:00.200 -> t,l,r\n12:00:00.300 -> 10,5,1\n12:00:00.400 -> "
      "20,6,2\n12:00:00.500 -> 30,7,3\n");
  CHECK(names(recording.streams[0]) == std::vector<std::string>{"stamp", "t", "l", "r"});
  CHECK(values(recording.streams[0], "stamp")[0] == Approx(43200.3));
  CHECK(values(recording.streams[0], "l") == Values{5.0, 6.0, 7.0});
}
