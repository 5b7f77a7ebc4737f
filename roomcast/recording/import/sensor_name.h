// SPDX-License-Identifier: Apache-2.0
// Names of imported sensors: legal as a sensor's name and as a folder's. Thread-safe (no state).
#pragma once

#include <string>
#include <vector>

namespace roomcast::recording {

/// `wanted` (a serial number, a topic) with other characters than letters, digits, '-', '_' and '.'
/// replaced by '-'; if nothing is left, the stem of `file` in the same way, else "sensor".
[[nodiscard]] std::string sensor_name(const std::string& wanted, const std::string& file);

/// Makes every name unique: the second "a" becomes "a-2".
void make_unique(std::vector<std::string>& names);

}  // namespace roomcast::recording
