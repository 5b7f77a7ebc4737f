// SPDX-License-Identifier: Apache-2.0
// Reads PEM files within limits: OpenSSL itself would read a file without an end for ever, and wait
// for a pipe that nobody writes to. Threading: no state.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <openssl/types.h>

#include "roomcast/core/result.h"

namespace roomcast::net {

/// All certificates of a file, at least one. kNotFound: it cannot be read; kTooLarge: it is no file
/// of certificates; kMalformed: it has none.
[[nodiscard]] Result<std::vector<std::shared_ptr<X509>>> read_certificates(
    const std::filesystem::path& file);

/// The first private key of a file. kNotFound, kTooLarge; kMalformed: it has none without a
/// passphrase.
[[nodiscard]] Result<std::shared_ptr<EVP_PKEY>> read_private_key(const std::filesystem::path& file);

}  // namespace roomcast::net
