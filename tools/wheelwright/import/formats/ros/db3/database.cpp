#include "tools/wheelwright/import/formats/ros/db3/database.hpp"

namespace wheelwright::import::ros {
namespace {

constexpr int max_value_bytes = 512 << 20;

// The name of a file as SQLite's URI has it.
std::string as_uri(const std::filesystem::path& path) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '?' || c == '#' || c == '%') {
      uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

}  // namespace

tl::expected<Database, std::string> Database::open(const std::filesystem::path& path) {
  sqlite3* handle = nullptr;
  const int status =
      sqlite3_open_v2(as_uri(path).c_str(), &handle, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  Database database(handle);
  if (status != SQLITE_OK) return tl::unexpected("cannot be opened: " + std::string(sqlite3_errstr(status)));
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, max_value_bytes);
  return database;
}

Query Database::query(const std::string& text) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(handle_.get(), text.c_str(), -1, &statement, nullptr);
  return Query(statement);
}

bool Database::has_table(std::string_view name) {
  Query tables = query("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = '" + std::string(name) +
                       "' AND rootpage > 0");  // a virtual table has no page
  return tables.next_row();
}

}  // namespace wheelwright::import::ros
