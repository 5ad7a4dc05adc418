#include "tools/wheelwright/common/progress_line.hpp"

#include <sstream>

#include "tests/support/catch.hpp"

using wheelwright::tools::progress_text;

TEST_CASE("Progress is a bar, a share, a word, and the time left at this pace") {
  CHECK(progress_text("fitting", 0.4, 8.0) == "[########            ]  40 %  fitting, about 12 s left");
  CHECK(progress_text("done", 1.0, 8.0) == "[####################] 100 %  done");
  CHECK(progress_text("search", 0.5, 600.0) == "[##########          ]  50 %  search, about 10 min left");
}

TEST_CASE("Progress does not guess the time left from next to nothing") {
  CHECK(progress_text("reading", 0.01, 30.0) == "[                    ]   1 %  reading");
  CHECK(progress_text("reading", 0.5, 0.2) == "[##########          ]  50 %  reading");
}

TEST_CASE("Progress is silent where nobody watches") {
  std::ostringstream pipe;
  wheelwright::tools::ProgressLine line(pipe);
  line.callback()("fitting", 0.5);
  line.clear();
  CHECK(pipe.str().empty());
}
