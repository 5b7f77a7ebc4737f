// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/hub_settings.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "roomcast/core/text_file.h"
#include "roomcast/hub/daemon/hub_certificate.h"
#include "roomcast/net/peer_name.h"

namespace roomcast::hub::daemon {

namespace {

constexpr std::size_t kMaxConfigBytes = 1 << 20;

hub::HubLimits limits_of(const hub::HubConfig& config) {
  hub::HubLimits limits;
  limits.max_connections = static_cast<std::size_t>(config.max_connections);
  limits.max_unjoined = static_cast<std::size_t>(config.max_unjoined);
  limits.max_unsettled_per_peer = static_cast<std::size_t>(config.max_unsettled_per_peer);
  limits.bans.faults = static_cast<std::size_t>(config.ban_after);
  limits.bans.within = std::chrono::seconds(config.ban_within_s);
  limits.bans.ban = std::chrono::seconds(config.ban_s);
  limits.proxies.clear();
  for (const std::string& proxy : config.proxies) {
    limits.proxies.push_back(net::parse_peer_name(proxy).value_or(proxy));
  }
  return limits;
}

/// With TLS any host name is allowed, because the certificate proves the hub's identity.
net::AllowedNames names_of(const hub::HubConfig& config, const std::string& listen_address,
                           bool encrypted) {
  net::AllowedNames names{
      .any_host = encrypted, .hosts = own_hosts(listen_address), .origins = config.origins};
  names.hosts.insert(names.hosts.end(), config.hosts.begin(), config.hosts.end());
  return names;
}

}  // namespace

Result<hub::HubConfig> find_hub_config(const std::string& file) {
  hub::HubConfig config;
  if (!file.empty()) {
    const auto text = read_text_file(file, kMaxConfigBytes);
    if (!text) return text.error();
    auto read = hub::read_config(config, *text);
    if (!read) return Error{read.error().code, file + ": " + read.error().message};
    config = *std::move(read);
  }
  return hub::read_environment(std::move(config),
                               [](const char* name) -> const char* { return std::getenv(name); });
}

Result<bool> decide_encryption(hub::HubConfig& config, const net::ListenAddress& listen) {
  const bool has_certificate =
      config.tls_self_signed || !config.tls_cert.empty() || !config.tls_key.empty();
  if (has_certificate && config.insecure) {
    return Error{ErrorCode::kInvalidArgument, "--insecure and TLS exclude each other"};
  }
  if (has_certificate || config.insecure || listen.loopback) return has_certificate;
  config.tls_self_signed = true;
  return true;
}

std::size_t threads_of(const hub::HubConfig& config) {
  if (config.threads > 0) return static_cast<std::size_t>(config.threads);
  return std::max(1U, std::thread::hardware_concurrency());
}

Result<std::optional<hub::federation::UpstreamOptions>> upstream_of(const hub::HubConfig& config) {
  if (config.upstream_hubs.empty()) return std::optional<hub::federation::UpstreamOptions>();
  hub::federation::UpstreamOptions options;
  for (const std::string& address : config.upstream_hubs) {
    auto hub = net::parse_hub_url(address);
    if (!hub) return hub.error();
    options.hubs.push_back(*std::move(hub));
  }
  auto credential = config.upstream_token_file.empty()
                        ? Result<client::Credential>(client::Credential{})
                        : client::read_credential_file(config.upstream_token_file);
  if (!credential) return credential.error();
  options.credential = *std::move(credential);
  return std::optional(std::move(options));
}

Result<std::optional<hub::federation::ClusterOptions>> cluster_of(const hub::HubConfig& config) {
  if (config.nats_servers.empty()) return std::optional<hub::federation::ClusterOptions>();
  hub::federation::ClusterOptions options;
  options.nats = {.servers = config.nats_servers,
                  .credentials_file = config.nats_credentials,
                  .ca_file = config.nats_ca,
                  .cert_file = config.nats_cert,
                  .key_file = config.nats_key};
  if (auto status = hub::federation::check(options.nats); !status) return status.error();
  options.public_url = config.public_url;
  options.cores = static_cast<float>(threads_of(config));
  options.busy_share = static_cast<float>(config.busy_percent) / 100;
  return std::optional(std::move(options));
}

Result<hub::HubOptions> hub_options_of(const hub::HubConfig& config,
                                       const net::ListenAddress& listen, bool encrypted) {
  const bool open = config.access == "anyone" || (config.access == "auto" && listen.loopback);
  auto rooms = hub::rooms_of(config, open ? hub::AccessRule::kAnyone : hub::AccessRule::kToken);
  if (!rooms) return rooms.error();
  const bool all_listed = std::ranges::all_of(*rooms, &hub::RoomSettings::listed);
  hub::HubOptions options;
  options.address = listen.address;
  options.port = listen.port;
  options.rooms = *std::move(rooms);
  options.restores_poses = config.align;
  options.names = names_of(config, listen.address, encrypted);
  options.limits = limits_of(config);
  options.metrics_for_anyone =
      config.metrics == "anyone" || (config.metrics == "auto" && listen.loopback && all_listed);
  options.threads = threads_of(config);
  return options;
}

}  // namespace roomcast::hub::daemon
