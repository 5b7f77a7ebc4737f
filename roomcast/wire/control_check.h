// SPDX-License-Identifier: Apache-2.0
// Validity of control messages: names, counts and numbers only. The room decides whether a message
// is allowed at that moment.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

/// kMalformed or kTooLarge, naming the invalid field.
[[nodiscard]] Status check_control(const pb::Control& control);

}  // namespace roomcast::wire
