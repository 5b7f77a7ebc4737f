// SPDX-License-Identifier: Apache-2.0
// HubConfig: the fields of `roomcast.toml` (docs/guides/hub.md). Environment variables override
// them: `tls.cert` is also ROOMCAST_HUB_TLS_CERT. Plain data and its readers; opens no file.
// Threading: no state.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/config/room_settings.h"

namespace roomcast::hub {

/// How long the recordings of one room are kept; nothing: as `limits` says.
struct RecordingLimits {
  std::optional<std::int64_t> days, gb;
  friend bool operator==(const RecordingLimits&, const RecordingLimits&) = default;
};

struct HubConfig {
  std::string listen = "127.0.0.1:7600";
  std::string data;              // folder; empty: the user's default
  std::string web;               // folder of the page; empty: the one next to the program
  std::int64_t threads = 0;      // 0: one per core
  std::string recordings;        // folder; empty: a folder in that of `data`
  std::string study;             // plan of a study that this hub runs; empty: none
  std::string study_folder;      // of its sessions; empty: study-NAME in that of `data`
  bool record = false;           // record every room from its first sensor on
  bool align = true;             // estimate sensor poses
  bool model = true;             // keep a model of what stands still in each room
  std::string log = "text";      // or "json"
  std::string metrics = "auto";  // "anyone", "token"; auto: anyone, if no room is private and the
                                 // hub serves this machine only
  std::string tls_cert, tls_key;
  bool tls_self_signed = false;
  bool insecure = false;
  std::string access = "auto";  // of rooms without a setting: "anyone", "token"; auto: anyone, if
                                // the hub serves this machine only
  std::vector<std::string> hosts, origins;
  std::vector<std::string> proxies = {"127.0.0.1", "::1"};
  std::int64_t max_connections = 4096;
  std::int64_t max_unjoined = 256;
  std::int64_t max_unsettled_per_peer = 64;
  std::int64_t ban_after = 10;
  std::int64_t ban_within_s = 60;
  std::int64_t ban_s = 300;
  std::int64_t busy_percent = 75;
  std::int64_t recordings_days = 0;                            // of each room; 0: no limit
  std::int64_t recordings_gb = 0;                              // the same, 10^9 bytes
  std::vector<std::string> upstream_hubs;                      // hubs whose rooms this hub relays
  std::string upstream_token_file;                             // file with a token of role hub
  std::string public_url;                                      // the address for clients elsewhere
  std::vector<std::string> nats_servers;                       // for sharing rooms with other hubs
  std::string nats_credentials, nats_ca, nats_cert, nats_key;  // files
  std::vector<std::string> rooms;  // each as the JSON of RoomSettings; omitted fields have defaults
  std::map<std::string, RecordingLimits> recording_limits;  // by the room's name
};

/// "tls.cert" -> "ROOMCAST_HUB_TLS_CERT"
[[nodiscard]] std::string environment_name(std::string_view field);

/// The names of all fields, for documentation and tests.
[[nodiscard]] std::vector<std::string> config_fields();

/// Applies TOML `text` over `config`. kInvalidArgument: an unknown field or an invalid value; the
/// sentence names it and its line.
[[nodiscard]] Result<HubConfig> read_config(HubConfig config, std::string_view text);

/// Applies environment variables over `config`. Lists are separated by commas. `get` returns null
/// for a variable that is not set.
[[nodiscard]] Result<HubConfig> read_environment(
    HubConfig config, const std::function<const char*(const char* name)>& get);

/// The configured rooms. `access` is the default of permissions that a room does not set.
[[nodiscard]] Result<std::vector<RoomSettings>> rooms_of(const HubConfig& config,
                                                         AccessRule access);

/// kInvalidArgument: an invalid value.
[[nodiscard]] Status check(const HubConfig& config);

}  // namespace roomcast::hub
