// SPDX-License-Identifier: Apache-2.0
// The TLS certificate of a hub: the user's, a stored self-signed one, or none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/net/tls/certificate.h"

namespace roomcast::hub::daemon {

struct HubCertificateOptions {
  std::string certificate_file, key_file;  // PEM
  bool self_signed = false;
  std::string data_folder;     // for the self-signed one; empty: default_data_folder()
  std::string listen_address;  // one more address in the self-signed one
  bool only_look = false;      // create and write nothing
};

/// The names and addresses of a hub on this machine, for its certificate.
[[nodiscard]] std::vector<std::string> own_hosts(const std::string& listen_address);

/// Nothing: TLS is not requested, or there is no self-signed certificate yet and `only_look` is
/// set. A self-signed certificate is kept across restarts, so clients can pin its fingerprint.
/// kInvalidArgument: contradictory options; errors of Certificate.
[[nodiscard]] Result<std::optional<net::Certificate>> find_hub_certificate(
    const HubCertificateOptions& options);

}  // namespace roomcast::hub::daemon
