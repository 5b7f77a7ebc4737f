// SPDX-License-Identifier: Apache-2.0
// Makes an OpenXR structure with its type set and all other fields zero.
#pragma once

#include <openxr/openxr.h>

namespace roomcast::viewer::xr {

template <class Struct>
[[nodiscard]] Struct xr_struct(XrStructureType type) {
  Struct made{};
  made.type = type;
  return made;
}

}  // namespace roomcast::viewer::xr
