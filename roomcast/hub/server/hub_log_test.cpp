// SPDX-License-Identifier: Apache-2.0
// The log of a running hub about clients that join and leave: the keys that programs read.
#include <map>
#include <mutex>

#include "roomcast/hub/server/hub_server.h"
#include "roomcast/hub/server/hub_server_fixture.h"

namespace roomcast::hub {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

/// A base class, so that it outlives the hub.
struct WithLog {
  LogSink sink() {
    return [this](LogLevel, std::string_view, LogFields about) {
      const std::lock_guard lock(mutex);
      Fields& fields = lines.emplace_back();
      for (const auto& [key, value] : about) fields.emplace(key, value);
    };
  }
  /// The newest line with this event; nothing: none yet.
  std::optional<Fields> last(std::string_view event) {
    const std::lock_guard lock(mutex);
    std::optional<Fields> found;
    for (const Fields& fields : lines) {
      const auto entry = fields.find("event");
      if (entry != fields.end() && entry->second == event) found = fields;
    }
    return found;
  }

  std::mutex mutex;
  std::vector<Fields> lines;
};

class HubLogTest : protected WithLog, public HubServerTest {
 protected:
  HubLogTest()
      : HubServerTest({.rooms = {{.name = "lab", .view = AccessRule::kToken}, {.name = "open"}},
                       .log = sink()}) {}

  static pb::Control in_room(pb::Control join, const std::string& room) {
    join.mutable_join()->set_room(room);
    return join;
  }
  std::shared_ptr<RawClient> answered(const pb::Control& join) {
    auto client = connect(join);
    run_until([&] { return !client->received.empty(); });
    return client;
  }
  /// Waits for the line, because it is written on the hub's threads.
  Fields logged(std::string_view event) {
    const auto give_up = std::chrono::steady_clock::now() + 5s;
    std::optional<Fields> fields;
    while (!(fields = last(event)) && std::chrono::steady_clock::now() < give_up) {
      io.run_for(1ms);
      io.restart();
    }
    EXPECT_TRUE(fields) << "no line of " << event;
    return fields.value_or(Fields());
  }
};

TEST_F(HubLogTest, logs_joining_and_leaving_clients) {
  auto sensor = answered(in_room(join_as_sensor("left"), "open"));
  Fields join = logged("join");
  EXPECT_EQ(join["room"], "open");
  EXPECT_EQ(join["role"], "sensor");
  EXPECT_EQ(join["name"], "left");
  EXPECT_EQ(join["peer"].find("127.0.0.1:"), 0U) << join["peer"];
  sockets.back()->close(net::close_code::kNormal, "left");
  Fields leave = logged("leave");
  EXPECT_EQ(leave["room"], "open");
  EXPECT_EQ(leave["name"], "left");
  EXPECT_EQ(leave["peer"], join["peer"]);
}

TEST_F(HubLogTest, logs_refused_clients_with_the_error_code) {
  answered(in_room(join_as_viewer(), "lab"));
  Fields refuse = logged("refuse");
  EXPECT_EQ(refuse["room"], "lab");
  EXPECT_EQ(refuse["role"], "viewer");
  EXPECT_EQ(refuse["error"], "ERROR_UNAUTHENTICATED");
}

TEST_F(HubLogTest, logs_the_token_of_a_joined_client) {
  pb::Control join = in_room(join_as_viewer(), "lab");
  join.mutable_join()->set_token(hub->own_token());
  const auto viewer = answered(join);
  ASSERT_TRUE(viewer->received.at(0).has_welcome()) << viewer->received.at(0).error().sentence();
  Fields fields = logged("join");
  EXPECT_FALSE(fields["token"].empty());
  EXPECT_EQ(hub->own_token().find(fields["token"]), std::string::npos)
      << "an ID, not the token itself";
}

TEST_F(HubLogTest, logs_disconnected_clients_with_the_reason) {
  answered(in_room(join_as_sensor("left"), "open"));
  answered(
      in_room(join_as_sensor("left"), "open"));  // without tokens it may replace the earlier one
  Fields away = logged("send_away");
  EXPECT_EQ(away["name"], "left");
  EXPECT_FALSE(away["error"].empty());
}

}  // namespace
}  // namespace roomcast::hub
