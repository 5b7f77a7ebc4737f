// SPDX-License-Identifier: Apache-2.0
// Encoding and decoding of control messages, with their validity rules: docs/spec/wire.md §3 and
// §4, control.proto. The result of `decode_control` has been checked: names, sizes, numbers and
// matrices can be used as they are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// The sender's role sets the size limit: messages from sensors, and from the hub to aligners, may
/// be large, because they may contain calibration bundles.
enum class Sender { kClient, kSensor, kHub, kHubToAligner };

/// Appends the whole message (preamble included) to `out`.
void encode_control(const pb::Control& control, std::vector<std::uint8_t>& out);

/// kMalformed, kTooLarge or kUnsupported, with a sentence for the sender. A message kind of a later
/// version decodes to a Control without content.
[[nodiscard]] Result<pb::Control> decode_control(std::span<const std::uint8_t> message,
                                                 Sender sender);

}  // namespace roomcast::wire
