// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/session_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/core/utc_text.h"
#include "roomcast/study/plan.h"

namespace roomcast::study {
namespace {

using Json = nlohmann::json;

constexpr double kAhead_m = 2;        // from the eye to the point looked at
constexpr double kMinSeen_s = 1;      // of a condition
constexpr double kMinStep_s = 0.001;  // between two keys

/// The point ahead: -z of the head.
PathKey key_of(const Json& pose, double time_s) {
  const double qx = pose.at("qx"), qy = pose.at("qy"), qz = pose.at("qz"), qw = pose.at("qw");
  const double at[3] = {pose.at("x"), pose.at("y"), pose.at("z")};
  const double ahead[3] = {-2 * (qx * qz + qw * qy), -2 * (qy * qz - qw * qx),
                           -(1 - 2 * (qx * qx + qy * qy))};
  PathKey key{.time_s = time_s};
  for (int i = 0; i < 3; ++i) {
    key.at_m[i] = at[i];
    key.look_m[i] = at[i] + kAhead_m * ahead[i];
  }
  return key;
}

double seconds_of(nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

/// Takes off what is not in a recording of this length.
void cut(SeenCondition& seen, double length_s) {
  const double before_s = std::max(0.0, -seen.from_s);
  seen.from_s += before_s;
  seen.to_s = std::min(seen.to_s, length_s);
  std::erase_if(seen.keys, [&](PathKey& key) {
    key.time_s -= before_s;
    return key.time_s < 0 || key.time_s > seen.to_s - seen.from_s;
  });
}

}  // namespace

Result<std::vector<SeenCondition>> seen_conditions(const StudyFolder& study,
                                                   const std::string& participant,
                                                   nanoseconds began, nanoseconds length) {
  const auto person = study.participant(participant);
  if (!person) return person.error();
  const auto log = study.log(participant);
  if (!log) return log.error();
  const auto consented = read_utc_text(person->consented_at);
  if (!consented)
    return Error{ErrorCode::kMalformed, "it is not known when " + participant + " began"};
  const auto plan = study.plan_of(*person);
  if (!plan) return plan.error();
  const double offset_s = seconds_of(*consented - began);
  std::vector<SeenCondition> seen;
  std::optional<SeenCondition> now;
  double late_s = 0;
  for (const Json& record : log->records) {
    const double time_s = record.at("t").get<double>() + offset_s - late_s;
    if (record.at("kind") == "steps" && record.at("what") == "condition") {
      const std::string name = record.at("name");
      if (record.at("begins") == true) {
        const auto condition = std::ranges::find(plan->conditions, name, &Condition::name);
        const bool is_known = condition != plan->conditions.end();
        late_s = is_known ? condition->latency_ms / 1000 : 0;
        now = SeenCondition{.name = name,
                            .from_s = record.at("t").get<double>() + offset_s - late_s,
                            .mode = is_known ? condition->mode : "",
                            .fps = is_known ? condition->fps : 0,
                            .keys = {}};
      } else if (now) {
        now->to_s = time_s;
        cut(*now, seconds_of(length));
        if (now->to_s - now->from_s >= kMinSeen_s && !now->keys.empty())
          seen.push_back(*std::move(now));
        now.reset();
        late_s = 0;
      }
    } else if (record.at("kind") == "poses" && now) {
      const double key_s = time_s - now->from_s;
      if (now->keys.empty() || key_s >= now->keys.back().time_s + kMinStep_s)
        now->keys.push_back(key_of(record, key_s));
    }
  }
  if (seen.empty())
    return Error{ErrorCode::kNotFound, "this recording has no condition of " + participant +
                                           "; record the room during the session"};
  return seen;
}

std::string path_json(const std::vector<PathKey>& keys) {
  Json list = Json::array();
  for (const auto& [time_s, at, look] : keys)
    list.push_back(
        {{"time_s", time_s}, {"at", {at[0], at[1], at[2]}}, {"look", {look[0], look[1], look[2]}}});
  return Json{{"keys", std::move(list)}}.dump() + "\n";
}

}  // namespace roomcast::study
