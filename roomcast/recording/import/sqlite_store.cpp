// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <utility>

#include <sqlite3.h>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/ros2_store.h"

namespace roomcast::recording {
namespace {

constexpr int kMaxMessageBytes = 256 << 20;
constexpr std::size_t kMaxRows = 8U << 20U, kMaxTopics = 65'536;

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, EndStatement>;

std::string column_text(sqlite3_stmt* statement, int column) {
  const auto* const text = sqlite3_column_text(statement, column);
  const int bytes = sqlite3_column_bytes(statement, column);
  return text == nullptr
             ? std::string()
             : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(bytes));
}

class SqliteStore final : public RosStore {
 public:
  explicit SqliteStore(Database database) : database_(std::move(database)) {}

  [[nodiscard]] Status index() {
    const Statement topics = prepared("SELECT id, name, type, serialization_format FROM topics");
    if (!topics) return not_ros();
    std::map<std::int64_t, std::uint32_t> topic_of;
    while (sqlite3_step(topics.get()) == SQLITE_ROW && topics_.size() < kMaxTopics) {
      if (column_text(topics.get(), 3) != "cdr") continue;
      topic_of[sqlite3_column_int64(topics.get(), 0)] = static_cast<std::uint32_t>(topics_.size());
      topics_.push_back({column_text(topics.get(), 1), ros1_type(column_text(topics.get(), 2))});
    }
    const Statement rows = prepared("SELECT id, topic_id, timestamp FROM messages ORDER BY id");
    if (!rows) return not_ros();
    int code = SQLITE_ROW;
    while ((code = sqlite3_step(rows.get())) == SQLITE_ROW) {
      const auto topic = topic_of.find(sqlite3_column_int64(rows.get(), 1));
      if (topic == topic_of.end()) continue;
      if (messages_.size() == kMaxRows)
        return Error{ErrorCode::kTooLarge, "it has too many messages"};
      messages_.push_back({topic->second, nanoseconds(sqlite3_column_int64(rows.get(), 2))});
      ids_.push_back(sqlite3_column_int64(rows.get(), 0));
    }
    if (code != SQLITE_DONE) damage_ = std::string("it is damaged: ") + sqlite3_errstr(code);
    if (topics_.empty()) return Error{ErrorCode::kUnsupported, "it has no messages of ROS 2 (CDR)"};
    read_ = prepared("SELECT data FROM messages WHERE id = ?1");
    return read_ ? Status() : not_ros();
  }

  [[nodiscard]] ros::Serialisation serialisation() const override {
    return ros::Serialisation::kRos2;
  }
  [[nodiscard]] const std::vector<StoredTopic>& topics() const override { return topics_; }
  [[nodiscard]] const std::vector<StoredMessage>& messages() const override { return messages_; }
  [[nodiscard]] Result<ros::ByteView> data(std::size_t message) override {
    sqlite3_reset(read_.get());
    sqlite3_bind_int64(read_.get(), 1, ids_[message]);
    if (sqlite3_step(read_.get()) != SQLITE_ROW) return malformed("a message of it is damaged");
    const void* const bytes = sqlite3_column_blob(read_.get(), 0);
    const int size = sqlite3_column_bytes(read_.get(), 0);
    return ros::ByteView(static_cast<const std::uint8_t*>(bytes), static_cast<std::size_t>(size));
  }
  [[nodiscard]] std::optional<std::string> damage() const override { return damage_; }

 private:
  static Error not_ros() { return malformed("it is not a recording of ROS 2"); }
  [[nodiscard]] Statement prepared(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr);
    return Statement(statement);
  }

  Database database_;
  std::vector<StoredTopic> topics_;
  std::vector<StoredMessage> messages_;
  std::vector<std::int64_t> ids_;
  Statement read_;
  std::optional<std::string> damage_;
};

}  // namespace

Result<std::shared_ptr<RosStore>> open_sqlite_store(const std::filesystem::path& path) {
  if (const auto file = open_file(path); !file) return file.error();
  sqlite3* raw = nullptr;
  const int code =
      sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, nullptr);
  Database database(raw);
  if (code != SQLITE_OK) return malformed(path.string() + ": it is not a recording of ROS 2");
  // The file is a stranger's: its schema may not run functions, and its values are limited.
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_limit(database.get(), SQLITE_LIMIT_LENGTH, kMaxMessageBytes);
  auto store = std::make_shared<SqliteStore>(std::move(database));
  if (Status status = store->index(); !status)
    return Error{status.error().code, path.string() + ": " + status.error().message};
  return std::shared_ptr<RosStore>(std::move(store));
}

}  // namespace roomcast::recording
