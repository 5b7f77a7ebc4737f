// SPDX-License-Identifier: Apache-2.0
// What `roomcast doctor` finds about the computer itself. The functions with parameters judge; the
// functions without look. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "roomcast/doctor/finding.h"

namespace roomcast::doctor {

[[nodiscard]] Finding judge_processor(unsigned cores);
[[nodiscard]] Finding judge_memory(std::uint64_t available_bytes);
/// `limit`: of open files and sockets for this user's programs; each viewer needs one.
[[nodiscard]] Finding judge_descriptors(std::uint64_t limit);
[[nodiscard]] Finding judge_clock(bool is_synchronized);
[[nodiscard]] Finding judge_disk(const std::filesystem::path& folder, std::uint64_t free_bytes);

/// MemAvailable of /proc/meminfo; nothing: the text has none.
[[nodiscard]] std::optional<std::uint64_t> available_memory_bytes(std::string_view meminfo);

[[nodiscard]] Finding check_processor();
[[nodiscard]] Finding check_memory();
[[nodiscard]] Finding check_descriptors();
/// Whether this computer's clock follows a time server, by the kernel's word.
[[nodiscard]] Finding check_clock();
/// The folder in which a hub keeps its data and recordings.
[[nodiscard]] Finding check_disk();

}  // namespace roomcast::doctor
