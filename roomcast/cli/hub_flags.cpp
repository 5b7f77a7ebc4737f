// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/hub_flags.h"

#include <nlohmann/json.hpp>

#include "roomcast/cli/number_option.h"

namespace roomcast::cli {
namespace {

void add_running_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--config", flags.config_file,
                     "Configuration file, see docs/guides/hub.md; flags override it");
  command.add_flag("--check", flags.check, "Check the configuration and end");
  command.add_option("--listen", flags.listen,
                     "ADDRESS:PORT; port 0 takes any free one (default: 127.0.0.1:7600)");
  command
      .add_option("--threads", flags.threads,
                  "Threads that share the connections (default: one per core)")
      ->check(within(1, 64));
  command.add_option("--web", flags.web,
                     "Folder of the built page (default: the one beside this program)");
  command.add_option("--data", flags.data,
                     "Folder of the hub's database and keys (default: ~/.local/state/roomcast)");
  command.add_option("--log", flags.log, "Log format on stderr: text or json")
      ->check(CLI::IsMember({"text", "json"}));
  command.add_flag("--verbose", flags.verbose, "Log joins and leaves");
}

void add_encryption_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--tls-cert", flags.tls_cert, "PEM file: the certificate, then its issuers");
  command.add_option("--tls-key", flags.tls_key, "PEM file: its private key");
  command.add_flag(
      "--tls-self-signed", flags.self_signed,
      "Encrypt with a self-signed certificate, made once and kept (default beyond this machine)");
  command.add_flag("--insecure", flags.insecure,
                   "Allow listening beyond this machine without encryption");
}

void add_room_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--room", flags.room, "The only room's name (default: room)");
  command
      .add_option("--access", flags.access,
                  "Who may join rooms without a rule of their own: anyone, token (default: anyone "
                  "on this machine, from elsewhere clients with a token)")
      ->check(CLI::IsMember({"anyone", "token", "auto"}));
  command.add_flag("--no-align", flags.no_align,
                   "Do not align sensors; use only the poses that they supply");
  command.add_flag("--no-model", flags.no_model,
                   "Do not keep a model of what stands still in the rooms");
  command.add_option("--recordings", flags.recordings,
                     "Folder for recordings by admins (default: recordings, in that of --data)");
  command.add_option("--study", flags.study,
                     "Run the study of this plan (roomcast study --help); open ?study=1");
  command.add_option("--study-folder", flags.study_folder,
                     "Folder for its sessions (default: study-NAME, in that of --data)");
  command.add_flag("--record", flags.record, "Record every room from its first sensor on");
}

void add_other_hub_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--upstream", flags.upstream,
                     "Relay the rooms of the same names from the hub at this address; of several, "
                     "the one that answers first");
  command.add_option("--upstream-token-file", flags.upstream_token_file,
                     "File with a token of those hubs, for role hub");
  command.add_option("--public-url", flags.public_url,
                     "Address of this hub for sensors, viewers and pages; other hubs give it to "
                     "their clients as an alternative");
}

void add_nats_flags(CLI::App& command, HubFlags& flags) {
  command
      .add_option("--nats", flags.nats,
                  "Share the rooms with all hubs at these NATS servers: nats://HOST:4222, "
                  "tls://HOST:4222; the first that answers is used")
      ->delimiter(',');
  command.add_option("--nats-credentials", flags.nats_credentials,
                     "File (.creds) with this hub's credentials for NATS");
  command.add_option(
      "--nats-ca", flags.nats_ca,
      "PEM file: issuers of the NATS servers' certificates (default: those of the system)");
  command.add_option("--nats-cert", flags.nats_cert,
                     "PEM file: this hub's certificate, if NATS requires one");
  command.add_option("--nats-key", flags.nats_key, "PEM file: its private key");
}

}  // namespace

void add_hub_flags(CLI::App& command, HubFlags& flags) {
  add_running_flags(command, flags);
  add_encryption_flags(command, flags);
  add_room_flags(command, flags);
  add_other_hub_flags(command, flags);
  add_nats_flags(command, flags);
}

hub::HubConfig with_flags(hub::HubConfig config, const HubFlags& flags) {
  const auto take = [](const std::string& said, std::string& field) {
    if (!said.empty()) field = said;
  };
  take(flags.listen, config.listen);
  take(flags.web, config.web);
  take(flags.tls_cert, config.tls_cert);
  take(flags.tls_key, config.tls_key);
  take(flags.data, config.data);
  take(flags.access, config.access);
  take(flags.log, config.log);
  take(flags.recordings, config.recordings);
  take(flags.study, config.study);
  take(flags.study_folder, config.study_folder);
  config.record |= flags.record;
  take(flags.upstream_token_file, config.upstream_token_file);
  take(flags.public_url, config.public_url);
  take(flags.nats_credentials, config.nats_credentials);
  take(flags.nats_ca, config.nats_ca);
  take(flags.nats_cert, config.nats_cert);
  take(flags.nats_key, config.nats_key);
  if (!flags.nats.empty()) config.nats_servers = flags.nats;
  if (!flags.upstream.empty()) config.upstream_hubs = flags.upstream;
  if (!flags.room.empty()) config.rooms = {nlohmann::json{{"name", flags.room}}.dump()};
  if (flags.threads > 0) config.threads = flags.threads;
  config.tls_self_signed |= flags.self_signed;
  config.insecure |= flags.insecure;
  // With upstream hubs, these place the sensors.
  config.align &= !flags.no_align && config.upstream_hubs.empty();
  config.model &= !flags.no_model;
  return config;
}

}  // namespace roomcast::cli
