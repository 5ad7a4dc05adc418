#include "tools/wheelwright/page/html.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright::tools;

TEST_CASE("Text on a page can neither be markup nor hold control characters") {
  CHECK(html::escaped("<b> & \"x\"") == "&lt;b&gt; &amp; &quot;x&quot;");
  CHECK(html::escaped("a\x1b\u202e\xff\nü") == "a\\x1b\\u202e\\xff\nü");
}
