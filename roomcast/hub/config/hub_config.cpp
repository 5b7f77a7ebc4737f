// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/config/hub_config.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>
#include <sstream>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1  // Debian's library build throws exceptions
#include <toml++/toml.h>

#include "roomcast/net/hub_url.h"
#include "roomcast/net/peer_name.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;
using Field = std::variant<std::string HubConfig::*, bool HubConfig::*, std::int64_t HubConfig::*,
                           std::vector<std::string> HubConfig::*>;

struct NamedField {
  std::string_view name;
  Field field;
};

const std::vector<NamedField>& fields() {
  static const std::vector<NamedField> all = {
      {"listen", &HubConfig::listen},
      {"data", &HubConfig::data},
      {"web", &HubConfig::web},
      {"threads", &HubConfig::threads},
      {"recordings", &HubConfig::recordings},
      {"record", &HubConfig::record},
      {"study.plan", &HubConfig::study},
      {"study.folder", &HubConfig::study_folder},
      {"align", &HubConfig::align},
      {"model", &HubConfig::model},
      {"log", &HubConfig::log},
      {"metrics", &HubConfig::metrics},
      {"tls.cert", &HubConfig::tls_cert},
      {"tls.key", &HubConfig::tls_key},
      {"tls.self_signed", &HubConfig::tls_self_signed},
      {"tls.insecure", &HubConfig::insecure},
      {"access.default", &HubConfig::access},
      {"access.hosts", &HubConfig::hosts},
      {"access.origins", &HubConfig::origins},
      {"access.proxies", &HubConfig::proxies},
      {"limits.connections", &HubConfig::max_connections},
      {"limits.unjoined", &HubConfig::max_unjoined},
      {"limits.unsettled_per_peer", &HubConfig::max_unsettled_per_peer},
      {"limits.ban_after", &HubConfig::ban_after},
      {"limits.ban_within_s", &HubConfig::ban_within_s},
      {"limits.ban_s", &HubConfig::ban_s},
      {"limits.busy_percent", &HubConfig::busy_percent},
      {"limits.recordings_days", &HubConfig::recordings_days},
      {"limits.recordings_gb", &HubConfig::recordings_gb},
      {"upstream.hubs", &HubConfig::upstream_hubs},
      {"upstream.token_file", &HubConfig::upstream_token_file},
      {"public_url", &HubConfig::public_url},
      {"nats.servers", &HubConfig::nats_servers},
      {"nats.credentials", &HubConfig::nats_credentials},
      {"nats.ca", &HubConfig::nats_ca},
      {"nats.cert", &HubConfig::nats_cert},
      {"nats.key", &HubConfig::nats_key}};
  return all;
}

const Field* find_field(std::string_view name) {
  const auto found = std::ranges::find(fields(), name, &NamedField::name);
  return found == fields().end() ? nullptr : &found->field;
}

std::string in_line(const toml::node& node) {
  return " (line " + std::to_string(node.source().begin.line) + ")";
}

// From TOML. False: the value has another type.

bool read(const toml::node& node, std::string& text) {
  const auto value = node.value_exact<std::string>();
  if (value) text = *value;
  return value.has_value();
}

bool read(const toml::node& node, bool& flag) {
  const auto value = node.value_exact<bool>();
  if (value) flag = *value;
  return value.has_value();
}

bool read(const toml::node& node, std::int64_t& number) {
  const auto value = node.value_exact<std::int64_t>();
  if (value) number = *value;
  return value.has_value();
}

bool read(const toml::node& node, std::vector<std::string>& list) {
  const toml::array* array = node.as_array();
  if (array == nullptr) return false;
  std::vector<std::string> texts(array->size());
  for (std::size_t i = 0; i < array->size(); ++i) {
    if (!read((*array)[i], texts[i])) return false;
  }
  list = std::move(texts);
  return true;
}

// From the environment.

bool read(std::string_view from, std::string& text) {
  text = from;
  return true;
}

bool read(std::string_view from, bool& flag) {
  flag = from == "true" || from == "1";
  return flag || from == "false" || from == "0";
}

bool read(std::string_view from, std::int64_t& number) {
  const auto [end, fault] = std::from_chars(from.data(), from.data() + from.size(), number);
  return fault == std::errc() && end == from.data() + from.size();
}

bool read(std::string_view from, std::vector<std::string>& list) {
  list.clear();
  std::istringstream parts{std::string(from)};
  for (std::string part; std::getline(parts, part, ',');) {
    if (!part.empty()) list.push_back(part);
  }
  return true;
}

template <class From>
bool read_into(const From& from, const Field& field, HubConfig& config) {
  return std::visit([&](auto member) { return read(from, config.*member); }, field);
}

Json as_json(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = as_json(value);
    return object;
  }
  if (const auto* array = node.as_array()) {
    Json list = Json::array();
    for (const auto& value : *array) list.push_back(as_json(value));
    return list;
  }
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto flag = node.value_exact<bool>()) return *flag;
  if (const auto number = node.value_exact<std::int64_t>()) {
    return *number < 0 ? Json(*number) : Json(static_cast<std::uint64_t>(*number));
  }
  return node.value<double>().value_or(0);
}

constexpr std::int64_t kMaxLimit = 1'000'000;

/// Takes `field` out of a room's fields.
Status take_limit(Json& room, const char* field, std::optional<std::int64_t>& limit) {
  const auto found = room.find(field);
  if (found == room.end()) return {};
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > std::uint64_t{kMaxLimit})
    return invalid_argument(std::string(field) + " of a room is 0 to " + std::to_string(kMaxLimit));
  limit = found->get<std::int64_t>();
  room.erase(found);
  return {};
}

/// What the hub alone has to know of a room; the rest are its RoomSettings.
Status take_recording_limits(Json& room, RecordingLimits& kept) {
  if (!room.is_object()) return {};
  if (auto status = take_limit(room, "recordings_days", kept.days); !status) return status;
  return take_limit(room, "recordings_gb", kept.gb);
}

Status read_rooms(const toml::node& node, HubConfig& config) {
  const toml::array* rooms = node.as_array();
  if (rooms == nullptr) return invalid_argument("rooms are written as [[room]]" + in_line(node));
  for (const auto& room : *rooms) {
    Json json = as_json(room);
    RecordingLimits kept;
    if (auto status = take_recording_limits(json, kept); !status)
      return invalid_argument(status.error().message + in_line(room));
    const auto settings = changed({}, json);
    if (!settings) return invalid_argument(settings.error().message + in_line(room));
    if (!json.contains("name")) return invalid_argument("a room needs a name" + in_line(room));
    config.rooms.push_back(json.dump());
    if (kept != RecordingLimits{}) config.recording_limits[settings->name] = kept;
  }
  return {};
}

Status read_table(const toml::table& table, const std::string& prefix, HubConfig& config) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (name == "room") {
      if (auto status = read_rooms(node, config); !status) return status;
      continue;
    }
    const Field* field = find_field(name);
    if (field == nullptr && node.is_table() && prefix.empty()) {
      if (auto status = read_table(*node.as_table(), name + ".", config); !status) return status;
      continue;
    }
    if (field == nullptr)
      return invalid_argument("there is no field \"" + name + "\"" + in_line(node));
    if (!read_into(node, *field, config)) {
      return invalid_argument("this is no value for \"" + name + "\"" + in_line(node));
    }
  }
  return {};
}

/// As in a browser's Origin header: scheme, host and port, without a path.
bool is_origin(std::string_view text) {
  const auto scheme = text.find("://");
  if (scheme != 4 && scheme != 5) return false;
  if (!text.starts_with("http://") && !text.starts_with("https://")) return false;
  const auto authority = text.substr(scheme + 3);
  return authority.find_first_of("/#") == std::string_view::npos && net::parse_hub_url(text).ok();
}

bool is_host_name(std::string_view text) {
  return text.find_first_of("/#:") == std::string_view::npos && net::parse_hub_url(text).ok();
}

Status check_names(const HubConfig& config) {
  for (const std::string& origin : config.origins) {
    if (is_origin(origin)) continue;
    return invalid_argument("access.origins: \"" + origin +
                            "\" is no web site; write https://rooms.example.org, without a path");
  }
  for (const std::string& host : config.hosts) {
    if (is_host_name(host)) continue;
    return invalid_argument("access.hosts: \"" + host +
                            "\" is no name; write hub.example.org, without a port");
  }
  for (const std::string& proxy : config.proxies) {
    if (net::parse_peer_name(proxy)) continue;
    return invalid_argument("access.proxies: \"" + proxy +
                            "\" is no numeric address; a network is written 2001:db8::/64");
  }
  if (config.public_url.empty()) return {};
  const auto url = net::parse_hub_url(config.public_url);
  return url ? Status() : invalid_argument("public_url: " + url.error().message);
}

}  // namespace

std::string environment_name(std::string_view field) {
  std::string name = "ROOMCAST_HUB_";
  for (const char c : field) {
    name += c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return name;
}

std::vector<std::string> config_fields() {
  std::vector<std::string> names;
  for (const auto& [name, field] : fields()) names.emplace_back(name);
  return names;
}

Result<HubConfig> read_config(HubConfig config, std::string_view text) {
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    return invalid_argument(std::string(parsed.error().description()) + " (line " +
                            std::to_string(parsed.error().source().begin.line) + ")");
  }
  if (auto status = read_table(parsed.table(), "", config); !status) return status.error();
  if (auto status = check(config); !status) return status.error();
  return config;
}

Result<HubConfig> read_environment(HubConfig config,
                                   const std::function<const char*(const char*)>& get) {
  for (const auto& [name, field] : fields()) {
    const std::string variable = environment_name(name);
    const char* value = get(variable.c_str());
    if (value == nullptr) continue;
    if (!read_into(std::string_view(value), field, config)) {
      return invalid_argument(variable + " cannot be \"" + value + "\"");
    }
  }
  if (auto status = check(config); !status) return status.error();
  return config;
}

Result<std::vector<RoomSettings>> rooms_of(const HubConfig& config, AccessRule access) {
  const RoomSettings open_ends{
      .send = access, .view = access, .record = access, .share = access, .mark = access};
  std::vector<RoomSettings> rooms;
  std::set<std::string> names;
  for (const std::string& text : config.rooms) {
    auto room = changed(open_ends, Json::parse(text));
    if (!room) return room.error();
    if (!names.insert(room->name).second) {
      return invalid_argument("there are two rooms \"" + room->name + "\"");
    }
    rooms.push_back(*std::move(room));
  }
  if (rooms.empty()) rooms.push_back(open_ends);
  return rooms;
}

Status check(const HubConfig& config) {
  const auto is_one_of = [](const std::string& text, std::initializer_list<const char*> words) {
    return std::ranges::find(words, text) != words.end();
  };
  if (!is_one_of(config.log, {"text", "json"}))
    return invalid_argument("log is \"text\" or \"json\"");
  if (!is_one_of(config.metrics, {"auto", "anyone", "token"})) {
    return invalid_argument("metrics is \"auto\", \"anyone\" or \"token\"");
  }
  if (!is_one_of(config.access, {"auto", "anyone", "token"})) {
    return invalid_argument("access.default is \"auto\", \"anyone\" or \"token\"");
  }
  if (!config.nats_servers.empty() && !config.upstream_hubs.empty()) {
    return invalid_argument("upstream.hubs and nats.servers exclude each other");
  }
  if (auto status = check_names(config); !status) return status;
  if (config.threads < 0 || config.threads > 64) return invalid_argument("threads is 0 to 64");
  for (const auto& [name, field] : fields()) {
    const auto* count = std::get_if<std::int64_t HubConfig::*>(&field);
    if (count == nullptr || !name.starts_with("limits.")) continue;
    const bool may_be_zero = name == "limits.ban_after" || name == "limits.busy_percent" ||
                             name.starts_with("limits.recordings_");  // off
    if (config.*(*count) < (may_be_zero ? 0 : 1) || config.*(*count) > kMaxLimit) {
      return invalid_argument(std::string(name) + " is " + (may_be_zero ? "0" : "1") + " to " +
                              std::to_string(kMaxLimit));
    }
  }
  return {};
}

}  // namespace roomcast::hub
