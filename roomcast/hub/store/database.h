// SPDX-License-Identifier: Apache-2.0
// Database: a hub's persistent data in one SQLite file, or in memory when there is no file. The
// tables have a version; an older file is migrated when it is opened, a newer one is refused.
//
// A statement that succeeded survives a crash of the program and of the machine: the write-ahead
// log is synced before it is acknowledged. Threading: one thread at a time. Source: SQLite's
// documentation, "Write-Ahead Logging" and "PRAGMA synchronous".
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "roomcast/core/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace roomcast::hub {

class Database {
 public:
  static constexpr int kVersion = 5;

  /// Creates the file if it does not exist; `file` empty: in memory. kUnavailable: the file cannot
  /// be opened, is no database, or has a newer version; the sentence says which.
  static Result<std::unique_ptr<Database>> open(const std::optional<std::filesystem::path>& file);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  [[nodiscard]] Status run(const char* sql);
  /// Calls `work`; all of its changes are kept, or, if it gives an error, none of them.
  template <class Work>
  [[nodiscard]] Status in_transaction(Work work) {
    if (auto status = run("BEGIN IMMEDIATE"); !status) return status;
    Status done = work();
    if (done) done = run("COMMIT");
    if (!done) (void)run("ROLLBACK");
    return done;
  }
  /// The number of rows that the last statement changed.
  [[nodiscard]] int changed_rows() const;
  /// A number that changes whenever another program changes the file.
  [[nodiscard]] std::int64_t foreign_changes();
  [[nodiscard]] Error failure(std::string_view what) const;
  [[nodiscard]] sqlite3* native() const { return database_; }

 private:
  explicit Database(sqlite3* database) : database_(database) {}
  [[nodiscard]] Result<int> version() const;
  [[nodiscard]] Status migrate(int version);
  sqlite3* database_;
};

/// A prepared statement. Columns count from 0 and parameters from 1, as in SQLite.
class Statement {
 public:
  Statement(const Database& database, const char* sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int index, std::string_view text);
  Statement& bind(int index, std::int64_t number);
  Statement& bind(int index, double number);
  Statement& bind_blob(int index, const void* bytes, std::size_t size);

  /// Steps to the next row. False: there are no more rows, or an error occurred; see finished().
  [[nodiscard]] bool next();
  /// The last next() found the end without an error.
  [[nodiscard]] bool finished() const { return finished_; }
  /// Runs the statement to its end.
  [[nodiscard]] bool run();

  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string_view blob(int column) const;  // valid until the next row
  [[nodiscard]] bool is_null(int column) const;

 private:
  sqlite3_stmt* statement_ = nullptr;
  bool finished_ = false;
};

}  // namespace roomcast::hub
