// SPDX-License-Identifier: Apache-2.0
// For tests: a study of two conditions in a temporary folder.
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/study/study_folder.h"

namespace roomcast::study {

class StudyFixture : public testing::Test {
 protected:
  static constexpr nanoseconds kNow = std::chrono::seconds(1'800'000'000);

  static StudyPlan some_plan() {
    return {.name = "s",
            .consent = "We keep your answers.",
            .participants = 3,
            .conditions = {{.name = "one"}, {.name = "two"}}};
  }
  /// A study with this plan.
  StudyFolder create_from(const std::string& toml) {
    plan = read_plan(toml).plan;
    return *StudyFolder::create(path, plan, toml, std::string(64, 'b'));
  }
  StudyFolder create() {
    return *StudyFolder::create(path, plan, "name = 1", std::string(64, 'a'));
  }

  static nlohmann::json step(double t, std::size_t number, const std::string& name, bool begins) {
    return {{"kind", "steps"},     {"t", t},       {"step", number},
            {"what", "condition"}, {"name", name}, {"begins", begins}};
  }
  static nlohmann::json speech(double t, bool on) {
    return {{"kind", "speech"}, {"t", t}, {"on", on}};
  }
  static nlohmann::json answer(double t, const nlohmann::json& value) {
    return {{"kind", "answers"}, {"t", t},    {"questionnaire", "q"}, {"item", "i"},
            {"value", value},    {"at_s", 0}, {"after_s", 2.5}};
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "study";
  StudyPlan plan = some_plan();
};

}  // namespace roomcast::study
