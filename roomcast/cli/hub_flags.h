// SPDX-License-Identifier: Apache-2.0
// Command-line options of `roomcast hub`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "roomcast/hub/config/hub_config.h"

namespace roomcast::cli {

/// Values given on the command line. Precedence: command line, environment, file.
struct HubFlags {
  std::string config_file, listen, room, web, tls_cert, tls_key, data, access, log, recordings,
      study, study_folder;
  std::vector<std::string> upstream;
  std::string upstream_token_file, public_url;
  std::vector<std::string> nats;
  std::string nats_credentials, nats_ca, nats_cert, nats_key;
  std::int64_t threads = 0;
  bool self_signed = false, insecure = false, no_align = false, no_model = false, verbose = false,
       check = false;
  bool record = false;
};

/// Adds options to `command` that write into `flags`. `flags` must outlive `command`.
void add_hub_flags(CLI::App& command, HubFlags& flags);

/// Returns `config` with the values given on the command line in place of the configured ones.
[[nodiscard]] hub::HubConfig with_flags(hub::HubConfig config, const HubFlags& flags);

}  // namespace roomcast::cli
