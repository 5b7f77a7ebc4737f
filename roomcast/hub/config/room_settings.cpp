// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/config/room_settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/net/web_site.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<AccessRule, std::string_view>, 4> kAccessRules = {
    {{AccessRule::kAnyone, "anyone"},
     {AccessRule::kToken, "token"},
     {AccessRule::kAdmin, "admin"},
     {AccessRule::kNobody, "nobody"}}};
constexpr double kRadPerDeg = std::numbers::pi / 180;

// Readers of one value each. False: the value has another type.

bool read(const Json& json, std::string& text) {
  if (!json.is_string()) return false;
  text = json.get<std::string>();
  return true;
}

bool read(const Json& json, bool& flag) {
  if (!json.is_boolean()) return false;
  flag = json.get<bool>();
  return true;
}

bool read(const Json& json, std::size_t& count) {
  if (!json.is_number_unsigned()) return false;
  count = json.get<std::size_t>();
  return true;
}

bool read(const Json& json, double& number) {
  if (!json.is_number()) return false;
  number = json.get<double>();
  return std::isfinite(number) && std::abs(number) <= wire::kMaxPosition_m;
}

bool read(const Json& json, AccessRule& rule) {
  const auto found = json.is_string() ? access_rule_named(json.get<std::string>()) : std::nullopt;
  if (found) rule = *found;
  return found.has_value();
}

bool read(const Json& json, StartPosition& position) {
  if (!json.is_object()) return false;
  double yaw_deg = position.yaw_rad / kRadPerDeg;
  const std::map<std::string, double*> fields = {{"x", &position.x_m},
                                                 {"z", &position.z_m},
                                                 {"eye_height", &position.eye_height_m},
                                                 {"yaw_deg", &yaw_deg}};
  for (const auto& [key, value] : json.items()) {
    const auto field = fields.find(key);
    if (field == fields.end() || !read(value, *field->second)) return false;
  }
  position.yaw_rad = yaw_deg * kRadPerDeg;
  return json.contains("x") && json.contains("z");
}

bool read(const Json& json, std::vector<StartPosition>& positions) {
  if (!json.is_array() || json.size() > kMaxStartPositions) return false;
  std::vector<StartPosition> read_ones(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (!read(json[i], read_ones[i])) return false;
  }
  positions = std::move(read_ones);
  return true;
}

bool read(const Json& json, std::vector<std::string>& texts) {
  if (!json.is_array()) return false;
  std::vector<std::string> read_ones(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (!read(json[i], read_ones[i])) return false;
  }
  texts = std::move(read_ones);
  return true;
}

/// As browsers write them, each once.
Status put_in_order(std::vector<std::string>& sites) {
  if (sites.size() > kMaxEmbedSites)
    return invalid_argument("embed_from names " + std::to_string(kMaxEmbedSites) +
                            " web sites at most");
  std::vector<std::string> in_order;
  for (const std::string& text : sites) {
    auto site = net::parse_web_site(text);
    if (!site) return invalid_argument("embed_from: " + site.error().message);
    if (std::ranges::find(in_order, *site) == in_order.end()) in_order.push_back(*std::move(site));
  }
  sites = std::move(in_order);
  return {};
}

Json to_json(const StartPosition& position) {
  return {{"x", position.x_m},
          {"z", position.z_m},
          {"eye_height", position.eye_height_m},
          {"yaw_deg", position.yaw_rad / kRadPerDeg}};
}

using Reader = std::function<bool(const Json&)>;

std::map<std::string, Reader> readers_into(RoomSettings& s) {
  const auto into = [](auto& field) {
    return [&field](const Json& json) { return read(json, field); };
  };
  return {{"name", into(s.name)},
          {"title", into(s.title)},
          {"max_sensors", into(s.max_sensors)},
          {"max_viewers", into(s.max_viewers)},
          {"listed", into(s.listed)},
          {"send", into(s.send)},
          {"view", into(s.view)},
          {"record", into(s.record)},
          {"export", into(s.share)},
          {"speak", into(s.speak)},
          {"mark", into(s.mark)},
          {"record_voices", into(s.record_voices)},
          {"stream_unwatched", into(s.stream_unwatched)},
          {"uplink_mbit", into(s.uplink_mbit)},
          {"start_positions", into(s.start_positions)},
          {"embed_from", into(s.embed_from)}};
}

}  // namespace

std::string_view name_of(AccessRule rule) {
  for (const auto& [value, name] : kAccessRules) {
    if (value == rule) return name;
  }
  return "nobody";
}

std::optional<AccessRule> access_rule_named(std::string_view name) {
  for (const auto& [value, text] : kAccessRules) {
    if (text == name) return value;
  }
  return std::nullopt;
}

RigidTransform world_from_viewer(const StartPosition& position) {
  const double c = std::cos(position.yaw_rad), s = std::sin(position.yaw_rad);
  RigidTransform world_from_viewer;
  world_from_viewer.rotation << c, 0, s, 0, 1, 0, -s, 0, c;
  world_from_viewer.translation_m = {position.x_m, position.eye_height_m, position.z_m};
  return world_from_viewer;
}

Status check(const RoomSettings& settings) {
  if (settings.name.empty() || settings.name == "*") {
    return invalid_argument("a room needs a name, and \"*\" is none");
  }
  if (auto s = wire::check_name(settings.name, "room"); !s)
    return invalid_argument(s.error().message);
  if (auto s = wire::check_name(settings.title, "room"); !s)
    return invalid_argument(s.error().message);
  const auto within = [](std::size_t count, std::size_t most) {
    return count >= 1 && count <= most;
  };
  if (!within(settings.max_sensors, wire::kMaxSensors)) {
    return invalid_argument("max_sensors is 1 to " + std::to_string(wire::kMaxSensors));
  }
  if (!within(settings.max_viewers, wire::kMaxViewers)) {
    return invalid_argument("max_viewers is 1 to " + std::to_string(wire::kMaxViewers));
  }
  const double uplink = settings.uplink_mbit;
  if (uplink != 0 && !(uplink >= kMinUplink_mbit && uplink <= kMaxUplink_mbit))
    return invalid_argument("uplink_mbit is 0.1 to 1000, or 0: no limit");
  return {};
}

Json to_json(const RoomSettings& settings) {
  Json positions = Json::array();
  for (const auto& position : settings.start_positions) positions.push_back(to_json(position));
  return {{"name", settings.name},
          {"title", settings.title.empty() ? settings.name : settings.title},
          {"max_sensors", settings.max_sensors},
          {"max_viewers", settings.max_viewers},
          {"listed", settings.listed},
          {"send", name_of(settings.send)},
          {"view", name_of(settings.view)},
          {"record", name_of(settings.record)},
          {"export", name_of(settings.share)},
          {"speak", name_of(settings.speak)},
          {"mark", name_of(settings.mark)},
          {"record_voices", settings.record_voices},
          {"stream_unwatched", settings.stream_unwatched},
          {"uplink_mbit", settings.uplink_mbit},
          {"start_positions", std::move(positions)},
          {"embed_from", settings.embed_from}};
}

Result<RoomSettings> changed(RoomSettings settings, const Json& changes) {
  if (!changes.is_object()) return invalid_argument("a room's settings are an object");
  const auto readers = readers_into(settings);
  for (const auto& [key, value] : changes.items()) {
    const auto reader = readers.find(key);
    if (reader == readers.end()) return invalid_argument("a room has no setting \"" + key + "\"");
    if (!reader->second(value))
      return invalid_argument("this is no value for a room's \"" + key + "\"");
  }
  if (auto status = put_in_order(settings.embed_from); !status) return status.error();
  if (auto status = check(settings); !status) return status.error();
  return settings;
}

}  // namespace roomcast::hub
