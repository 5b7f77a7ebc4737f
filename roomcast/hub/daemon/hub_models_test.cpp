// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_models.h"

#include <fstream>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::hub::daemon {
namespace {

TEST(HubModels, a_room_that_nobody_has_started_has_no_model) {
  const hub::RunningHub hub;
  OwnHub own;
  own.opened({.port = hub.port()}, hub.server().own_token());
  HubModels models(own, {}, {});
  models.start_kept();
  EXPECT_EQ(models.changes_after("room", 0), nullptr);
  models.start("room");
  models.start("room");
  EXPECT_EQ(models.changes_after("room", 0), nullptr) << "nothing was seen";
}

TEST(HubModels, what_is_on_disk_and_no_model_is_named_or_passed_over) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "my%20lab");
  std::ofstream(folder / "my%20lab/rig.json") << "{";
  std::filesystem::create_directories(folder / "not%zz");
  std::filesystem::create_directories(folder / "lab.new");
  std::vector<std::string> warnings;
  std::mutex mutex;
  {
    const hub::RunningHub hub({.rooms = {{.name = "my lab"}}});
    OwnHub own;
    own.opened({.port = hub.port()}, hub.server().own_token());
    HubModels models(own, folder.path(), [&](LogLevel, std::string_view line) {
      const std::lock_guard lock(mutex);
      warnings.emplace_back(line);
    });
    models.start_kept();
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < give_up) {
      const std::lock_guard lock(mutex);
      if (!warnings.empty()) break;
    }
    EXPECT_EQ(models.changes_after("my lab", 0), nullptr);
  }
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("my lab"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace roomcast::hub::daemon
