// SPDX-License-Identifier: Apache-2.0
// Validity rules of marks and of the messages about them: docs/spec/wire.md §3 and §4.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// x, y, z of each point of a mark, in the world frame, metres.
inline constexpr int kNumbersPerPoint = 3;

/// What a hub takes. kTooLarge or kMalformed, with a sentence for people.
[[nodiscard]] Status check_mark(const pb::Mark& mark);
/// What a viewer takes: also kinds of a later version, which it does not show.
[[nodiscard]] Status check_marks(const pb::Marks& message);
[[nodiscard]] Status check_remove_marks(const pb::RemoveMarks& message);

}  // namespace roomcast::wire
