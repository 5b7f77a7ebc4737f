// SPDX-License-Identifier: Apache-2.0
// Cryptographically random bytes from the kernel, for mask keys and handshake keys (RFC 6455
// section 10.3). Threading: any thread.
#pragma once

#include <cstdint>
#include <span>

namespace roomcast::net {

void fill_with_random_bytes(std::span<std::uint8_t> bytes);

}  // namespace roomcast::net
