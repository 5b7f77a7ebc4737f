// SPDX-License-Identifier: Apache-2.0
// Names of topics: "/camera/depth/image_raw". Thread-safe (no state).
#pragma once

#include <cstddef>
#include <string>

namespace roomcast::recording {

/// How many of their parts, from the beginning, are the same: 1 for "/camera/depth" and
/// "/camera/color".
[[nodiscard]] std::size_t common_topic_parts(const std::string& a, const std::string& b);

/// The topic up to its last slash: "/camera" of "/camera/depth".
[[nodiscard]] std::string topic_above(const std::string& topic);

}  // namespace roomcast::recording
