// SPDX-License-Identifier: Apache-2.0
// HubSecret: the key with which a hub signs its tokens. It is generated once and stored in a file
// that only its owner may read. Hubs that accept each other's tokens share it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "roomcast/core/result.h"

namespace roomcast::hub {

using HubSecret = std::array<std::uint8_t, 32>;

/// A new random secret.
[[nodiscard]] HubSecret make_hub_secret();

/// The path of the secret in a hub's data folder.
[[nodiscard]] std::filesystem::path secret_file_in(const std::filesystem::path& folder);

/// The error that find_hub_secret() would return for an existing file; ok if there is no file.
/// Writes nothing.
[[nodiscard]] Status check_hub_secret(const std::filesystem::path& file);

/// Reads the secret in `file`; if there is no file, generates a secret and writes it. kUnavailable:
/// cannot be written or read. kMalformed: not a secret. kInvalidArgument: others may read it.
[[nodiscard]] Result<HubSecret> find_hub_secret(const std::filesystem::path& file);

}  // namespace roomcast::hub
