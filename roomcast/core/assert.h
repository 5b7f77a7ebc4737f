// SPDX-License-Identifier: Apache-2.0
// ROOMCAST_ASSERT checks invariants of our own code. It is never used to validate outside input.
#pragma once

namespace roomcast {

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line) noexcept;

}  // namespace roomcast

#define ROOMCAST_ASSERT(condition) \
  ((condition) ? void(0) : ::roomcast::assertion_failed(#condition, __FILE__, __LINE__))
