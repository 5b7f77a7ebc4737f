// SPDX-License-Identifier: Apache-2.0
// AuthorTag: tells which marks of a room are of the same person, without a name and without an
// account. A viewer's program makes a secret (the author key) once and gives it on joining; its tag
// is a digest, which everybody may know and nobody can turn back into the key. Another room gives
// another tag. Threading: thread-safe (no state).
#pragma once

#include <cstdint>
#include <string_view>

namespace roomcast::hub {

/// The first 64 bits of the SHA-256 of room and key; 0 without a key.
[[nodiscard]] std::uint64_t author_tag_of(std::string_view room, std::string_view author_key);

}  // namespace roomcast::hub
