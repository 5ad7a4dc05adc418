#include "config/load/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>

#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace wheelwright;
using config::OutputFile;
using config::OutputKind;
namespace fs = std::filesystem;

namespace {

const std::string own = "# wheelwright_drive_log: 1\nt\n";

fs::path folder(const std::string& name) {
  const fs::path made = test::temporary_folder() / ("output_" + name);
  fs::create_directory(made);
  return made;
}

void put(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string refusal(const fs::path& path, const config::InputFiles& inputs = {}) {
  const OutputFile output{path, OutputKind::drive_log};
  return config::check_outputs({&output, 1}, inputs).value_or("");
}

}  // namespace

TEST_CASE("An output of its own kind is replaced whole, and nothing is left beside it") {
  const auto at = folder("replaced");
  CHECK_FALSE(config::write_output({at / "log.csv", OutputKind::drive_log}, own + "1"));
  CHECK_FALSE(config::write_output({at / "log.csv", OutputKind::drive_log}, own + "2"));
  CHECK(contents(at / "log.csv") == own + "2");
  CHECK(std::distance(fs::directory_iterator(at), {}) == 1);
}

TEST_CASE("The mode of a file that is replaced is kept, and an empty file may be replaced") {
  const auto path = folder("mode") / "log.csv";
  put(path, "");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  CHECK_FALSE(config::write_output({path, OutputKind::drive_log}, own));
  CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("A file of another kind is refused and stays as it is") {
  const auto path = folder("foreign") / "thesis.txt";
  put(path, "years of work\n");
  CHECK_THAT(refusal(path), ContainsSubstring("holds something else"));
  CHECK(config::write_output({path, OutputKind::drive_log}, own));
  CHECK_FALSE(config::open_output({path, OutputKind::drive_log}));
  CHECK(contents(path) == "years of work\n");
}

TEST_CASE("A link, a folder, a pipe and a device are refused and stay what they are") {
  const auto at = folder("types");
  put(at / "target", own);
  fs::create_symlink("target", at / "link");
  fs::create_symlink("nowhere", at / "dangling");
  fs::create_directory(at / "folder");
  REQUIRE(::mkfifo((at / "pipe").c_str(), 0600) == 0);
  for (const fs::path& path :
       {at / "link", at / "dangling", at / "folder", at / "pipe", fs::path("/dev/null")}) {
    CAPTURE(path.string());
    CHECK_THAT(refusal(path), ContainsSubstring("does not replace"));
    CHECK(config::write_output({path, OutputKind::any}, own));
    CHECK_FALSE(config::open_output({path, OutputKind::any}));
  }
  CHECK(contents(at / "target") == own);
  CHECK(fs::is_symlink(at / "dangling"));
  CHECK_FALSE(fs::exists(at / "nowhere"));
  CHECK(fs::is_fifo(at / "pipe"));
}

TEST_CASE("An input is found by any name") {
  const auto at = folder("inputs");
  put(at / "in.csv", own);
  fs::create_hard_link(at / "in.csv", at / "hard.csv");
  for (const fs::path& path : {at / "in.csv", at / "hard.csv", at / ".." / at.filename() / "in.csv"}) {
    CHECK_THAT(refusal(path, {at / "in.csv"}), ContainsSubstring("would replace an input"));
  }
  CHECK(refusal(at / "out.csv", {at / "in.csv"}).empty());
}

TEST_CASE("What lies at the name of a temporary file is not touched") {
  const auto at = folder("part");
  put(at / "precious", "text");
  fs::create_symlink("precious", at / "log.csv.part");
  CHECK_FALSE(config::write_output({at / "log.csv", OutputKind::drive_log}, own));
  CHECK(contents(at / "precious") == "text");
  CHECK(fs::is_symlink(at / "log.csv.part"));
}

TEST_CASE("Two outputs may not be one file, however it is spelled") {
  const auto at = folder("twice");
  const std::array<OutputFile, 2> outputs{OutputFile{at / "same", OutputKind::mcap},
                                          OutputFile{at / "." / "same", OutputKind::plain_csv}};
  CHECK(config::check_outputs(outputs, {}));
}

TEST_CASE("A missing folder and a folder that may not be written are found before the work") {
  CHECK_THAT(refusal(folder("gone") / "no" / "log.csv"), ContainsSubstring("No such file"));
}

TEST_CASE("Files of fixed names are replaced only in a folder that the command filled") {
  const auto at = folder("fixed");
  constexpr std::array<std::string_view, 2> names{"gap.json", "model.yaml"};
  const OutputFile marker{"gap.json", OutputKind::gap};
  CHECK_FALSE(config::check_output_folder(at, marker, names, {}));
  put(at / "model.yaml", "wheelwright_model: 1\n");
  CHECK(config::check_output_folder(at, marker, names, {}));
  put(at / "gap.json", R"({"verdict": "none", "summary": ""})");
  CHECK_FALSE(config::check_output_folder(at, marker, names, {}));
  CHECK(config::check_output_folder(at, marker, names, {at / "model.yaml"}));
}

TEST_CASE("A growing output empties a file of its own kind, but not one with a second name") {
  const auto at = folder("growing");
  put(at / "log.csv", own);
  const auto opened = config::open_output({at / "log.csv", OutputKind::drive_log});
  REQUIRE(opened);
  ::close(*opened);
  CHECK(fs::file_size(at / "log.csv") == 0);
  put(at / "log.csv", own);
  fs::create_hard_link(at / "log.csv", at / "other.csv");
  CHECK_FALSE(config::open_output({at / "log.csv", OutputKind::drive_log}));
  CHECK(contents(at / "other.csv") == own);
}
