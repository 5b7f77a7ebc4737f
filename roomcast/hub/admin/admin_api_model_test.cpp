// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_api_fixture.h"

namespace roomcast::hub {
namespace {

TEST_F(AdminApiTest, whoever_may_view_a_room_gets_its_model_and_then_its_changes) {
  const std::string viewer = token("lab", TokenRole::kViewer);
  const Answer whole = ask("GET", "/rooms/lab/model", viewer);
  EXPECT_EQ(whole.status, 200);
  EXPECT_EQ(*whole.response.body, "after 0");
  EXPECT_EQ(*ask("GET", "/rooms/lab/model/after/6", viewer).response.body, "after 6");
  EXPECT_EQ(ask("GET", "/rooms/lab/model/after/7", viewer).status, 204);
}

TEST_F(AdminApiTest, others_do_not_get_the_model) {
  EXPECT_EQ(ask("GET", "/rooms/lab/model").status, 403);
  EXPECT_EQ(ask("GET", "/rooms/lab/model", token("lab", TokenRole::kSensor)).status, 403);
  EXPECT_EQ(ask("GET", "/rooms/lab/model", token("cellar", TokenRole::kViewer)).status, 403);
  EXPECT_EQ(ask("GET", "/rooms/cellar/model").status, 404) << "as if it did not exist";
  EXPECT_EQ(ask("GET", "/rooms/nowhere/model", hub_admin).status, 404);
}

TEST_F(AdminApiTest, a_room_without_a_model_gives_none) {
  EXPECT_EQ(ask("GET", "/rooms/cellar/model", hub_admin).status, 204);
}

TEST_F(AdminApiTest, a_version_of_a_model_is_a_number) {
  for (const char* version : {"-1", "x", "1x", "99999999999999999999999"})
    EXPECT_EQ(ask("GET", std::string("/rooms/lab/model/after/") + version, hub_admin).status, 400);
}

}  // namespace
}  // namespace roomcast::hub
