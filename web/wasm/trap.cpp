// SPDX-License-Identifier: Apache-2.0
// A page cannot print or exit, so a failed check in our own code stops the module with a
// WebAssembly trap.
#include "roomcast/core/assert.h"

namespace roomcast {

void assertion_failed(const char*, const char*, int) noexcept {
  __builtin_trap();
}

}  // namespace roomcast
