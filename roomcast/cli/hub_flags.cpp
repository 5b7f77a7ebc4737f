// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/hub_flags.h"

#include <nlohmann/json.hpp>

namespace roomcast::cli {
namespace {

void add_running_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--config", flags.config_file,
                     "File, see docs/guides/hub.md; what is said here holds against it");
  command.add_flag("--check", flags.check, "Only say whether this configuration can be used");
  command.add_option("--listen", flags.listen,
                     "ADDRESS:PORT; port 0 takes any free one (default: 127.0.0.1:7600)");
  command
      .add_option("--threads", flags.threads,
                  "Among which connections are dealt out (default: one per core)")
      ->check(CLI::Range(1, 64));
  command.add_option("--web", flags.web,
                     "Folder of the built page (default: the one beside this program)");
  command.add_option("--data", flags.data,
                     "Folder for what the hub keeps (default: ~/.local/state/roomcast)");
  command.add_option("--log", flags.log, "text or json, on stderr")
      ->check(CLI::IsMember({"text", "json"}));
  command.add_flag("--verbose", flags.verbose, "Say who joins and leaves");
}

void add_encryption_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--tls-cert", flags.tls_cert,
                     "PEM file: the certificate, then those that sign it");
  command.add_option("--tls-key", flags.tls_key, "PEM file: its private key");
  command.add_flag("--tls-self-signed", flags.self_signed,
                   "Encrypt with a certificate that the hub makes for itself and keeps (beyond "
                   "this machine the default)");
  command.add_flag("--insecure", flags.insecure,
                   "Listen beyond this machine although nothing is encrypted");
}

void add_room_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--room", flags.room, "The only room's name (default: room)");
  command
      .add_option("--access", flags.access,
                  "Who may come into rooms that say nothing else: anyone, token (default: anyone "
                  "on this machine, from elsewhere who has a token)")
      ->check(CLI::IsMember({"anyone", "token", "auto"}));
  command.add_flag("--no-align", flags.no_align,
                   "Leave sensors where they say they are; work out nothing");
  command.add_option("--recordings", flags.recordings,
                     "Folder for rooms that admins record (default: recordings, in that of "
                     "--data)");
  command.add_flag("--record", flags.record, "Record every room from its first sensor on");
}

void add_other_hub_flags(CLI::App& command, HubFlags& flags) {
  command.add_option("--upstream", flags.upstream,
                     "Serve on what the hub at this address has in the rooms of the same names; "
                     "of several the one that answers first");
  command.add_option("--upstream-token-file", flags.upstream_token_file,
                     "File with a token of those hubs, for role hub");
  command.add_option(
      "--public-url", flags.public_url,
      "How sensors, viewers and pages reach this hub: other hubs name it to theirs, to go "
      "on at when they are gone");
}

void add_nats_flags(CLI::App& command, HubFlags& flags) {
  command
      .add_option("--nats", flags.nats,
                  "Share the rooms with all hubs at these NATS servers: nats://HOST:4222, "
                  "tls://HOST:4222; the first that answers is taken")
      ->delimiter(',');
  command.add_option("--nats-credentials", flags.nats_credentials,
                     "File (.creds) by which NATS lets this hub in");
  command.add_option("--nats-ca", flags.nats_ca,
                     "PEM file: who signs the certificates of NATS (default: as in the system)");
  command.add_option("--nats-cert", flags.nats_cert,
                     "PEM file: this hub's certificate, where NATS asks for one");
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
  return config;
}

}  // namespace roomcast::cli
