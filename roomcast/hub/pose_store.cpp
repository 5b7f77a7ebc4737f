// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/pose_store.h"

#include <cmath>
#include <cstring>
#include <utility>

#include <sqlite3.h>

namespace roomcast::hub {

namespace {

constexpr int kWaitForOthers_ms = 500;  // several hubs may share a folder
constexpr char kSchema[] =
    "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;"
    "CREATE TABLE IF NOT EXISTS poses ("
    "  room TEXT NOT NULL, sensor TEXT NOT NULL,"
    "  world_from_depth BLOB NOT NULL,"  // 16 little-endian doubles, row-major
    "  expected_error_mm REAL NOT NULL,"
    "  PRIMARY KEY (room, sensor)) STRICT;";
constexpr char kLoad[] =
    "SELECT sensor, world_from_depth, expected_error_mm FROM poses WHERE room = ?1 ORDER BY sensor";
constexpr char kSave[] =
    "INSERT INTO poses VALUES (?1, ?2, ?3, ?4) ON CONFLICT (room, sensor) DO UPDATE SET "
    "world_from_depth = excluded.world_from_depth, expected_error_mm = excluded.expected_error_mm";

/// A prepared statement, finalised with its owner.
class Statement {
 public:
  Statement(sqlite3* database, const char* sql) {
    sqlite3_prepare_v2(database, sql, -1, &statement_, nullptr);
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  [[nodiscard]] sqlite3_stmt* get() const { return statement_; }
  void bind(int index, const std::string& text) {
    sqlite3_bind_text(statement_, index, text.data(), static_cast<int>(text.size()),
                      SQLITE_TRANSIENT);
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
};

Error failure(sqlite3* database, const std::string& what) {
  return {ErrorCode::kUnavailable, what + ": " + sqlite3_errmsg(database)};
}

bool read_pose(sqlite3_stmt* row, KnownPose& pose) {
  pose.sensor.assign(reinterpret_cast<const char*>(sqlite3_column_text(row, 0)),
                     static_cast<std::size_t>(sqlite3_column_bytes(row, 0)));
  if (sqlite3_column_bytes(row, 1) != static_cast<int>(sizeof(pose.world_from_depth))) return false;
  std::memcpy(pose.world_from_depth.data(), sqlite3_column_blob(row, 1),
              sizeof(pose.world_from_depth));
  pose.expected_error_mm = static_cast<float>(sqlite3_column_double(row, 2));
  for (const double number : pose.world_from_depth) {
    if (!std::isfinite(number)) return false;
  }
  return pose.expected_error_mm >= 0;
}

}  // namespace

Result<std::unique_ptr<PoseStore>> PoseStore::open(const std::filesystem::path& file) {
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file.c_str(), &database);
  std::unique_ptr<PoseStore> store(new PoseStore(database));
  if (opened != SQLITE_OK) return failure(database, "cannot open " + file.string());
  sqlite3_busy_timeout(database, kWaitForOthers_ms);
  if (auto status = store->run(kSchema); !status) {
    return Error{ErrorCode::kUnavailable,
                 file.string() + " cannot keep poses: " + status.error().message};
  }
  return store;
}

PoseStore::~PoseStore() {
  sqlite3_close(database_);
}

Status PoseStore::run(const char* sql) {
  if (sqlite3_exec(database_, sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return Error{ErrorCode::kUnavailable, sqlite3_errmsg(database_)};
}

Result<std::vector<KnownPose>> PoseStore::load(const std::string& room) const {
  Statement statement(database_, kLoad);
  statement.bind(1, room);
  std::vector<KnownPose> poses;
  int step = SQLITE_ROW;
  while ((step = sqlite3_step(statement.get())) == SQLITE_ROW) {
    KnownPose pose;
    if (read_pose(statement.get(), pose)) poses.push_back(std::move(pose));
  }
  if (step != SQLITE_DONE) return failure(database_, "cannot read the poses that were kept");
  return poses;
}

Status PoseStore::save(const std::string& room, std::span<const KnownPose> poses) {
  if (auto status = run("BEGIN"); !status) return status;
  for (const KnownPose& pose : poses) {
    Statement statement(database_, kSave);
    statement.bind(1, room);
    statement.bind(2, pose.sensor);
    sqlite3_bind_blob(statement.get(), 3, pose.world_from_depth.data(),
                      static_cast<int>(sizeof(pose.world_from_depth)), SQLITE_TRANSIENT);
    sqlite3_bind_double(statement.get(), 4, static_cast<double>(pose.expected_error_mm));
    if (sqlite3_step(statement.get()) == SQLITE_DONE) continue;
    const Error error = failure(database_, "cannot keep a pose");
    (void)run("ROLLBACK");
    return error;
  }
  return run("COMMIT");
}

}  // namespace roomcast::hub
