// SPDX-License-Identifier: Apache-2.0
// Fingerprint of a certificate: SHA-256 of its DER form, as shown by browsers and openssl. A client
// that knows a hub's fingerprint can trust its certificate without an authority.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace roomcast::net {

using Fingerprint = std::array<std::uint8_t, 32>;

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string to_string(const Fingerprint& fingerprint);
/// 64 hexadecimal digits, with or without colons between pairs; nothing for anything else.
[[nodiscard]] std::optional<Fingerprint> parse_fingerprint(std::string_view text);

}  // namespace roomcast::net
