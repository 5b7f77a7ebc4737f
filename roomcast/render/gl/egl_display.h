// SPDX-License-Identifier: Apache-2.0
// Chooses where to draw without a window: a graphics card if EGL lists one, else EGL's surfaceless
// platform, where Mesa draws in software on any machine. Cards come before it because the
// surfaceless platform belongs to Mesa: beside NVIDIA's driver it would draw in software although
// there is a card. Thread-safe. Source: EGL_EXT_device_enumeration, EGL_EXT_platform_device,
// EGL_MESA_device_software, EGL_MESA_platform_surfaceless.
#pragma once

#include "roomcast/core/result.h"

namespace roomcast::render {

/// An initialized EGLDisplay whose contexts need neither surface nor config, and that offers
/// desktop OpenGL, which it has bound. It belongs to the whole process and is never terminated.
/// kUnavailable: there is none; the message says what to install. With LIBGL_ALWAYS_SOFTWARE, which
/// is Mesa's variable, in the environment the surfaceless platform is tried before the cards.
[[nodiscard]] Result<void*> display_without_window();

/// "Drawing without a window is impossible here, WHAT_FAILED, EGL's error code, what to install".
[[nodiscard]] Error no_drawing_without_window(const char* what_failed);

}  // namespace roomcast::render
