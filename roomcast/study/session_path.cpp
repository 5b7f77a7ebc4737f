// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/session_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/core/utc_text.h"
#include "roomcast/study/log_records.h"
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

/// Goes through the records of a session; times become those of the recording.
class SeenReader {
 public:
  SeenReader(const StudyPlan& plan, double offset_s, double length_s)
      : plan_(plan), offset_s_(offset_s), length_s_(length_s) {}

  void take(const Json& record) {
    const double time_s = record.at("t").get<double>() + offset_s_;
    if (const auto condition = condition_after(record))
      condition->empty() ? end(time_s) : begin(*condition, time_s);
    else if (record.at("kind") == "poses" && now_)
      look(record, time_s - late_s_ - now_->from_s);
  }
  [[nodiscard]] std::vector<SeenCondition> finish() { return std::move(seen_); }

 private:
  void begin(const std::string& name, double time_s) {
    const auto condition = std::ranges::find(plan_.conditions, name, &Condition::name);
    const bool is_known = condition != plan_.conditions.end();
    late_s_ = is_known ? condition->latency_ms / 1000 : 0;
    now_ = SeenCondition{.name = name,
                         .from_s = time_s - late_s_,
                         .mode = is_known ? condition->mode : "",
                         .fps = is_known ? condition->fps : 0,
                         .keys = {}};
  }

  void look(const Json& pose, double key_s) {
    if (now_->keys.empty() || key_s >= now_->keys.back().time_s + kMinStep_s)
      now_->keys.push_back(key_of(pose, key_s));
  }

  void end(double time_s) {
    if (!now_) return;
    now_->to_s = time_s - late_s_;
    cut(*now_, length_s_);
    if (now_->to_s - now_->from_s >= kMinSeen_s && !now_->keys.empty())
      seen_.push_back(*std::move(now_));
    now_.reset();
  }

  const StudyPlan& plan_;
  const double offset_s_, length_s_;
  std::vector<SeenCondition> seen_;
  std::optional<SeenCondition> now_;
  double late_s_ = 0;  // what the condition adds to the latency
};

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
  SeenReader reader(*plan, seconds_of(*consented - began), seconds_of(length));
  for (const Json& record : log->records) reader.take(record);
  std::vector<SeenCondition> seen = reader.finish();
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
