// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/model/model_follower.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/hub/runtime/room_models.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/pieces/model_message.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

/// A model of one triangle, of version 5.
class OneTriangle final : public hub::RoomModels {
 public:
  [[nodiscard]] std::shared_ptr<const std::string> changes_after(
      const std::string& room, std::uint64_t known) const override {
    ++times_asked;
    if (room != "room" || known >= 5) return nullptr;
    model::RoomMesh mesh;
    mesh.points_m = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    mesh.colors.assign(3, {200, 100, 50});
    mesh.triangles = {{0, 2, 1}};
    const auto coded = model::encode_draco(mesh).value();
    return std::make_shared<const std::string>(model::write_model_message(
        {.is_whole = true, .version = 5, .pieces = {{{0, 0, 0}, coded.bytes}}}));
  }
  mutable std::atomic<int> times_asked = 0;
};

class ModelFollowerTest : public testing::Test {
 protected:
  static hub::HubOptions options(std::shared_ptr<OneTriangle> models) {
    hub::HubOptions options;
    options.models = std::move(models);
    return options;
  }
  std::shared_ptr<OneTriangle> models = std::make_shared<OneTriangle>();
  hub::RunningHub hub{options(models)};
};

TEST_F(ModelFollowerTest, the_model_is_fetched_and_then_nothing_is_newer) {
  const auto whole = fetch_model({hub.url()}, "room", 0, {});
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  ASSERT_TRUE(*whole);
  EXPECT_TRUE((*whole)->is_whole);
  EXPECT_EQ((*whole)->pieces.at(0).mesh.triangles.size(), 1U);
  const auto newer = fetch_model({hub.url()}, "room", (*whole)->version, {});
  ASSERT_TRUE(newer.ok()) << newer.error().message;
  EXPECT_FALSE(*newer);
}

TEST_F(ModelFollowerTest, an_unknown_room_is_an_error) {
  EXPECT_FALSE(fetch_model({hub.url()}, "no such room", 0, {}).ok());
}

TEST_F(ModelFollowerTest, waits_for_the_room_and_gives_news_once) {
  ModelFollower follower({hub.url()});
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(models->times_asked, 0);
  follower.follow("room");
  std::vector<model::DecodedModel> news;
  const auto give_up = std::chrono::steady_clock::now() + 10s;
  while (news.empty() && std::chrono::steady_clock::now() < give_up) {
    news = follower.take();
    std::this_thread::sleep_for(5ms);
  }
  ASSERT_EQ(news.size(), 1U);
  EXPECT_EQ(news[0].version, 5U);
  EXPECT_TRUE(follower.take().empty());
}

}  // namespace
}  // namespace roomcast::client
