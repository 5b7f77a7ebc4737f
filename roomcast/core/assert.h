// SPDX-License-Identifier: Apache-2.0
// ROOMCAST_ASSERT: for promises our own code makes to itself. Never used to check what comes from
// outside.
#pragma once

namespace roomcast {

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line) noexcept;

}  // namespace roomcast

#define ROOMCAST_ASSERT(condition) \
  ((condition) ? void(0) : ::roomcast::assertion_failed(#condition, __FILE__, __LINE__))
