// SPDX-License-Identifier: Apache-2.0
// With which certificate a hub encrypts: one of the user's, one that it makes for itself and keeps,
// or none.
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
  std::string data_folder;     // where a self-signed one is kept; empty: default_data_folder()
  std::string listen_address;  // one more address that a self-signed one is for
  bool only_look = false;      // make none, write nothing
};

/// Names and addresses under which a hub on this machine may be called.
[[nodiscard]] std::vector<std::string> own_hosts(const std::string& listen_address);

/// Nothing when TLS is not asked for, or there is no self-signed one yet and none is to be made. A
/// self-signed certificate stays the same from start to start,
/// so that whoever pinned its fingerprint finds the hub again. kInvalidArgument: options that
/// contradict each other; errors of Certificate.
[[nodiscard]] Result<std::optional<net::Certificate>> find_hub_certificate(
    const HubCertificateOptions& options);

}  // namespace roomcast::hub::daemon
