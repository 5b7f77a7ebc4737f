// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/database.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

namespace roomcast::hub {

namespace {

constexpr int kWaitForOthers_ms = 2000;  // `roomcast token` writes to the file of a running hub

/// The SQL that migrates the tables from each version to the next.
constexpr const char* kSteps[Database::kVersion] = {
    "CREATE TABLE IF NOT EXISTS sensors ("
    "  room TEXT NOT NULL, name TEXT NOT NULL, id INTEGER NOT NULL,"
    "  world_from_depth BLOB,"  // 16 little-endian doubles, row-major; null: none estimated
    "  expected_error_mm REAL,"
    "  PRIMARY KEY (room, name), UNIQUE (room, id)) STRICT;",

    "CREATE TABLE rooms ("
    "  name TEXT PRIMARY KEY,"
    "  settings TEXT NOT NULL) STRICT;"  // JSON, as in the admin interface
    "CREATE TABLE tokens ("
    "  id TEXT PRIMARY KEY, room TEXT NOT NULL, role TEXT NOT NULL, name TEXT NOT NULL,"
    "  issued_at INTEGER NOT NULL, expires_at INTEGER NOT NULL, revoked_at INTEGER) STRICT;"
    "CREATE TABLE codes ("
    "  digest BLOB PRIMARY KEY,"  // SHA-256: a reader of the file learns no code
    "  room TEXT NOT NULL, role TEXT NOT NULL, name TEXT NOT NULL,"
    "  token_ttl_s INTEGER NOT NULL, expires_at INTEGER NOT NULL, used_at INTEGER) STRICT;",

    "ALTER TABLE codes ADD COLUMN issued_at INTEGER NOT NULL DEFAULT 0;"
    "ALTER TABLE codes ADD COLUMN revoked_at INTEGER;"
    "UPDATE codes SET issued_at = expires_at - 3600;",  // codes were valid for one hour

    "CREATE TABLE marks ("
    "  room TEXT NOT NULL, id INTEGER NOT NULL,"
    "  mark BLOB NOT NULL,"  // a Mark of control.proto
    "  PRIMARY KEY (room, id)) STRICT;",

    // Factor on the camera's readings that the pose assumes.
    "ALTER TABLE sensors ADD COLUMN depth_scale REAL NOT NULL DEFAULT 1;",
};

/// Names of rooms and of people are nobody else's business. SQLite gives its other files (WAL,
/// shared memory) the mode of the database. If anything fails here, SQLite says what.
void keep_private(const std::filesystem::path& file) {
  constexpr mode_t kPrivateMode = 0600;
  const int made = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kPrivateMode);
  // An existing file is not opened here: closing it again would drop SQLite's locks.
  made >= 0 ? (void)::close(made) : (void)::chmod(file.c_str(), kPrivateMode);
}

}  // namespace

Result<std::unique_ptr<Database>> Database::open(const std::optional<std::filesystem::path>& file) {
  if (file) keep_private(*file);
  sqlite3* handle = nullptr;
  const std::string name = file ? file->string() : ":memory:";
  const int opened = sqlite3_open(name.c_str(), &handle);
  std::unique_ptr<Database> database(new Database(handle));
  if (opened != SQLITE_OK) return database->failure("cannot open " + name);
  sqlite3_busy_timeout(handle, kWaitForOthers_ms);
  const auto unusable = [&name](const std::string& why) {
    return Error{ErrorCode::kUnavailable, name + " cannot be used as a hub's database: " + why};
  };
  if (auto s = database->run("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;"); !s) {
    return unusable(s.error().message);
  }
  if (auto s = database->run("BEGIN IMMEDIATE"); !s) return unusable(s.error().message);
  const auto version = database->version();
  if (!version) return unusable(version.error().message);
  if (*version > kVersion) return unusable("a later roomcast wrote it");
  if (auto s = database->migrate(*version); !s) return unusable(s.error().message);
  return database;
}

Database::~Database() {
  sqlite3_close(database_);
}

Status Database::run(const char* sql) {
  if (sqlite3_exec(database_, sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return Error{ErrorCode::kUnavailable, sqlite3_errmsg(database_)};
}

int Database::changed_rows() const {
  return sqlite3_changes(database_);
}

std::int64_t Database::foreign_changes() {
  Statement statement(*this, "PRAGMA data_version");
  return statement.next() ? statement.integer(0) : 0;
}

Error Database::failure(std::string_view what) const {
  return {ErrorCode::kUnavailable, std::string(what) + ": " + sqlite3_errmsg(database_)};
}

Result<int> Database::version() const {
  Statement statement(*this, "PRAGMA user_version");
  if (!statement.next()) return failure("no database");
  return static_cast<int>(statement.integer(0));
}

/// Runs in one transaction, so that a crash leaves the old tables.
Status Database::migrate(int version) {
  for (int step = version; step < kVersion; ++step) {
    if (auto s = run(kSteps[step]); !s) return s;
  }
  const std::string mark = "PRAGMA user_version = " + std::to_string(kVersion);
  if (auto s = run(mark.c_str()); !s) return s;
  return run("COMMIT");
}

Statement::Statement(const Database& database, const char* sql) {
  sqlite3_prepare_v2(database.native(), sql, -1, &statement_, nullptr);
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

Statement& Statement::bind(int index, std::string_view text) {
  sqlite3_bind_text(statement_, index, text.data(), static_cast<int>(text.size()),
                    SQLITE_TRANSIENT);
  return *this;
}

Statement& Statement::bind(int index, std::int64_t number) {
  sqlite3_bind_int64(statement_, index, number);
  return *this;
}

Statement& Statement::bind(int index, double number) {
  sqlite3_bind_double(statement_, index, number);
  return *this;
}

Statement& Statement::bind_blob(int index, const void* bytes, std::size_t size) {
  sqlite3_bind_blob(statement_, index, bytes, static_cast<int>(size), SQLITE_TRANSIENT);
  return *this;
}

bool Statement::next() {
  const int step = sqlite3_step(statement_);
  finished_ = step == SQLITE_DONE;
  return step == SQLITE_ROW;
}

bool Statement::run() {
  while (next()) {
  }
  return finished_;
}

std::string Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return {bytes == nullptr ? "" : bytes,
          static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_, column);
}

std::string_view Statement::blob(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

}  // namespace roomcast::hub
