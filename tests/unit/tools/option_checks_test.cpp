#include "tools/option_checks.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright;

namespace {

enum class Colour : unsigned char { red, green };

struct Parsed {
  Colour colour = Colour::red;
  double length_m = 1.0;
  std::string refusal;
};

Parsed parsed(const std::vector<std::string>& arguments) {
  Parsed result;
  CLI::App app;
  app.add_option("--colour", result.colour)
      ->transform(
          tools::one_of<Colour>({{"red", Colour::red}, {"green", Colour::green}, {"lawn", Colour::green}}));
  app.add_option("--length", result.length_m)->check(tools::number_between(0.5, 2.0, "m"));
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    result.refusal = error.what();
  }
  return result;
}

}  // namespace

TEST_CASE("An option of words takes each of them for its value") {
  CHECK(parsed({"--colour", "green"}).colour == Colour::green);
  CHECK(parsed({"--colour", "red"}).colour == Colour::red);
  CHECK(parsed({"--colour", "lawn"}).refusal.empty());
}

TEST_CASE("An option of words refuses others, and their inner numbers, by naming the words") {
  for (const char* word : {"blue", "1", "Green", ""}) {
    CHECK(parsed({"--colour", word}).refusal ==
          "--colour: is '" + std::string(word) + "', but must be red, green or lawn");
  }
}

TEST_CASE("An option of a number refuses what is outside, and what is no number, by naming the bounds") {
  CHECK(parsed({"--length", "0.5"}).length_m == 0.5);
  CHECK(parsed({"--length", "2"}).refusal.empty());
  for (const char* word : {"0.49", "2.1", "-1", "nan", "inf", "long", "1x"}) {
    CHECK(parsed({"--length", word}).refusal ==
          "--length: is '" + std::string(word) + "', but must be a number from 0.5 to 2 m");
  }
}
