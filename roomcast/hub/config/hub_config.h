// SPDX-License-Identifier: Apache-2.0
// HubConfig: what `roomcast.toml` says, field by field (docs/guides/hub.md), with overrides from
// the environment: `tls.cert` is also ROOMCAST_HUB_TLS_CERT. Plain data and its readers; no file
// is opened here. Threading: no state.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/hub/config/room_settings.h"

namespace roomcast::hub {

struct HubConfig {
  std::string listen = "127.0.0.1:7600";
  std::string data;              // folder; empty: the user's own
  std::string web;               // folder of the page; empty: the one beside the program
  std::int64_t threads = 0;      // 0: one per core
  std::string recordings;        // folder; empty: below that of `data`
  bool record = false;           // every room from its first sensor on
  bool align = true;             // work out where sensors stand
  std::string log = "text";      // or "json"
  std::string metrics = "auto";  // "anyone", "token"; auto: anyone, if no room is private and the
                                 // hub serves this machine only
  std::string tls_cert, tls_key;
  bool tls_self_signed = false;
  bool insecure = false;
  std::string access = "auto";  // of rooms that say nothing else: "anyone", "token"; auto: anyone,
                                // if the hub serves this machine only
  std::vector<std::string> hosts, origins;
  std::vector<std::string> proxies = {"127.0.0.1", "::1"};
  std::int64_t max_connections = 4096;
  std::int64_t max_unjoined = 256;
  std::int64_t max_unsettled_per_peer = 64;
  std::int64_t ban_after = 10;
  std::int64_t ban_within_s = 60;
  std::int64_t ban_s = 300;
  std::int64_t busy_percent = 75;
  std::vector<std::string> upstream_hubs;  // whose rooms this hub serves on
  std::string upstream_token_file;         // for role hub
  std::string public_url;                  // how others reach this hub
  std::vector<std::string> nats_servers;   // over which it shares its rooms with other hubs
  std::string nats_credentials, nats_ca, nats_cert, nats_key;  // files
  std::vector<std::string> rooms;  // each as the JSON of RoomSettings, without what it leaves open
};

/// "tls.cert" -> "ROOMCAST_HUB_TLS_CERT"
[[nodiscard]] std::string environment_name(std::string_view field);

/// Every field's name, for documentation and tests.
[[nodiscard]] std::vector<std::string> config_fields();

/// `text` in TOML over `config`. kInvalidArgument: a field that there is not, or a value that
/// cannot be; the sentence says which, and in which line.
[[nodiscard]] Result<HubConfig> read_config(HubConfig config, std::string_view text);

/// Lists are separated by commas. `get` gives null for what is not set.
[[nodiscard]] Result<HubConfig> read_environment(
    HubConfig config, const std::function<const char*(const char* name)>& get);

/// The rooms, with what they leave open as `access` says.
[[nodiscard]] Result<std::vector<RoomSettings>> rooms_of(const HubConfig& config, Who access);

/// kInvalidArgument: a value that cannot be.
[[nodiscard]] Status check(const HubConfig& config);

}  // namespace roomcast::hub
