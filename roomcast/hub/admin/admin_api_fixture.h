// SPDX-License-Identifier: Apache-2.0
// For tests: an AdminApi with two rooms, "lab" and "cellar" (not listed), and recordings that are
// not on a disk.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_api.h"

namespace roomcast::hub {

struct Answer {
  int status = 0;
  net::HttpResponse response;
  nlohmann::json body;
  [[nodiscard]] std::string code() const { return body["error"]["code"]; }
};

/// Any file named "busy" is being recorded.
class FakeFiles final : public KeptRecordings {
 public:
  class Letters final : public net::LongBody {
   public:
    [[nodiscard]] std::uint64_t size() const override { return 7; }
    [[nodiscard]] Status read(std::uint64_t, std::span<std::uint8_t> out) const override {
      std::ranges::fill(out, 'x');
      return {};
    }
  };

  void list(RecordingScope scope, WhenKnown<RecordingList> done) override {
    RecordingList list{.recordings = {}, .left_out = 3, .unread = 1};
    for (const KeptRecording& file : files)
      if (is_in(scope, file)) list.recordings.push_back(file);
    done(list);
  }
  void about(RecordingScope scope, std::string name, WhenKnown<KeptRecording> done) override {
    const auto found = find(scope, name);
    if (!found) return done(found.error());
    done(**found);
  }
  void part(RecordingScope scope, std::string name, WantedPart wanted,
            WhenKnown<std::shared_ptr<const std::string>> done) override {
    if (const auto found = find(scope, name); !found) return done(found.error());
    constexpr std::array kKinds{"part ", "moment ", "key frame "};
    done(std::make_shared<const std::string>(kKinds[static_cast<std::size_t>(wanted.kind)] +
                                             wanted.sensor + std::to_string(wanted.number)));
  }
  void open(RecordingScope scope, std::string name,
            WhenKnown<std::shared_ptr<const net::LongBody>> done) override {
    const auto found = find(scope, name);
    if (!found) return done(found.error());
    done(std::shared_ptr<const net::LongBody>(std::make_shared<Letters>()));
  }
  void rename(RecordingScope scope, std::string name, std::string to,
              WhenKnown<KeptRecording> done) override {
    const auto found = find(scope, name);
    if (!found) return done(found.error());
    (*found)->name = to;
    done(**found);
  }
  void remove(RecordingScope scope, std::string name, std::function<void(Status)> done) override {
    if (const auto found = find(scope, name); !found) return done(found.error());
    std::erase_if(files, [&](const KeptRecording& file) { return file.name == name; });
    done({});
  }
  void settle() override {}

  std::vector<KeptRecording> files;

 private:
  static bool is_in(const RecordingScope& scope, const KeptRecording& file) {
    return file.room == scope.room || (file.room.empty() && scope.unknown_too);
  }
  Result<KeptRecording*> find(const RecordingScope& scope, const std::string& name) {
    for (KeptRecording& file : files) {
      if (file.name != name || !is_in(scope, file)) continue;
      if (name == "busy") return unavailable("it is being recorded");
      return &file;
    }
    return Error{ErrorCode::kNotFound, "no such recording"};
  }
};

/// Starts and stops at once.
class FakeRecordings final : public RoomRecordings {
 public:
  Status start(const std::string& room, const std::string& by) override {
    if (rooms[room].state == RecordingState::kOn) return busy();
    started_by = by;
    rooms[room] = {.state = RecordingState::kOn, .file = room + ".mcap", .problem = ""};
    return {};
  }
  Status stop(const std::string& room) override {
    if (rooms[room].state != RecordingState::kOn) return busy();
    rooms[room].state = RecordingState::kOff;
    return {};
  }
  [[nodiscard]] RoomRecording now(const std::string& room) const override {
    const auto found = rooms.find(room);
    return found == rooms.end() ? RoomRecording{} : found->second;
  }

  [[nodiscard]] KeptRecordings& kept() override { return files; }

  std::map<std::string, RoomRecording> rooms;
  std::string started_by;
  FakeFiles files;

 private:
  static Error busy() { return {ErrorCode::kInvalidArgument, "not now"}; }
};

/// The room "lab" has version 7 of a model.
class FakeModels final : public RoomModels {
 public:
  [[nodiscard]] std::shared_ptr<const std::string> changes_after(
      const std::string& room, std::uint64_t known) const override {
    if (room != "lab" || known >= 7) return nullptr;
    return std::make_shared<const std::string>("after " + std::to_string(known));
  }
};

class QuietConnection final : public Connection {
 public:
  using Connection::Connection;
  void accept(Role, RoomId) override {}
  void deliver(ControlFanOut&) override {}
  void disconnect(wire::pb::ErrorCode, const std::string&) override {}
};

class AdminApiTest : public testing::Test {
 protected:
  AdminApiTest() {
    registry.open({.name = "lab", .view = AccessRule::kToken}, {});
    registry.open({.name = "cellar", .listed = false, .view = AccessRule::kToken}, {});
  }

  Answer ask(const std::string& method, const std::string& path, const std::string& token = "",
             const nlohmann::json& body = nullptr) {
    net::HttpRequest request{.method = method,
                             .path = "/api/v1" + path,
                             .authorization = token.empty() ? "" : "Bearer " + token,
                             .body = body.is_null() ? "" : body.dump(),
                             .peer = "10.0.0.7"};
    std::optional<net::HttpResponse> response;
    asked->answer(request, [&](net::HttpResponse answer) { response = std::move(answer); });
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (!response && std::chrono::steady_clock::now() < give_up) {
      io.run_one_for(std::chrono::milliseconds(100));
      io.restart();
    }
    EXPECT_TRUE(response) << method << " " << path;
    const auto json =
        response->body ? nlohmann::json::parse(*response->body, nullptr, false) : nlohmann::json();
    return {response->status, *response, json};
  }

  std::string token(const std::string& room, TokenRole role) {
    const Answer made =
        ask("POST", "/tokens", hub_admin, {{"room", room}, {"role", std::string(name_of(role))}});
    return made.body.value("token", "");
  }

  boost::asio::io_context io;
  std::unique_ptr<HubStore> store = *HubStore::open(std::nullopt);
  const std::string hub_admin = store->sign_own();
  StoreWorker store_worker{std::move(store), io};
  std::vector<std::unique_ptr<Shard>> shards;
  RoomRegistry registry{
      {.hub_version = "test", .configured_rooms = {"lab"}}, io, store_worker, shards};
  FakeRecordings recordings;
  FakeModels models;
  std::map<std::string, std::string, std::less<>> logged;  // from the last line with fields
  AdminApi api{registry,
               store_worker,
               "test",
               &recordings,
               nullptr,
               &models,
               [this](LogLevel, std::string_view, LogFields fields) {
                 for (const auto& [key, value] : fields) logged[std::string(key)] = value;
               }};
  AdminApi* asked = &api;
};

}  // namespace roomcast::hub
