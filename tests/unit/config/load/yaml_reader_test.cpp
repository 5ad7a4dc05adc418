#include "config/load/yaml_reader.hpp"

#include "tests/support/catch.hpp"

using wheelwright::config::ConfigError;
using wheelwright::config::nearest_word;
using wheelwright::config::YamlReader;

namespace {

template <typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("A number out of range is refused with its place, its range and its unit") {
  YamlReader reader = YamlReader::parse("name: a\nperiod_s: 18\n", "robot.yaml");
  CHECK(error_of([&] {
          reader.number("period_s", {0.005, 0.5, "s"});
        }) == "robot.yaml:2:11: 'period_s' is 18, but must be a number from 0.005 to 0.5 s");
}

TEST_CASE("A value with a unit written behind it is no number") {
  YamlReader reader = YamlReader::parse("period_s: 18 ms\n", "robot.yaml");
  CHECK_THAT(error_of([&] {
               reader.number("period_s", {0.005, 0.5, "s"}, 0.018);
             }),
             ContainsSubstring("'period_s' is '18 ms', but must be a number"));
}

TEST_CASE("Not a number and infinity are refused") {
  for (const std::string value : {".nan", ".inf", "1e999"}) {
    YamlReader reader = YamlReader::parse("period_s: " + value + "\n", "robot.yaml");
    CHECK_THAT(error_of([&] {
                 reader.number("period_s", {-1e308, 1e308});
               }),
               ContainsSubstring("must be a number"));
  }
}

TEST_CASE("A key that is a part of another one is listed among those that are known") {
  YamlReader reader = YamlReader::parse("zzzzzzzz: 1\n", "robot.yaml");
  for (const char* key : {"encoder_order", "order"}) reader.text(key, "");
  CHECK_THAT(error_of([&] { reader.finish(); }), ContainsSubstring("encoder_order, order"));
}

TEST_CASE("An unknown key is an error that names the nearest right one") {
  YamlReader reader = YamlReader::parse("period_ms: 18\n", "robot.yaml");
  reader.number("period_s", {0.005, 0.5, "s"}, 0.018);
  reader.text("device", "/dev/ttyUSB0");
  CHECK(error_of([&] { reader.finish(); }) ==
        "robot.yaml:1:1: unknown key 'period_ms'; did you mean 'period_s'?");
}

TEST_CASE("A key that occurs twice is refused") {
  CHECK(error_of([] { YamlReader::parse("a: 1\na: 2\n", "robot.yaml"); }) ==
        "robot.yaml:2:1: 'a' occurs here a second time; keep one");
}

TEST_CASE("A missing key, a wrong word and a wrong type are each refused with their place") {
  YamlReader reader = YamlReader::parse("mode: sfae\nflag: 7\nrows: [[1, 2], [3]]\n", "f.yaml");
  CHECK_THAT(error_of([&] { reader.text("device"); }), ContainsSubstring("'device' is missing"));
  CHECK(error_of([&] {
          reader.choice<int>("mode", {{"safe", 1}, {"full", 2}}, 1);
        }) == "f.yaml:1:7: 'mode' is 'sfae', but must be one of: safe, full");
  CHECK_THAT(error_of([&] { reader.boolean("flag", true); }), ContainsSubstring("f.yaml:2:7"));
  CHECK_THAT(error_of([&] { reader.rows("rows", 2, {-9, 9, "m"}); }), ContainsSubstring("rows of 2 numbers"));
}

TEST_CASE("What is not YAML and what is no file are refused") {
  CHECK_THAT(error_of([] { YamlReader::parse("a: [1, 2\n", "f.yaml"); }),
             ContainsSubstring("not valid YAML"));
  CHECK_THAT(error_of([] { YamlReader::load("/nowhere/f.yaml"); }), ContainsSubstring("cannot be read"));
}

TEST_CASE("A word far from all others has no nearest word") {
  CHECK(nearest_word("zzzzzzzz", {"device", "period_s"}).empty());
  CHECK(nearest_word("devcie", {"device", "period_s"}) == "device");
}

TEST_CASE("A mapping of many keys is read in a time that grows as they do, and one of too many is refused") {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  CHECK(YamlReader::parse(text, "robot.yaml").number("key99999", {0, 10}) == 1.0);
  for (int i = 100'000; i < 300'000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  CHECK(error_of([&] { YamlReader::parse(text, "robot.yaml"); }) ==
        "robot.yaml:250000:12: holds more than 500000 values, which no file here needs");
}

TEST_CASE("Aliases count as what they stand for") {
  std::string text = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
  for (char name = 'b'; name < 'z'; ++name) {
    const std::string before(1, static_cast<char>(name - 1));
    const std::string eight = "*" + before + ", *" + before + ", *" + before + ", *" + before;
    text += std::string(1, name) + ": &" + std::string(1, name) + " [" + eight + ", " + eight + "]\n";
  }
  CHECK_THAT(error_of([&] { YamlReader::parse(text, "robot.yaml"); }),
             ContainsSubstring("holds more than 500000 values"));
  CHECK(YamlReader::parse("left: &wheel {gain: 2}\nright: *wheel\n", "robot.yaml")
            .section("right")
            ->number("gain", {0, 10}) == 2.0);
}

TEST_CASE("YAML that is nested too deep, or in itself, is refused with its place") {
  for (const std::string level : {"[", "- ", "? ", "{a: "}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += level;
    CHECK_THAT(error_of([&] { YamlReader::parse(text, "robot.yaml"); }),
               ContainsSubstring("robot.yaml:1:") && ContainsSubstring("is nested deeper than 64 levels"));
  }
  CHECK_THAT(error_of([] { YamlReader::parse("a: &a [*a]\n", "robot.yaml"); }),
             ContainsSubstring("an alias must not refer to itself"));
}

TEST_CASE("A value is quoted in a message as far as it helps, and printable") {
  const auto message_on = [](const std::string& value) {
    YamlReader reader = YamlReader::parse("period_s: " + value + "\n", "robot.yaml");
    return error_of([&] { reader.number("period_s", {0, 1}); });
  };
  CHECK_THAT(message_on("\"\\e]0;title\\a\""), ContainsSubstring("'period_s' is '\\x1b]0;title\\x07', but"));
  const std::string message = message_on(std::string(100'000, 'x'));
  CHECK(message.size() < 300);
  CHECK_THAT(message, Catch::Matchers::EndsWith("but must be a number from 0 to 1"));
}
