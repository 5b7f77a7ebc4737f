// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/database.h"

#include <fstream>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/store/sensor_store.h"
#include "roomcast/hub/store/token_store.h"

namespace roomcast::hub {
namespace {

void run_raw(const std::filesystem::path& file, const char* sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
}

TEST(Database, refuses_a_file_of_another_kind) {
  const TemporaryFolder folder;
  std::ofstream(folder / "hub.sqlite") << std::string(5000, 'x');
  const auto opened = Database::open(folder / "hub.sqlite");
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().message.find("hub.sqlite"), std::string::npos);
  EXPECT_FALSE(Database::open(folder.path() / "no" / "such" / "folder").ok());
}

TEST(Database, is_for_its_owner_only_also_one_that_was_not) {
  namespace fs = std::filesystem;
  constexpr fs::perms kPrivateFile = fs::perms::owner_read | fs::perms::owner_write;
  const TemporaryFolder folder;
  ASSERT_TRUE(Database::open(folder / "hub.sqlite").ok());
  EXPECT_EQ(fs::status(folder / "hub.sqlite").permissions(), kPrivateFile);
  fs::permissions(folder / "hub.sqlite", fs::perms::others_read, fs::perm_options::add);
  const auto opened = Database::open(folder / "hub.sqlite");
  ASSERT_TRUE(opened.ok());
  for (const auto& file : fs::directory_iterator(folder.path()))
    EXPECT_EQ(fs::status(file).permissions(), kPrivateFile) << file.path();
}

TEST(Database, refuses_a_file_of_a_later_version) {
  const TemporaryFolder folder;
  ASSERT_TRUE(Database::open(folder / "hub.sqlite").ok());
  run_raw(folder / "hub.sqlite", "PRAGMA user_version = 1000");
  const auto opened = Database::open(folder / "hub.sqlite");
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().message.find("later roomcast"), std::string::npos);
}

TEST(Database, migrates_a_file_of_the_first_version) {
  const TemporaryFolder folder;
  run_raw(folder / "hub.sqlite",
          "CREATE TABLE sensors (room TEXT NOT NULL, name TEXT NOT NULL, id INTEGER NOT NULL,"
          "  world_from_depth BLOB, expected_error_mm REAL,"
          "  PRIMARY KEY (room, name), UNIQUE (room, id)) STRICT;"
          "INSERT INTO sensors VALUES ('lab', 'left', 3, NULL, NULL); PRAGMA user_version = 1;");
  const auto database = Database::open(folder / "hub.sqlite");
  ASSERT_TRUE(database.ok()) << database.error().message;
  EXPECT_EQ(SensorStore(**database).load("lab")->at(0).id, SensorId{3});
  EXPECT_TRUE((*database)->run("SELECT count(*) FROM tokens").ok());
}

TEST(Database, migrates_the_issue_time_of_version_two_codes) {
  const TemporaryFolder folder;
  run_raw(folder / "hub.sqlite",
          "CREATE TABLE sensors (room TEXT NOT NULL, name TEXT NOT NULL, id INTEGER NOT NULL,"
          "  world_from_depth BLOB, expected_error_mm REAL,"
          "  PRIMARY KEY (room, name), UNIQUE (room, id)) STRICT;"
          "CREATE TABLE codes (digest BLOB PRIMARY KEY,"
          "  room TEXT NOT NULL, role TEXT NOT NULL, name TEXT NOT NULL,"
          "  token_ttl_s INTEGER NOT NULL, expires_at INTEGER NOT NULL, used_at INTEGER) STRICT;"
          "CREATE TABLE tokens (id TEXT PRIMARY KEY, room TEXT NOT NULL, role TEXT NOT NULL,"
          "  name TEXT NOT NULL, issued_at INTEGER NOT NULL, expires_at INTEGER NOT NULL,"
          "  revoked_at INTEGER) STRICT;"
          "INSERT INTO codes VALUES (x'00', 'lab', 'viewer', 'Ada', 600, 10000, NULL);"
          "PRAGMA user_version = 2;");
  const auto database = Database::open(folder / "hub.sqlite");
  ASSERT_TRUE(database.ok()) << database.error().message;
  const auto issued = *TokenStore(**database).list("lab");
  ASSERT_EQ(issued.size(), 1U);
  EXPECT_EQ(issued[0].claims.issued_at, 6400);
  EXPECT_FALSE(issued[0].revoked);
}

TEST(Database, without_a_file_it_is_in_memory) {
  const auto database = Database::open(std::nullopt);
  ASSERT_TRUE(database.ok());
  EXPECT_TRUE((*database)->run("SELECT count(*) FROM rooms").ok());
}

TEST(Database, detects_changes_of_other_programs_only) {
  const TemporaryFolder folder;
  const auto database = *Database::open(folder / "hub.sqlite");
  const auto before = database->foreign_changes();
  ASSERT_TRUE(database->run("INSERT INTO rooms VALUES ('a', '{}')").ok());
  EXPECT_EQ(database->foreign_changes(), before);
  run_raw(folder / "hub.sqlite", "INSERT INTO rooms VALUES ('b', '{}')");
  EXPECT_NE(database->foreign_changes(), before);
}

TEST(Database, an_invalid_statement_fails) {
  const auto database = *Database::open(std::nullopt);
  Statement statement(*database, "SELECT nonsense FROM nowhere");
  statement.bind(1, std::string_view("x"));
  EXPECT_FALSE(statement.run());
}

}  // namespace
}  // namespace roomcast::hub
