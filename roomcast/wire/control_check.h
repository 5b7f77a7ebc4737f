// SPDX-License-Identifier: Apache-2.0
// What is legal inside control messages. Names, counts and numbers only: whether a message may be
// said at this moment is the room's business.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// kMalformed or kTooLarge with the field that is wrong.
[[nodiscard]] Status check_control(const pb::Control& control);

}  // namespace roomcast::wire
