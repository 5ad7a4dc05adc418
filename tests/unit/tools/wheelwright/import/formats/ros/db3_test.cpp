// SQLite files of rosbag2, and the folders of its bags.
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "tests/support/bag_bytes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/wheelwright/import/open_recording.hpp"

using namespace wheelwright;
using namespace wheelwright::test;
namespace fs = std::filesystem;
using import::open_recording;
using import::Recording;

namespace {

class Database {
 public:
  explicit Database(const fs::path& path) {
    REQUIRE(sqlite3_open(path.c_str(), &handle_) == SQLITE_OK);
    run("PRAGMA synchronous = OFF");  // each row waits for the disk otherwise
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database() { sqlite3_close(handle_); }

  void run(const std::string& text) {
    INFO(text);
    REQUIRE(sqlite3_exec(handle_, text.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  }
  void make_tables() {
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, "
        "offered_qos_profiles TEXT)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)");
  }
  void add_topic(int id, const std::string& name, const std::string& type) {
    std::ostringstream text;
    text << "INSERT INTO topics VALUES(" << id << ",'" << name << "','" << type << "','cdr','')";
    run(text.str());
  }
  void add_message(int topic, std::uint64_t time_ns, const std::string& data) {
    std::ostringstream text;
    text << "INSERT INTO messages(topic_id, timestamp, data) VALUES(" << topic << "," << time_ns << ",x'";
    for (const char c : data) text << std::hex << std::setw(2) << std::setfill('0') << (c & 0xff);
    text << "')";
    run(text.str());
  }

 private:
  sqlite3* handle_ = nullptr;
};

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_count(const fs::path& path, const std::vector<int>& values, bool message_compression = false) {
  Database database(path);
  database.make_tables();
  database.add_topic(3, "/count", "std_msgs/msg/Int32");
  for (const int value : values) {
    const std::string message = CdrBytes().number(value).str();
    database.add_message(3, static_cast<std::uint64_t>(value) * 1'000'000'000,
                         message_compression ? compressed("zstd", message) : message);
  }
}

Recording read(const fs::path& path) {
  auto recording = open_recording(path);
  INFO((recording ? "" : recording.error()));
  REQUIRE(recording.has_value());
  return *std::move(recording);
}

std::vector<double> counts(const Recording& recording) {
  const auto* stream = recording.find("/count");
  return stream == nullptr || stream->channels.empty() ? std::vector<double>() : stream->channels[0].values;
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("A db3 without definitions is read by the usual types, and nothing is written beside it") {
  const TemporaryFolder folder("db3");
  const fs::path path = folder.path() / "odd ?name%20#.db3";
  {
    Database database(path);
    database.make_tables();
    database.add_topic(1, "/cmd_vel", "geometry_msgs/msg/Twist");
    database.add_topic(2, "/own", "own_msgs/msg/Own");
    CdrBytes twist;
    for (int i = 1; i <= 6; ++i) twist.number(static_cast<double>(i));
    database.add_message(1, 1'500'000'000, twist.str());
    database.add_message(2, 1'600'000'000, "anything");
  }
  const Recording recording = read(path);
  CHECK(recording.format == "ROS 2 bag (SQLite)");
  CHECK(recording.find("/cmd_vel")->find("angular.z")->values == std::vector<double>{6});
  CHECK(recording.find("/cmd_vel")->received_s == std::vector<double>{1.5});
  CHECK(recording.find("/own")->rows == 1);
  CHECK_THAT(recording.find("/own")->not_decoded, ContainsSubstring("no definition of own_msgs/msg/Own"));
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("The definitions that a db3 holds come before those that are known") {
  const TemporaryFolder folder("db3");
  const fs::path path = folder.path() / "a.db3";
  {
    Database database(path);
    database.make_tables();
    database.run(
        "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT, encoding TEXT, "
        "encoded_message_definition TEXT)");
    database.run("INSERT INTO message_definitions VALUES(1, 'std_msgs/msg/Int32', 'ros2msg', 'int16 other')");
    database.add_topic(1, "/count", "std_msgs/msg/Int32");
    database.add_message(1, 1, CdrBytes().number(std::int16_t{7}).str());
  }
  CHECK(read(path).find("/count")->find("other")->values == std::vector<double>{7});
}

TEST_CASE("Messages and files of a db3 that rosbag2 compressed are unpacked") {
  const TemporaryFolder folder("db3");
  write_count(folder.path() / "by_message.db3", {1, 2}, true);
  CHECK(counts(read(folder.path() / "by_message.db3")) == std::vector<double>{1, 2});
  write(folder.path() / "by_file.db3.zstd", compressed("zstd", bytes_of(folder.path() / "by_message.db3")));
  const Recording recording = read(folder.path() / "by_file.db3.zstd");
  CHECK(counts(recording) == std::vector<double>{1, 2});
  CHECK(recording.format == "ROS 2 bag (SQLite, zstd)");
}

TEST_CASE("A db3 that was cut short gives what is before the cut, and other SQLite files are refused") {
  const TemporaryFolder folder("db3");
  std::vector<int> values;
  for (int i = 0; i < 2000; ++i) values.push_back(i);
  const fs::path path = folder.path() / "a.db3";
  write_count(path, {values.begin(), values.end()});
  fs::resize_file(path, fs::file_size(path) / 2);
  const auto recording = open_recording(path);
  if (recording) {
    CHECK(counts(*recording).size() < 2000);
    CHECK(recording->remarks.size() == 1);
  } else {
    CHECK_THAT(recording.error(), ContainsSubstring("damaged"));
  }
  Database(folder.path() / "other.db3").run("CREATE TABLE contacts(name TEXT)");
  CHECK_THAT(open_recording(folder.path() / "other.db3").error(), ContainsSubstring("lacks the tables"));
}

TEST_CASE("A view in the place of the messages, which could go on for ever, is refused") {
  const TemporaryFolder folder("db3");
  const fs::path path = folder.path() / "a.db3";
  {
    Database database(path);
    database.run(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT)");
    database.run(
        "CREATE VIEW messages AS WITH RECURSIVE c(topic_id, timestamp, data) AS (SELECT 1, 1, 'x' UNION ALL "
        "SELECT 1, timestamp + 1, 'x' FROM c) SELECT * FROM c");
  }
  CHECK_THAT(open_recording(path).error(), ContainsSubstring("lacks the tables"));
}

TEST_CASE("A log that a killed recorder left beside a db3 is named") {
  const TemporaryFolder folder("db3");
  write_count(folder.path() / "a.db3", {1});
  write(folder.path() / "a.db3-wal", "rows");
  const Recording recording = read(folder.path() / "a.db3");
  CHECK(counts(recording) == std::vector<double>{1});
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("a.db3-wal"));
}

TEST_CASE("The files of a bag folder are one recording, in the order of its metadata.yaml") {
  const TemporaryFolder folder("bag");
  write_count(folder.path() / "a_0.db3", {1, 2});
  write_count(folder.path() / "a_10.db3", {3});
  write(folder.path() / "metadata.yaml",
        "rosbag2_bagfile_information:\n  version: 4\n  relative_file_paths:\n    - a_0.db3\n    - a_10.db3\n "
        "   - bag/gone.db3\n");
  const Recording recording = read(folder.path());
  CHECK(counts(recording) == std::vector<double>{1, 2, 3});
  CHECK(recording.format == "ROS 2 bag (SQLite, 2 files)");
  REQUIRE(recording.remarks.size() == 1);
  CHECK_THAT(recording.remarks[0], ContainsSubstring("bag/gone.db3"));
  CHECK(counts(read(folder.path() / "a_10.db3")) == std::vector<double>{3});
}

TEST_CASE(
    "A bag folder without metadata.yaml is read in the order of its parts, one of several bags refused") {
  const TemporaryFolder folder("bag");
  for (const int part : {2, 10, 1})
    write_count(folder.path() / ("a_" + std::to_string(part) + ".db3"), {part});
  CHECK(counts(read(folder.path())) == std::vector<double>{1, 2, 10});
  write_count(folder.path() / "b.db3", {1});
  CHECK_THAT(open_recording(folder.path()).error(), ContainsSubstring("several bags"));
  const TemporaryFolder empty("bag");
  CHECK_THAT(open_recording(empty.path()).error(), ContainsSubstring("without a bag"));
}
