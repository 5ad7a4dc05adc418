#include "config/load/printable_text.hpp"

#include "tests/support/catch.hpp"

using wheelwright::config::excerpt;
using wheelwright::config::printable;
using wheelwright::config::printable_json;
using wheelwright::config::printable_lines;

TEST_CASE("Letters of every script stay as they are") {
  for (const std::string text : {"plain, 'quoted' \\ text", "Übergröße", "ロボット", "робот", "🤖", ""}) {
    CHECK(printable(text) == text);
    CHECK(printable_lines(text) == text);
  }
}

TEST_CASE("Control characters are escaped, in a message line breaks too") {
  CHECK(printable("\x1b]0;title\x07") == "\\x1b]0;title\\x07");
  CHECK(printable(std::string("a\0b\x7f", 4)) == "a\\x00b\\x7f");
  CHECK(printable("one\r\ntwo\t") == "one\\x0d\\x0atwo\\x09");
  CHECK(printable_lines("one\r\n\ttwo") == "one\\x0d\n\ttwo");
  CHECK(printable("\u009b31m") == "\\u009b31m");
}

TEST_CASE("Characters that turn the direction of writing or end a line are escaped") {
  CHECK(printable("a\u202eb\u2066c\u200fd\u2028e\u061cf") == "a\\u202eb\\u2066c\\u200fd\\u2028e\\u061cf");
}

TEST_CASE("Bytes that are not UTF-8 are escaped one by one, and what follows them is still read") {
  CHECK(printable("\xff\xfe") == "\\xff\\xfe");
  CHECK(printable("\x9b\x41") == "\\x9bA");               // a control character of Latin 1
  CHECK(printable("\xc3") == "\\xc3");                    // cut short
  CHECK(printable("\xc3\x1b") == "\\xc3\\x1b");           // cut short by a control character
  CHECK(printable("\xc0\x9b") == "\\xc0\\x9b");           // overlong
  CHECK(printable("\xe0\x82\x9b") == "\\xe0\\x82\\x9b");  // overlong
  CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");  // half of a pair
  CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
}

TEST_CASE("A printable text stays as it is when it passes again") {
  const std::string once = printable("\x1b[31m\u202e\xff");
  CHECK(printable(once) == once);
}

TEST_CASE("A long text ends in dots, at a whole character") {
  CHECK(printable("abcdef", 6) == "abcdef");
  CHECK(printable("abcdefg", 6) == "abcdef...");
  CHECK(printable("abcdeü", 6) == "abcde...");
  CHECK(printable("abcd\x1b", 6) == "abcd...");
  CHECK(excerpt(std::string(1000, 'x')).size() < 100);
}

TEST_CASE("JSON stays JSON when its strings hold control characters or no UTF-8") {
  CHECK(printable_json("{\n\t\"a\": \"\x7f\u009b\u202e\xffü\"}") ==
        "{\n\t\"a\": \"\\u007f\\u009b\\u202e\\ufffdü\"}");
}
