// SPDX-License-Identifier: Apache-2.0
// OpenXR's structures say what they are; all else in them is zero at first.
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
