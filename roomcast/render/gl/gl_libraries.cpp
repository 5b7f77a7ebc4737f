// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/gl/gl_libraries.h"

#include <string>

#include <dlfcn.h>

namespace roomcast::render {
namespace {

/// A library that is found stays loaded, as it would for libepoxy.
bool can_be_loaded(const char* library) {
  return ::dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr;
}

Error missing(const std::string& library) {
  return {ErrorCode::kUnavailable,
          "drawing takes OpenGL, and " + library +
              " cannot be loaded here; apt install libegl1 libgl1 libegl-mesa0 libgl1-mesa-dri"};
}

}  // namespace

Status find_gl_libraries() {
  if (!can_be_loaded("libEGL.so.1")) return missing("libEGL.so.1");
  if (!can_be_loaded("libOpenGL.so.0") && !can_be_loaded("libGL.so.1"))
    return missing("libGL.so.1");
  return {};
}

}  // namespace roomcast::render
