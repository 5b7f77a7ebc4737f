// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/mark_store.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/hub/store/hub_store.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

pb::Mark note(std::uint32_t id, const std::string& text) {
  pb::Mark mark;
  mark.set_id(id);
  mark.set_kind(pb::MARK_KIND_NOTE);
  for (const float metres : {1.f, 0.5f, -2.f}) mark.add_points(metres);
  mark.set_text(text);
  mark.set_author("Ada");
  mark.set_author_tag(~0ull);
  return mark;
}

TEST(MarkStore, keeps_the_marks_of_each_room_across_a_restart) {
  const TemporaryFolder folder;
  {
    auto store = *HubStore::open(folder.path());
    const std::vector<pb::Mark> lab = {note(1, "one"), note(2, "two"), note(3, "three")};
    ASSERT_TRUE(store->marks().save("lab", lab, {}));
    ASSERT_TRUE(store->marks().save("cellar", std::vector{note(1, "cold")}, {}));
    ASSERT_TRUE(store->marks().save("lab", {}, std::vector<std::uint32_t>{2, 77}));
  }
  auto store = *HubStore::open(folder.path());
  const auto lab = store->marks().load("lab");
  ASSERT_TRUE(lab);
  ASSERT_EQ(lab->size(), 2u);
  EXPECT_EQ((*lab)[0].SerializeAsString(), note(1, "one").SerializeAsString());
  EXPECT_EQ((*lab)[1].text(), "three");
  EXPECT_EQ(store->marks().load("cellar")->size(), 1u);
}

TEST(MarkStore, forgets_the_marks_of_a_room_that_is_closed_and_of_no_other) {
  auto store = *HubStore::open(std::nullopt);
  ASSERT_TRUE(store->marks().save("lab", std::vector{note(1, "one")}, {}));
  ASSERT_TRUE(store->marks().save("cellar", std::vector{note(1, "cold")}, {}));
  ASSERT_TRUE(store->forget_room("lab"));
  EXPECT_TRUE(store->marks().load("lab")->empty());
  EXPECT_EQ(store->marks().load("cellar")->size(), 1u);
}

TEST(MarkStore, leaves_out_what_is_no_mark) {
  const TemporaryFolder folder;
  auto store = *HubStore::open(folder.path());
  pb::Mark endless = note(2, "");
  ASSERT_TRUE(store->marks().save("lab", std::vector{note(1, "one"), endless}, {}));
  auto database = *Database::open(folder.path() / "hub.sqlite");
  ASSERT_TRUE(database->run("INSERT INTO marks VALUES ('lab', 3, x'ffff')"));
  const auto marks = store->marks().load("lab");
  ASSERT_TRUE(marks);
  ASSERT_EQ(marks->size(), 1u);
  EXPECT_EQ((*marks)[0].text(), "one");
}

}  // namespace
}  // namespace roomcast::hub
