// An SQLite file that somebody else made, opened for reading without trust.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace wheelwright::import::ros {

// A query on the way through its rows. The views that it gives are valid until the next row.
class Query {
 public:
  explicit Query(sqlite3_stmt* statement) : statement_(statement) {}
  bool next_row() {
    status_ = statement_ ? sqlite3_step(statement_.get()) : SQLITE_ERROR;
    return status_ == SQLITE_ROW;
  }
  bool has_ended() const { return status_ == SQLITE_DONE; }  // else a fault has stopped it
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string_view bytes(int column) const {
    const auto* data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return data == nullptr ? std::string_view() : std::string_view(data, static_cast<std::size_t>(size));
  }

 private:
  struct Finish {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  std::unique_ptr<sqlite3_stmt, Finish> statement_;
  int status_ = SQLITE_OK;
};

class Database {
 public:
  // Or why it cannot be opened.
  static tl::expected<Database, std::string> open(const std::filesystem::path& path);

  // Not valid where the database lacks what the query names.
  Query query(const std::string& text);
  // A table of that name that holds its rows itself. A view or a virtual table could go on for ever.
  bool has_table(std::string_view name);
  std::string fault() const { return sqlite3_errmsg(handle_.get()); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close(handle); }
  };
  explicit Database(sqlite3* handle) : handle_(handle) {}
  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace wheelwright::import::ros
