// SPDX-License-Identifier: Apache-2.0
// Bytes as text. Source: RFC 4648 section 4, by OpenSSL.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace roomcast::net {

/// With padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace roomcast::net
