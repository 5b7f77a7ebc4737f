// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/sensor_settings_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/wire/settings_check.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;

constexpr char kAuto[] = "auto";

/// False: no such field, or no value for it.
bool read_field(const std::string& key, const Json& value, wire::pb::SettingsRequest& request) {
  wire::pb::SensorSettings& settings = *request.mutable_settings();
  if (key == "codec" && value.is_string()) {
    settings.set_codec(value.get<std::string>());
  } else if (key == "mbit" && value.is_number()) {
    settings.set_mbit(value.get<double>());
    settings.set_fits_line(false);
  } else if (key == "mbit" && value == kAuto) {
    settings.set_mbit(0);
    settings.set_fits_line(true);
  } else if (key == "fps" && value.is_number()) {
    settings.set_fps(value.get<double>());
  } else if (key == "restart" && value.is_boolean()) {
    request.set_restart(value.get<bool>());
  } else {
    return false;
  }
  return true;
}

}  // namespace

Json to_json(const wire::pb::SensorSettings& settings) {
  Json json = {{"codec", settings.codec()}, {"mbit", settings.mbit()}};
  if (settings.fits_line()) json["mbit"] = kAuto;
  if (settings.has_fps()) json["fps"] = settings.fps();
  return json;
}

Result<wire::pb::SettingsRequest> read_settings_request(const std::string& body) {
  const Error wrong = invalid_argument(
      R"(the body must have some of {"codec": "live", "mbit": 2 or "auto", "fps": 15, "restart": )"
      R"(true})");
  const Json json = Json::parse(body, nullptr, false);
  if (!json.is_object() || json.empty()) return wrong;
  wire::pb::SettingsRequest request;
  for (const auto& [key, value] : json.items()) {
    if (!read_field(key, value, request)) return wrong;
  }
  if (auto status = wire::check_settings(request.settings()); !status)
    return invalid_argument(status.error().message);
  return request;
}

std::string described(const wire::pb::SettingsRequest& request) {
  const wire::pb::SensorSettings& settings = request.settings();
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (settings.has_codec()) add("codec " + settings.codec());
  if (settings.fits_line()) {
    add("as many Mbit/s as the line carries");
  } else if (settings.has_mbit()) {
    add(settings.mbit() > 0 ? fmt::format("{:g} Mbit/s", settings.mbit()) : "no target rate");
  }
  if (settings.has_fps()) add(fmt::format("{:g} frames/s", settings.fps()));
  if (request.restart()) add("restart");
  return text;
}

}  // namespace roomcast::hub
