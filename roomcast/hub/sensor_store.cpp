// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/sensor_store.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include <sqlite3.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace {

constexpr int kWaitForOthers_ms = 500;  // several hubs may share a folder
constexpr int kVersion = 1;             // of the tables
constexpr char kSchema[] =
    "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA user_version = 1;"
    "CREATE TABLE IF NOT EXISTS sensors ("
    "  room TEXT NOT NULL, name TEXT NOT NULL, id INTEGER NOT NULL,"
    "  world_from_depth BLOB,"  // 16 little-endian doubles, row-major; null: not found yet
    "  expected_error_mm REAL,"
    "  PRIMARY KEY (room, name), UNIQUE (room, id)) STRICT;";
constexpr char kLoad[] =
    "SELECT name, id, world_from_depth, expected_error_mm FROM sensors WHERE room = ?1 ORDER BY id";
constexpr char kSave[] = "INSERT OR REPLACE INTO sensors VALUES (?1, ?2, ?3, ?4, ?5)";

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
  void bind(int index, const std::string& text) const {
    sqlite3_bind_text(statement_, index, text.data(), static_cast<int>(text.size()),
                      SQLITE_TRANSIENT);
  }
  void bind(int index, const KnownPose& pose) const {  // in two columns
    sqlite3_bind_blob(statement_, index, pose.world_from_depth.data(),
                      static_cast<int>(sizeof(pose.world_from_depth)), SQLITE_TRANSIENT);
    sqlite3_bind_double(statement_, index + 1, static_cast<double>(pose.expected_error_mm));
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
};

Error failure(sqlite3* database, const std::string& what) {
  return {ErrorCode::kUnavailable, what + ": " + sqlite3_errmsg(database)};
}

std::optional<KnownPose> read_pose(sqlite3_stmt* row, int column) {
  KnownPose pose;
  if (sqlite3_column_bytes(row, column) != static_cast<int>(sizeof(pose.world_from_depth))) {
    return std::nullopt;
  }
  std::memcpy(pose.world_from_depth.data(), sqlite3_column_blob(row, column),
              sizeof(pose.world_from_depth));
  pose.expected_error_mm = static_cast<float>(sqlite3_column_double(row, column + 1));
  const bool makes_sense =
      std::ranges::all_of(pose.world_from_depth, [](double x) { return std::isfinite(x); }) &&
      pose.expected_error_mm >= 0;
  return makes_sense ? std::optional(pose) : std::nullopt;
}

std::optional<KnownSensor> read_sensor(sqlite3_stmt* row) {
  const sqlite3_int64 id = sqlite3_column_int64(row, 1);
  if (id < 0 || id >= sqlite3_int64{wire::kMaxSensors}) return std::nullopt;
  KnownSensor sensor;
  sensor.name.assign(reinterpret_cast<const char*>(sqlite3_column_text(row, 0)),
                     static_cast<std::size_t>(sqlite3_column_bytes(row, 0)));
  sensor.id = SensorId{static_cast<std::uint16_t>(id)};
  sensor.pose = read_pose(row, 2);
  return sensor;
}

}  // namespace

Result<std::unique_ptr<SensorStore>> SensorStore::open(const std::filesystem::path& file) {
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(file.c_str(), &database);
  std::unique_ptr<SensorStore> store(new SensorStore(database));
  if (opened != SQLITE_OK) return failure(database, "cannot open " + file.string());
  sqlite3_busy_timeout(database, kWaitForOthers_ms);
  const auto unusable = [&file](const std::string& why) {
    return Error{ErrorCode::kUnavailable, file.string() + " cannot keep sensors: " + why};
  };
  const auto version = store->version();
  if (!version) return unusable(version.error().message);
  if (*version > kVersion) return unusable("a later roomcast wrote it");
  if (auto status = store->run(kSchema); !status) return unusable(status.error().message);
  return store;
}

SensorStore::~SensorStore() {
  sqlite3_close(database_);
}

Status SensorStore::run(const char* sql) {
  if (sqlite3_exec(database_, sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return Error{ErrorCode::kUnavailable, sqlite3_errmsg(database_)};
}

Result<int> SensorStore::version() const {
  const Statement statement(database_, "PRAGMA user_version");
  if (sqlite3_step(statement.get()) != SQLITE_ROW) return failure(database_, "no database");
  return sqlite3_column_int(statement.get(), 0);
}

Result<std::vector<KnownSensor>> SensorStore::load(const std::string& room) const {
  const Statement statement(database_, kLoad);
  statement.bind(1, room);
  std::vector<KnownSensor> sensors;
  int step = SQLITE_ROW;
  while ((step = sqlite3_step(statement.get())) == SQLITE_ROW) {
    if (auto sensor = read_sensor(statement.get())) sensors.push_back(*std::move(sensor));
  }
  if (step != SQLITE_DONE) return failure(database_, "cannot read the sensors that were kept");
  return sensors;
}

Status SensorStore::save(const std::string& room, std::span<const KnownSensor> sensors) {
  if (auto status = run("BEGIN"); !status) return status;
  for (const KnownSensor& sensor : sensors) {
    const Statement statement(database_, kSave);
    statement.bind(1, room);
    statement.bind(2, sensor.name);
    sqlite3_bind_int(statement.get(), 3, sensor.id.value);
    if (sensor.pose) statement.bind(4, *sensor.pose);
    if (sqlite3_step(statement.get()) == SQLITE_DONE) continue;
    const Error error = failure(database_, "cannot keep a sensor");
    (void)run("ROLLBACK");
    return error;
  }
  return run("COMMIT");
}

}  // namespace roomcast::hub
