// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/study_api.h"

#include <gtest/gtest.h>

#include "roomcast/hub/admin/admin_api_fixture.h"

namespace roomcast::hub {
namespace {

class FakeDesk final : public StudyDesk {
 public:
  [[nodiscard]] std::string plan() const override { return R"({"id": "p1"})"; }
  [[nodiscard]] std::string room() const override { return "lab"; }
  void enroll(std::string plan_id, WhenDone done) override {
    if (plan_id != "p1") return done(Error{ErrorCode::kInvalidArgument, "another plan"});
    if (is_full) return done(Error{ErrorCode::kUnavailable, "full"});
    done(std::string(R"({"participant": "P001"})"));
  }
  void resume(StudyCaller caller, WhenDone done) override {
    if (caller.key != "k") return done(Error{ErrorCode::kNotFound, "no such participant"});
    done(std::string(R"({"steps": 2})"));
  }
  void log(StudyCaller, std::uint64_t batch, std::string records, WhenDone done) override {
    logged += std::to_string(batch) + records;
    done(std::string("{}"));
  }
  void picture(StudyCaller caller, StudyPicture wanted,
               std::function<void(Result<PictureFile>)> done) override {
    if (caller.key != "k") return done(Error{ErrorCode::kNotFound, "no such participant"});
    done(PictureFile{"image/png", wanted.comparison + std::to_string(wanted.pair) +
                                      (wanted.is_real ? "real" : "drawn")});
  }
  void settle() override {}
  bool is_full = false;
  std::string logged;
};

class StudyApiTest : public AdminApiTest {
 protected:
  StudyApiTest() { asked = &with_study; }
  FakeDesk desk;
  std::map<std::string, std::string, std::less<>> audit;
  AdminApi with_study{registry,
                      store_worker,
                      "test",
                      &recordings,
                      &desk,
                      nullptr,
                      [this](LogLevel, std::string_view, LogFields fields) {
                        for (const auto& [key, value] : fields) audit[std::string(key)] = value;
                      }};
};

TEST_F(StudyApiTest, a_participant_agrees_and_logs_without_a_trace_of_the_address) {
  registry.change({.name = "lab"});
  EXPECT_EQ(ask("GET", "/study").body["id"], "p1");
  const Answer begun = ask("POST", "/study/participants", "", {{"agrees_to", "p1"}});
  EXPECT_EQ(begun.status, 201);
  EXPECT_EQ(begun.body["participant"], "P001");
  EXPECT_EQ(ask("POST", "/study/participants/P001/resume", "", {{"key", "k"}}).body["steps"], 2);
  EXPECT_EQ(ask("POST", "/study/participants/P001/log", "",
                {{"key", "k"}, {"batch", 3}, {"records", {1, 2}}})
                .status,
            200);
  EXPECT_EQ(desk.logged, "3[1,2]");
  EXPECT_TRUE(audit.empty());
}

TEST_F(StudyApiTest, gives_the_pictures_of_a_pair_to_participants_only) {
  registry.change({.name = "lab"});
  const auto asked_for = [&](nlohmann::json more) {
    nlohmann::json body = {{"key", "k"}, {"comparison", "c"}, {"pair", 3}, {"kind", "real"}};
    body.update(more);
    return ask("POST", "/study/participants/P001/picture", "", body);
  };
  const Answer picture = asked_for(nlohmann::json::object());
  EXPECT_EQ(picture.status, 200);
  EXPECT_EQ(picture.response.content_type, "image/png");
  EXPECT_EQ(*picture.response.body, "c3real");
  EXPECT_EQ(*asked_for({{"kind", "drawn"}}).response.body, "c3drawn");
  EXPECT_EQ(asked_for({{"key", "x"}}).status, 404);
  EXPECT_EQ(asked_for({{"kind", "other"}}).status, 400);
  EXPECT_EQ(asked_for({{"pair", -1}}).status, 400);
  EXPECT_EQ(asked_for({{"comparison", 7}}).status, 400);
}

TEST_F(StudyApiTest, where_viewing_takes_a_token_beginning_does_too) {
  const nlohmann::json agrees = {{"agrees_to", "p1"}};
  EXPECT_EQ(ask("POST", "/study/participants", "", agrees).status, 401);
  EXPECT_EQ(ask("POST", "/study/participants", token("cellar", TokenRole::kViewer), agrees).status,
            403);
  EXPECT_EQ(ask("POST", "/study/participants", token("lab", TokenRole::kViewer), agrees).status,
            201);
}

TEST_F(StudyApiTest, what_is_wrong_is_refused_with_a_sentence) {
  registry.change({.name = "lab"});
  EXPECT_EQ(ask("POST", "/study/participants", "", {{"agrees_to", "p0"}}).status, 400);
  EXPECT_EQ(ask("POST", "/study/participants").status, 400);
  EXPECT_EQ(ask("POST", "/study/participants/P001/resume", "", {{"key", "no"}}).status, 404);
  EXPECT_EQ(ask("POST", "/study/participants/P001/log", "", {{"key", "k"}}).status, 400);
  EXPECT_EQ(ask("POST", "/study/participants/P001/log", "",
                {{"key", "k"}, {"batch", -1}, {"records", nlohmann::json::array()}})
                .status,
            400);
  desk.is_full = true;
  EXPECT_EQ(ask("POST", "/study/participants", "", {{"agrees_to", "p1"}}).status, 409);
}

TEST_F(StudyApiTest, a_flood_of_participants_is_slowed_down) {
  registry.change({.name = "lab"});
  int begun = 0;
  for (int i = 0; i < 60; ++i)
    begun += ask("POST", "/study/participants", "", {{"agrees_to", "p1"}}).status == 201;
  EXPECT_GE(begun, 30);
  EXPECT_LT(begun, 60);
}

TEST_F(StudyApiTest, a_hub_without_a_study_says_so) {
  asked = &api;
  EXPECT_EQ(ask("GET", "/study").status, 404);
}

}  // namespace
}  // namespace roomcast::hub
