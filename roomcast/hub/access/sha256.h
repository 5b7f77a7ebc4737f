// SPDX-License-Identifier: Apache-2.0
// SHA-256 (FIPS 180-4), by OpenSSL. Thread-safe (no state).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <openssl/evp.h>

#include "roomcast/core/assert.h"

namespace roomcast::hub {

using Sha256 = std::array<std::uint8_t, 32>;

[[nodiscard]] inline Sha256 sha256_of(std::string_view bytes) {
  Sha256 digest{};
  unsigned int size = 0;
  const int done =
      EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  ROOMCAST_ASSERT(done == 1 && size == digest.size());
  return digest;
}

}  // namespace roomcast::hub
