// SPDX-License-Identifier: Apache-2.0
// Looks for the system's OpenGL libraries before the first call of EGL or OpenGL: libepoxy loads
// them then, and ends the program where there are none, as on servers and in containers.
// Thread-safe.
#pragma once

#include "roomcast/core/result.h"

namespace roomcast::render {

/// kUnavailable if EGL or OpenGL is missing; the message says what to install.
[[nodiscard]] Status find_gl_libraries();

}  // namespace roomcast::render
