// SPDX-License-Identifier: Apache-2.0
// One-time codes: short enough to read out, exchanged once for a token. Four groups of four digits
// of Crockford's base 32 (80 bits), in which no letter looks like a digit. The hub stores only
// their digests. Threading: thread-safe (no state).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "roomcast/hub/access/sha256.h"

namespace roomcast::hub {

/// "7K2M-9QXA-0C4T-VW3H"
[[nodiscard]] std::string make_one_time_code();

using CodeDigest = Sha256;

/// SHA-256 of a code as typed by a person: hyphens and case are ignored, O is read as 0, I and L as
/// 1. Nothing: not a code.
[[nodiscard]] std::optional<CodeDigest> digest_of_code(std::string_view code);

/// "code-0123456789abcdef": the ID under which a code is listed and revoked. It does not reveal the
/// code.
[[nodiscard]] std::string id_of_code(const CodeDigest& digest);

/// 128 random bits in hexadecimal: a token's id.
[[nodiscard]] std::string make_token_id();

}  // namespace roomcast::hub
