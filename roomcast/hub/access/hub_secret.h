// SPDX-License-Identifier: Apache-2.0
// HubSecret: with which a hub signs its tokens. Made once, kept in a file that only its owner may
// read. Hubs that are to take each other's tokens share it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "roomcast/core/result.h"

namespace roomcast::hub {

using HubSecret = std::array<std::uint8_t, 32>;

/// Nobody can guess it.
[[nodiscard]] HubSecret make_hub_secret();

/// Where a hub keeps it in its folder.
[[nodiscard]] std::filesystem::path secret_file_in(const std::filesystem::path& folder);

/// Why find_hub_secret() could not take what is there; fine where there is nothing. Makes none.
[[nodiscard]] Status check_hub_secret(const std::filesystem::path& file);

/// What `file` holds; a new one, and the file with it, where there is none. kUnavailable: it cannot
/// be written or read. kMalformed: it is none. kInvalidArgument: others may read it.
[[nodiscard]] Result<HubSecret> find_hub_secret(const std::filesystem::path& file);

}  // namespace roomcast::hub
