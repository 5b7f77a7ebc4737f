// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_study.h"

#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/file_bytes.h"

namespace roomcast::hub::daemon {
namespace {

using Json = nlohmann::json;

class HubStudyTest : public testing::Test {
 protected:
  HubStudyTest() {
    EXPECT_TRUE(io::write_file(folder / "plan.toml", study::example_plan()).ok());
    study = *HubStudy::open(folder / "plan.toml", folder / "sessions");
  }
  template <class Ask>
  Result<Json> answer(Ask ask) {
    std::promise<Result<std::string>> promise;
    ask([&promise](Result<std::string> text) { promise.set_value(std::move(text)); });
    const auto text = promise.get_future().get();
    if (!text) return text.error();
    return Json::parse(*text);
  }
  Result<Json> enroll(const std::string& plan) {
    return answer([&](auto done) { study->enroll(plan, done); });
  }
  Result<Json> resume(const StudyCaller& caller) {
    return answer([&](auto done) { study->resume(caller, done); });
  }
  Result<Json> log(const StudyCaller& caller, std::uint64_t batch, const std::string& records) {
    return answer([&](auto done) { study->log(caller, batch, records, done); });
  }
  std::string plan_id() const { return Json::parse(study->plan())["id"]; }

  TemporaryFolder folder;
  std::shared_ptr<HubStudy> study;
};

TEST_F(HubStudyTest, somebody_agrees_logs_and_goes_on_later) {
  const auto person = enroll(plan_id());
  ASSERT_TRUE(person.ok()) << person.error().message;
  EXPECT_EQ((*person)["participant"], "P001");
  EXPECT_EQ((*person)["order"], (Json{"live", "late"}));
  const StudyCaller caller{"P001", (*person)["key"]};
  ASSERT_TRUE(log(caller, 1, R"([{"kind": "speech", "t": 4, "on": true}])").ok());
  const auto later = resume(caller);
  ASSERT_TRUE(later.ok());
  EXPECT_EQ((*later)["batch"], 1);
  EXPECT_EQ((*later)["t"], 4);
  EXPECT_FALSE(later->contains("key"));
}

TEST_F(HubStudyTest, only_the_own_key_opens_a_session) {
  (void)enroll(plan_id());
  for (const StudyCaller& stranger :
       {StudyCaller{"P001", ""}, {"P001", std::string(32, 'a')}, {"P002", ""}}) {
    EXPECT_EQ(resume(stranger).error().code, ErrorCode::kNotFound);
    EXPECT_EQ(log(stranger, 1, "[]").error().code, ErrorCode::kNotFound);
  }
}

TEST_F(HubStudyTest, consent_is_to_the_plan_that_was_shown) {
  EXPECT_EQ(enroll("0123456789abcdef").error().code, ErrorCode::kInvalidArgument);
}

TEST_F(HubStudyTest, a_plan_with_a_mistake_is_no_study) {
  ASSERT_TRUE(io::write_file(folder / "wrong.toml", "[study]\n").ok());
  EXPECT_FALSE(HubStudy::open(folder / "wrong.toml", folder / "other").ok());
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

TEST_F(HubStudyTest, records_that_are_no_json_are_refused) {
  const StudyCaller caller{"P001", (*enroll(plan_id()))["key"]};
  EXPECT_EQ(log(caller, 1, "[{").error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace roomcast::hub::daemon
