// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/watcher_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMinKeyBytes = 16, kMaxKeyBytes = 64;
constexpr double kLongestRecording_s = 1e7;
constexpr double kMinSpeed = 0.1, kMaxSpeed = 10;

bool read_head(const Json& json, std::array<float, 7>& head) {
  if (!json.is_array() || json.size() != head.size()) return false;
  double length = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (!json[i].is_number()) return false;
    const double value = json[i].get<double>();
    if (!(std::abs(value) <= wire::kMaxPosition_m)) return false;
    head[i] = static_cast<float>(value);
    if (i >= 3) length += value * value;
  }
  return std::abs(length - 1) < 0.01;  // a rotation
}

bool within(const Json& json, double least, double most) {
  return json.is_number() && json.get<double>() >= least && json.get<double>() <= most;
}

bool read_playing(const Json& json, Playing& playing) {
  if (!json.is_object() || json.size() != 3 || !json.contains("position_s") ||
      !json.contains("paused") || !json.contains("speed"))
    return false;
  if (!within(json["position_s"], 0, kLongestRecording_s) || !json["paused"].is_boolean() ||
      !within(json["speed"], kMinSpeed, kMaxSpeed))
    return false;
  playing = {json["position_s"].get<double>(), json["paused"].get<bool>(),
             json["speed"].get<double>()};
  return true;
}

}  // namespace

Result<WatcherState> read_watcher(const std::string& body) {
  const Error wrong = invalid_argument(
      R"(the body must be {"key": "...", "name": "...", "head": [x, y, z, qx, qy, qz, qw]} and may )"
      R"(have "viewer": 1 and "wants": {"position_s": 1, "paused": false, "speed": 1})");
  const Json json = Json::parse(body, nullptr, false);
  if (!json.is_object()) return wrong;
  WatcherState watcher;
  bool has_head = false;
  for (const auto& [field, value] : json.items()) {
    bool is_right = false;
    if (field == "key" && value.is_string()) {
      watcher.key = value.get<std::string>();
      is_right = watcher.key.size() >= kMinKeyBytes && watcher.key.size() <= kMaxKeyBytes;
    } else if (field == "name" && value.is_string()) {
      watcher.name = value.get<std::string>();
      is_right = wire::check_name(watcher.name, "viewer").ok();
    } else if (field == "viewer") {
      is_right = value.is_number_unsigned() && value <= std::numeric_limits<std::uint32_t>::max();
      if (is_right) watcher.viewer = value.get<std::uint32_t>();
    } else if (field == "head") {
      is_right = has_head = read_head(value, watcher.head);
    } else if (field == "leaves") {
      is_right = value.is_boolean();
      watcher.leaves = is_right && value.get<bool>();
    } else if (field == "wants") {
      is_right = read_playing(value, watcher.wants.emplace());
    }
    if (!is_right) return wrong;
  }
  if (watcher.key.empty() || !has_head) return wrong;
  return watcher;
}

Json watch_party_json(const WatchParties::View& view) {
  Json people = Json::array();
  for (const auto& [id, viewer, name, head] : view.others)
    people.push_back({{"id", id}, {"viewer", viewer}, {"name", name}, {"head", head}});
  return {{"people", std::move(people)},
          {"change", view.change},
          {"by", view.by},
          {"own", view.is_own},
          {"playing",
           {{"position_s", view.playing.position_s},
            {"paused", view.playing.paused},
            {"speed", view.playing.speed}}}};
}

}  // namespace roomcast::hub
